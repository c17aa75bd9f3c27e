#include "hodt/picture/svg.h"

#include <algorithm>

namespace hodt {

namespace {

bool begins_letter(char c) {
  return (static_cast<unsigned char>(c) & 0xC0) != 0x80;  // of UTF-8
}

std::size_t letters(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins_letter));
}

std::string shortened(std::string_view word, std::size_t columns) {
  if (letters(word) <= columns) return std::string(word);
  std::size_t end = 0;
  for (std::size_t count = 0; count < columns; ++end) count += begins_letter(word[end]) ? 1 : 0;
  return std::string(word.substr(0, end - 1)) + "…";
}

}  // namespace

std::vector<std::string> wrapped(std::string_view text, std::size_t columns) {
  std::vector<std::string> lines;
  std::string line;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string word = shortened(text.substr(0, end), columns);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (word.empty()) continue;
    if (!line.empty() && letters(line) + 1 + letters(word) > columns) {
      lines.push_back(line);
      line.clear();
    }
    if (!line.empty()) line += ' ';
    line += word;
  }
  if (!line.empty()) lines.push_back(line);
  return lines;
}

}  // namespace hodt
