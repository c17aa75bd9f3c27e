#include "hodt/io/obj.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/number_text.h"
#include "hodt/io/parallel_text.h"
#include "hodt/io/tin_parts.h"

namespace hodt {

namespace {

constexpr std::string_view kCrsComment = "# crs: ";

class ObjParser {
 public:
  explicit ObjParser(const InputText& input) : input_(input), p_(input.begin()) {}

  Tin parse() {
    refuse_old_mac_lines();
    for (; p_ < input_.end(); next_line()) {
      skip_blanks();
      if (starts_statement('v')) {
        parse_vertex();
      } else if (starts_statement('f')) {
        parse_face();
      } else if (*p_ == '#') {
        parse_comment();
      }
    }
    if (tin_.points.size() == 0) fail_file("holds no vertex (no v line)");
    if (tin_.triangles.empty()) fail_file("holds no triangle (no f line)");
    if (largest_corner_ > tin_.points.size()) {
      line_ = largest_corner_line_;
      fail(fmt::format("there is no vertex {}; the last is {}", largest_corner_,
                       tin_.points.size()));
    }
    return std::move(tin_);
  }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
  /// Blanks, and the line ends that a backslash takes away.
  void skip_blanks() {
    for (;;) {
      while (is_blank(*p_)) ++p_;
      const char* const next = continuation(p_);
      if (!next) return;
      p_ = next;
      ++line_;
    }
  }
  /// The next line's begin, if a backslash joins it to this one; else nullptr.
  const char* continuation(const char* p) const {
    if (*p != '\\') return nullptr;
    p += p[1] == '\r' ? 2 : 1;
    return *p == '\n' && p < input_.end() ? p + 1 : nullptr;
  }
  /// Whether a number ends here. A backslash between two digits may join them or part them.
  bool ends_word(const char* p) const {
    if (is_blank(*p) || *p == '\n') return true;
    const char* const next = continuation(p);
    return next && (is_blank(*next) || *next == '\n' || next >= input_.end());
  }
  bool at_line_end() const { return *p_ == '\n'; }
  void next_line() {
    const char* const feed = find(p_, '\n');
    p_ = feed ? feed + 1 : input_.end();
    ++line_;
  }
  /// A carriage return alone would hide the line after it in this one.
  void refuse_old_mac_lines() {
    const char* p = p_;
    while ((p = find(p, '\r'))) {
      while (*p == '\r') ++p;
      if (*p == '\n') continue;
      line_ += static_cast<std::size_t>(std::count(p_, p, '\n'));
      fail("this line ends as those of old Macs do, without a line feed; convert the file");
    }
  }
  const char* find(const char* p, char c) const {
    const auto rest = static_cast<std::size_t>(input_.end() - p);
    return rest ? static_cast<const char*>(std::memchr(p, c, rest)) : nullptr;
  }
  bool starts_statement(char keyword) const { return *p_ == keyword && is_blank(p_[1]); }

  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError(fmt::format("{}, line {}: {}", input_.name, line_, problem));
  }
  [[noreturn]] void fail_file(std::string_view problem) const {
    throw InputError(fmt::format("{} {}; is it a mesh?", input_.name, problem));
  }

  /// The text up to the next blank, shortened, for a message.
  std::string word() const {
    const char* end = p_;
    while (end < input_.end() && end - p_ < 24 && !is_blank(*end) && *end != '\n') ++end;
    return std::string(p_, end);
  }

  void parse_vertex() {
    ++p_;
    double values[3] = {};
    std::size_t count = 0;
    for (skip_blanks(); count < 3 && !at_line_end(); ++count, skip_blanks()) {
      const char* const end = parse_number(p_, values[count]);
      if (!end || !ends_word(end)) {
        fail(fmt::format("'{}' is not a finite number", word()));
      }
      p_ = end;
    }
    if (count < 2) fail("a vertex needs x and y");
    const bool has_height = count == 3;
    if (tin_.points.size() == 0) has_heights_ = has_height;
    if (has_height != has_heights_) {
      fail("some vertices have heights and some have none; give every vertex a height, or none");
    }
    tin_.points.xy.push_back({values[0], values[1]});
    if (has_height) tin_.points.z.push_back(values[2]);
    if (tin_.points.size() >= kNone) fail("more vertices than hodt can number");
  }

  void parse_face() {
    ++p_;
    std::array<Index, 3> corners{};
    std::size_t count = 0;
    for (skip_blanks(); !at_line_end(); ++count, skip_blanks()) {
      const Index corner = parse_corner();
      if (count < 3) corners[count] = corner;
    }
    if (count < 3) fail(fmt::format("a face needs three corners, not {}", count));
    if (count > 3) {
      fail(fmt::format("a face with {} corners; triangulate the mesh first", count));
    }
    tin_.triangles.push_back(corners);
  }

  /// "7", "7/1", "7//2" or "7/1/2"; only the first number matters.
  Index parse_corner() {
    const char* const start = p_;
    const bool backwards = *p_ == '-';
    if (backwards) ++p_;
    std::uint64_t number = 0;
    const char* const end = number_text::read_digits(p_, number);
    const bool is_number = end != p_ && end - p_ < 19 && (ends_word(end) || *end == '/');
    if (!is_number) {
      p_ = start;
      fail(fmt::format("'{}' is not a vertex number", word()));
    }
    for (p_ = end; !ends_word(p_);) ++p_;
    const std::uint64_t vertices = tin_.points.size();
    if (backwards && 1 <= number && number <= vertices) {
      return static_cast<Index>(vertices - number);
    }
    if (backwards || number == 0) {
      fail(fmt::format("there is no vertex {}{}", backwards ? "-" : "", number));
    }
    if (number > largest_corner_) {
      largest_corner_ = number;
      largest_corner_line_ = line_;
    }
    return static_cast<Index>(number - 1);
  }

  void parse_comment() {
    const std::string_view rest(p_, static_cast<std::size_t>(input_.end() - p_));
    if (!rest.starts_with(kCrsComment)) return;
    p_ += kCrsComment.size();
    const char* end = p_;
    while (*end != '\n' && *end != '\r') ++end;
    tin_.crs.assign(p_, end);
  }

  const InputText& input_;
  const char* p_;
  std::size_t line_ = 1;
  bool has_heights_ = false;
  /// Faces may come before their vertices, so corners are checked at the end.
  std::uint64_t largest_corner_ = 0;
  std::size_t largest_corner_line_ = 0;
  Tin tin_;
};

}  // namespace

Tin parse_obj(const InputText& input) {
  require_text(input);
  return ObjParser(input).parse();
}

void write_obj(const Tin& tin, OutputFile& file) {
  const PointSet& points = tin.points;
  if (!tin.crs.empty()) file.write(fmt::format("{}{}\n", kCrsComment, in_one_line(tin.crs)));
  const auto format_vertex = [&](std::size_t i, char* to) {
    *to++ = 'v';
    for (const double value : {points.xy[i].x, points.xy[i].y, height_or_zero(points, i)}) {
      *to++ = ' ';
      to = format_number(to, value);
    }
    *to++ = '\n';
    return to;
  };
  const auto format_face = [&](std::size_t t, char* to) {
    *to++ = 'f';
    for (const Index corner : tin.triangles[t]) {
      *to++ = ' ';
      to = format_number(to, corner + 1);
    }
    *to++ = '\n';
    return to;
  };
  constexpr std::size_t longest = 2 + 3 * (kLongestNumber + 1);
  write_records(file, points.size(), longest, format_vertex);
  write_records(file, tin.triangles.size(), longest, format_face);
}

}  // namespace hodt
