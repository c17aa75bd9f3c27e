#include "hodt/io/ply.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/bytes.h"
#include "hodt/io/number_text.h"
#include "hodt/io/parallel_text.h"
#include "hodt/io/tin_parts.h"

namespace hodt {

namespace {

constexpr std::string_view kMagic = "ply";
constexpr std::string_view kCrsComment = "comment crs: ";
/// What may fill up a file after its last element.
constexpr std::string_view kPadding("\0 \t\r\n", 5);

enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::optional<Type> type_from_name(std::string_view name) {
  struct Name {
    std::string_view classic, sized;
  };
  constexpr Name names[] = {{"char", "int8"},     {"uchar", "uint8"},   {"short", "int16"},
                            {"ushort", "uint16"}, {"int", "int32"},     {"uint", "uint32"},
                            {"float", "float32"}, {"double", "float64"}};
  for (int t = 0; t < 8; ++t) {
    if (name == names[t].classic || name == names[t].sized) return static_cast<Type>(t);
  }
  return std::nullopt;
}

struct Property {
  std::string name;
  Type type = Type::float32;
  std::optional<Type> count_type;  ///< of a list's length
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

enum class Encoding { text, little_endian, big_endian };

struct Header {
  Encoding encoding = Encoding::text;
  std::vector<Element> elements;
  std::string crs;
  const char* body = nullptr;
};

class HeaderParser {
 public:
  explicit HeaderParser(const InputText& input)
      : input_(input), p_(input.begin()), line_end_(ends_like_old_macs(input) ? '\r' : '\n') {}

  Header parse() {
    if (next_line() != kMagic) fail("a PLY file begins with the line 'ply'");
    for (;;) {
      const std::string line = next_line();
      std::istringstream words(line);
      std::string keyword;
      words >> keyword;
      if (keyword == "end_header") break;
      if (keyword == "format") {
        parse_format(words);
      } else if (keyword == "element") {
        parse_element(words);
      } else if (keyword == "property") {
        parse_property(words);
      } else if (keyword == "comment") {
        if (line.starts_with(kCrsComment)) header_.crs = line.substr(kCrsComment.size());
        continue;
      } else if (keyword == "obj_info" || keyword.empty()) {
        continue;
      } else {
        fail(fmt::format("'{}' is nothing that a PLY header says", keyword));
      }
      if (words >> keyword) fail(fmt::format("'{}' is one word too many", keyword));
    }
    if (!has_format_) fail("the header lacks its format line");
    header_.body = p_;
    return std::move(header_);
  }

 private:
  [[noreturn]] void fail(std::string_view problem) const {
    throw InputError(fmt::format("{}, line {}: {}", input_.name, line_, problem));
  }

  static bool ends_like_old_macs(const InputText& input) {
    const std::string_view text = input.view();
    return text.starts_with("ply\r") && !text.starts_with("ply\r\n");
  }

  std::string next_line() {
    ++line_;
    const auto rest = static_cast<std::size_t>(input_.end() - p_);
    const void* feed = rest ? std::memchr(p_, line_end_, rest) : nullptr;
    if (!feed) fail("the header does not end; 'end_header' is missing");
    std::string line(p_, static_cast<const char*>(feed));
    p_ = static_cast<const char*>(feed) + 1;
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
    return line;
  }

  void parse_format(std::istream& words) {
    if (std::exchange(has_format_, true)) fail("a second format line");
    std::string encoding, version;
    words >> encoding >> version;
    if (encoding == "ascii") {
      header_.encoding = Encoding::text;
    } else if (encoding == "binary_little_endian") {
      header_.encoding = Encoding::little_endian;
    } else if (encoding == "binary_big_endian") {
      header_.encoding = Encoding::big_endian;
    } else {
      fail(fmt::format("unknown format '{}'", encoding));
    }
    if (version != "1.0") fail(fmt::format("unknown version '{}' of PLY", version));
  }

  void parse_element(std::istream& words) {
    Element element;
    std::string count;
    if (!(words >> element.name >> count)) fail("an element needs a name and a count");
    if (!std::all_of(count.begin(), count.end(), number_text::is_digit))
      fail(fmt::format("'{}' is no count", count));
    const auto [end, error] =
        std::from_chars(count.data(), count.data() + count.size(), element.count);
    if (error != std::errc() || element.count >= kNone) fail("more elements than hodt can number");
    header_.elements.push_back(std::move(element));
  }

  void parse_property(std::istream& words) {
    if (header_.elements.empty()) fail("a property before any element");
    Property property;
    std::string type;
    words >> type;
    if (type == "list") {
      words >> type;
      property.count_type = parse_type(type);
      words >> type;
    }
    property.type = parse_type(type);
    if (!(words >> property.name)) fail("a property needs a name");
    header_.elements.back().properties.push_back(std::move(property));
  }

  Type parse_type(const std::string& name) const {
    const auto type = type_from_name(name);
    if (!type) fail(fmt::format("unknown type '{}'", name));
    return *type;
  }

  const InputText& input_;
  const char* p_;
  char line_end_;
  std::size_t line_ = 0;
  bool has_format_ = false;
  Header header_;
};

/// Hands out the numbers of a text body; nothing if the next thing is no number.
class TextSource {
 public:
  TextSource(const char* begin, const char* end) : p_(begin), end_(end) {}

  std::optional<double> next(Type) {
    while (p_ < end_ && is_space(*p_)) ++p_;
    if (p_ >= end_) return std::nullopt;
    double value = 0;
    const char* const after = parse_number(p_, value);
    if (!after || !(after >= end_ || is_space(*after))) return std::nullopt;
    p_ = after;
    return value;
  }
  /// Whether nothing follows on this line.
  bool at_line_end() {
    while (p_ < end_ && (*p_ == ' ' || *p_ == '\t')) ++p_;
    return p_ >= end_ || *p_ == '\n' || *p_ == '\r';
  }
  bool exhausted() const { return p_ >= end_; }
  std::string_view rest() const { return {p_, static_cast<std::size_t>(end_ - p_)}; }
  /// Of a number and the blank after it.
  static std::size_t least_size(Type) { return 2; }

 private:
  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

  const char* p_;
  const char* end_;
};

/// The same for a binary body.
class BinarySource {
 public:
  BinarySource(const char* begin, const char* end, bool swap) : p_(begin), end_(end), swap_(swap) {}

  std::optional<double> next(Type type) {
    switch (type) {
      case Type::int8:
        return take<std::int8_t>();
      case Type::uint8:
        return take<std::uint8_t>();
      case Type::int16:
        return take<std::int16_t>();
      case Type::uint16:
        return take<std::uint16_t>();
      case Type::int32:
        return take<std::int32_t>();
      case Type::uint32:
        return take<std::uint32_t>();
      case Type::float32:
        return take<float>();
      case Type::float64:
        return take<double>();
    }
    return std::nullopt;
  }
  bool at_line_end() const { return true; }
  bool exhausted() const { return exhausted_; }
  std::string_view rest() const { return {p_, static_cast<std::size_t>(end_ - p_)}; }
  static std::size_t least_size(Type type) {
    switch (type) {
      case Type::int8:
      case Type::uint8:
        return 1;
      case Type::int16:
      case Type::uint16:
        return 2;
      case Type::float64:
        return 8;
      default:
        return 4;
    }
  }

 private:
  template <class T>
  std::optional<double> take() {
    if (rest().size() < sizeof(T)) {
      exhausted_ = true;
      return std::nullopt;
    }
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), p_, sizeof(T));
    p_ += sizeof(T);
    if (swap_) std::reverse(bytes.begin(), bytes.end());
    return static_cast<double>(std::bit_cast<T>(bytes));
  }

  const char* p_;
  const char* end_;
  bool swap_;
  bool exhausted_ = false;
};

template <class Source>
class BodyParser {
 public:
  BodyParser(const InputText& input, const Header& header, Source source)
      : input_(input), header_(header), source_(source) {}

  Tin parse() {
    const Element* const vertices = element_called("vertex");
    const Element* const faces = element_called("face");
    for (const Element& element : header_.elements) {
      if (&element == vertices) {
        parse_vertices(element);
      } else if (&element == faces) {
        parse_faces(element);
      } else {
        skip(element);
      }
    }
    if (source_.rest().find_first_not_of(kPadding) != std::string_view::npos)
      fail_file("goes on after the last element that its header announces");
    check_corners();
    tin_.crs = header_.crs;
    return std::move(tin_);
  }

 private:
  [[noreturn]] void fail_file(std::string_view problem) const {
    throw InputError(fmt::format("{} {}", input_.name, problem));
  }
  [[noreturn]] void fail(std::string_view element, std::size_t i, std::string_view problem) const {
    throw InputError(fmt::format("{}, {} {}: {}", input_.name, element, i, problem));
  }

  double next(Type type, const Element& element, std::size_t i) {
    const auto value = source_.next(type);
    if (!value) {
      fail(element.name, i,
           source_.exhausted() ? "the file ends here; it is cut short" : "not a finite number");
    }
    return *value;
  }

  std::size_t next_count(const Property& property, const Element& element, std::size_t i) {
    const double count = next(*property.count_type, element, i);
    if (!(count >= 0 && count < kNone && count == std::floor(count))) {
      fail(element.name, i, fmt::format("{} is not the length of a list", count));
    }
    return static_cast<std::size_t>(count);
  }

  void skip(const Property& property, const Element& element, std::size_t i) {
    const std::size_t count = property.count_type ? next_count(property, element, i) : 1;
    for (std::size_t k = 0; k < count; ++k) next(property.type, element, i);
  }

  void end_item(const Element& element, std::size_t i) {
    if (!source_.at_line_end())
      fail(element.name, i, "its line holds more numbers than the header announces");
  }

  void skip(const Element& element) {
    if (element.properties.empty()) return;  // such items take no room, however many
    for (std::size_t i = 0; i < element.count; ++i) {
      for (const Property& property : element.properties) skip(property, element, i);
      end_item(element, i);
    }
  }

  /// How many items there can be at most, as a header can claim anything.
  std::size_t believable(const Element& element) const {
    std::size_t least = 0;
    for (const Property& property : element.properties)
      least += source_.least_size(property.count_type.value_or(property.type));
    return least == 0 ? 0 : std::min(element.count, source_.rest().size() / least + 1);
  }

  /// The only element of this name; nullptr if there is none.
  const Element* element_called(std::string_view name) const {
    const Element* found = nullptr;
    for (const Element& element : header_.elements) {
      if (!is_called(element.name, name)) continue;
      if (found) fail_file(fmt::format("announces two elements '{}'", name));
      found = &element;
    }
    return found;
  }

  /// Some programs write X, Y, Z.
  static bool is_called(std::string_view name, std::string_view lower) {
    return std::equal(name.begin(), name.end(), lower.begin(), lower.end(), [](char a, char b) {
      return ('A' <= a && a <= 'Z' ? a - 'A' + 'a' : a) == b;
    });
  }

  /// The only property that has one of the names; nullptr if there is none.
  const Property* find(const Element& element, std::initializer_list<std::string_view> names,
                       bool is_list) const {
    const Property* found = nullptr;
    for (const Property& property : element.properties) {
      const auto fits = [&](std::string_view name) { return is_called(property.name, name); };
      if (std::none_of(names.begin(), names.end(), fits)) continue;
      if (found)
        fail_file(fmt::format("announces '{}' twice for each {}", *names.begin(), element.name));
      found = &property;
    }
    if (found && found->count_type.has_value() != is_list)
      fail_file(fmt::format("has a {} with '{}' that is {} list", element.name, found->name,
                            is_list ? "no" : "a"));
    return found;
  }

  void parse_vertices(const Element& element) {
    const Property* const axes[3] = {find(element, {"x"}, false), find(element, {"y"}, false),
                                     find(element, {"z"}, false)};
    if (!axes[0] || !axes[1]) fail_file("has vertices without x and y");
    tin_.points.xy.reserve(believable(element));
    if (axes[2]) tin_.points.z.reserve(believable(element));
    for (std::size_t i = 0; i < element.count; ++i) {
      double values[3] = {};
      for (const Property& property : element.properties) {
        const auto axis = std::find(axes, axes + 3, &property) - axes;
        if (axis == 3) {
          skip(property, element, i);
          continue;
        }
        values[axis] = next(property.type, element, i);
        if (!std::isfinite(values[axis])) {
          fail("vertex", i,
               fmt::format("{} is {}, not a finite number", property.name, values[axis]));
        }
      }
      end_item(element, i);
      tin_.points.xy.push_back({values[0], values[1]});
      if (axes[2]) tin_.points.z.push_back(values[2]);
    }
  }

  void parse_faces(const Element& element) {
    const Property* const corners = find(element, {"vertex_indices", "vertex_index"}, true);
    if (!corners) fail_file("has faces without vertex_indices");
    tin_.triangles.reserve(believable(element));
    for (std::size_t i = 0; i < element.count; ++i) {
      for (const Property& property : element.properties) {
        if (&property == corners) {
          parse_corners(property, element, i);
        } else {
          skip(property, element, i);
        }
      }
      end_item(element, i);
    }
  }

  void parse_corners(const Property& property, const Element& element, std::size_t i) {
    const std::size_t count = next_count(property, element, i);
    if (count < 3) fail("face", i, fmt::format("{} corners; a face needs three", count));
    if (count > 3) fail("face", i, fmt::format("{} corners; triangulate the mesh first", count));
    std::array<Index, 3> triangle;
    for (Index& corner : triangle) {
      const double index = next(property.type, element, i);
      if (!(index >= 0 && index < kNone && index == std::floor(index))) {
        fail("face", i, fmt::format("there is no vertex {}", index));
      }
      corner = static_cast<Index>(index);
    }
    tin_.triangles.push_back(triangle);
  }

  /// At the end, as faces may come before vertices.
  void check_corners() const {
    const std::size_t vertices = tin_.points.size();
    if (vertices == 0) fail_file("holds no vertex");
    if (tin_.triangles.empty()) fail_file("holds no triangle");
    for (std::size_t t = 0; t < tin_.triangles.size(); ++t) {
      for (const Index corner : tin_.triangles[t]) {
        if (corner < vertices) continue;
        fail("face", t, fmt::format("there is no vertex {}; the last is {}", corner, vertices - 1));
      }
    }
  }

  const InputText& input_;
  const Header& header_;
  Source source_;
  Tin tin_;
};

std::string header_of(const Tin& tin) {
  // Many programs know only int; use it as long as it does.
  const bool fits_int = tin.points.size() <= std::size_t{1} << 31;
  return fmt::format(
      "ply\nformat binary_little_endian 1.0\n{}{}{}"
      "element vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
      "element face {}\nproperty list uchar {} vertex_indices\nend_header\n",
      tin.crs.empty() ? "" : kCrsComment, in_ascii(in_one_line(tin.crs)),
      tin.crs.empty() ? "" : "\n", tin.points.size(), tin.triangles.size(),
      fits_int ? "int" : "uint");
}

}  // namespace

bool is_ply(const InputText& input) {
  const std::string_view text = input.view();
  return text.starts_with("ply\n") || text.starts_with("ply\r");
}

Tin parse_ply(const InputText& input) {
  if (input.size == 0) throw InputError(fmt::format("{} is empty", input.name));
  const Header header = HeaderParser(input).parse();
  if (header.encoding == Encoding::text) {
    return BodyParser(input, header, TextSource(header.body, input.end())).parse();
  }
  const bool swap =
      (header.encoding == Encoding::big_endian) != (std::endian::native == std::endian::big);
  return BodyParser(input, header, BinarySource(header.body, input.end(), swap)).parse();
}

// Faces have nothing but their corners: meshio, for one, reads no binary file where they have more.
void write_ply(const Tin& tin, OutputFile& file) {
  const PointSet& points = tin.points;
  file.write(header_of(tin));
  write_records(file, points.size(), 3 * sizeof(double), [&](std::size_t i, char* to) {
    to = put_little(to, points.xy[i].x);
    to = put_little(to, points.xy[i].y);
    return put_little(to, height_or_zero(points, i));
  });
  constexpr std::size_t longest = 1 + 3 * sizeof(Index);
  write_records(file, tin.triangles.size(), longest, [&](std::size_t t, char* to) {
    to = put_little(to, std::uint8_t{3});
    for (const Index corner : tin.triangles[t]) to = put_little(to, corner);
    return to;
  });
}

}  // namespace hodt
