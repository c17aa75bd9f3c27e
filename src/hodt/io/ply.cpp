#include "hodt/io/ply.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/number_text.h"
#include "hodt/io/parallel_text.h"

namespace hodt {

namespace {

constexpr std::string_view kMagic = "ply";
constexpr std::string_view kCrsComment = "comment crs: ";

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
  explicit HeaderParser(const InputText& input) : input_(input), p_(input.begin()) {}

  Header parse() {
    if (next_line() != kMagic) fail("a PLY file begins with the line 'ply'");
    bool has_format = false;
    for (;;) {
      const std::string line = next_line();
      std::istringstream words(line);
      std::string keyword;
      words >> keyword;
      if (keyword == "end_header") break;
      if (keyword == "format") {
        parse_format(words);
        has_format = true;
      } else if (keyword == "element") {
        parse_element(words);
      } else if (keyword == "property") {
        parse_property(words);
      } else if (line.starts_with(kCrsComment)) {
        header_.crs = line.substr(kCrsComment.size());
      }
    }
    if (!has_format) fail("the header lacks its format line");
    header_.body = p_;
    return std::move(header_);
  }

 private:
  [[noreturn]] void fail(std::string_view problem) const {
    throw InputError(fmt::format("{}, line {}: {}", input_.name, line_, problem));
  }

  std::string next_line() {
    ++line_;
    const auto rest = static_cast<std::size_t>(input_.end() - p_);
    const void* feed = rest ? std::memchr(p_, '\n', rest) : nullptr;
    if (!feed) fail("the header does not end; 'end_header' is missing");
    std::string line(p_, static_cast<const char*>(feed));
    p_ = static_cast<const char*>(feed) + 1;
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
    return line;
  }

  void parse_format(std::istream& words) {
    std::string encoding;
    words >> encoding;
    if (encoding == "ascii") {
      header_.encoding = Encoding::text;
    } else if (encoding == "binary_little_endian") {
      header_.encoding = Encoding::little_endian;
    } else if (encoding == "binary_big_endian") {
      header_.encoding = Encoding::big_endian;
    } else {
      fail(fmt::format("unknown format '{}'", encoding));
    }
  }

  void parse_element(std::istream& words) {
    Element element;
    if (!(words >> element.name >> element.count)) fail("an element needs a name and a count");
    if (element.count >= kNone) fail("more elements than hodt can number");
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
  std::size_t line_ = 0;
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
  bool exhausted() const { return p_ >= end_; }
  std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - p_); }

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
  bool exhausted() const { return exhausted_; }
  std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - p_); }

 private:
  template <class T>
  std::optional<double> take() {
    if (bytes_left() < sizeof(T)) {
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
    for (const Element& element : header_.elements) {
      if (element.name == "vertex") {
        parse_vertices(element);
      } else if (element.name == "face") {
        parse_faces(element);
      } else {
        skip(element);
      }
    }
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

  void skip(const Element& element) {
    for (std::size_t i = 0; i < element.count; ++i) {
      for (const Property& property : element.properties) skip(property, element, i);
    }
  }

  /// What to set aside for a count that the header claims: each item takes a byte at least.
  std::size_t believable(std::size_t count) const { return std::min(count, source_.bytes_left()); }

  static const Property* find(const Element& element, std::string_view name, bool is_list) {
    for (const Property& property : element.properties) {
      if (property.name == name && property.count_type.has_value() == is_list) return &property;
    }
    return nullptr;
  }

  void parse_vertices(const Element& element) {
    const Property* const axes[3] = {find(element, "x", false), find(element, "y", false),
                                     find(element, "z", false)};
    if (!axes[0] || !axes[1]) fail_file("has vertices without x and y");
    tin_.points.xy.reserve(believable(element.count));
    if (axes[2]) tin_.points.z.reserve(believable(element.count));
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
      tin_.points.xy.push_back({values[0], values[1]});
      if (axes[2]) tin_.points.z.push_back(values[2]);
    }
  }

  void parse_faces(const Element& element) {
    const Property* corners = find(element, "vertex_indices", true);
    if (!corners) corners = find(element, "vertex_index", true);
    if (!corners) fail_file("has faces without vertex_indices");
    tin_.triangles.reserve(believable(element.count));
    for (std::size_t i = 0; i < element.count; ++i) {
      for (const Property& property : element.properties) {
        if (&property == corners) {
          parse_corners(property, element, i);
        } else {
          skip(property, element, i);
        }
      }
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

/// Little-endian, whatever the machine is.
template <class T>
char* put(char* to, T value) {
  auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
  std::memcpy(to, bytes.data(), sizeof(T));
  return to + sizeof(T);
}

std::string header_of(const Tin& tin) {
  // Many programs know only int; use it as long as it does.
  const bool fits_int = tin.points.size() <= std::size_t{1} << 31;
  return fmt::format(
      "ply\nformat binary_little_endian 1.0\n{}{}{}"
      "element vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
      "element face {}\nproperty list uchar {} vertex_indices\nend_header\n",
      tin.crs.empty() ? "" : kCrsComment, tin.crs, tin.crs.empty() ? "" : "\n", tin.points.size(),
      tin.triangles.size(), fits_int ? "int" : "uint");
}

}  // namespace

bool is_ply(const InputText& input) {
  const std::string_view text = input.view();
  return text.starts_with("ply\n") || text.starts_with("ply\r\n");
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

void write_ply(const Tin& tin, OutputFile& file) {
  const PointSet& points = tin.points;
  file.write(header_of(tin));
  write_records(file, points.size(), 3 * sizeof(double), [&](std::size_t i, char* to) {
    to = put(to, points.xy[i].x);
    to = put(to, points.xy[i].y);
    return put(to, points.has_heights() ? points.z[i] : 0.0);
  });
  constexpr std::size_t longest = 1 + 3 * sizeof(Index);
  write_records(file, tin.triangles.size(), longest, [&](std::size_t t, char* to) {
    to = put(to, std::uint8_t{3});
    for (const Index corner : tin.triangles[t]) to = put(to, corner);
    return to;
  });
}

}  // namespace hodt
