#include "hodt/io/line_file.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/file_name.h"
#include "hodt/io/geojson_reader.h"

namespace hodt {

namespace {

InputText input_of(const std::filesystem::path& path) {
  if (is_geojson_name(path)) return read_input(path);
  const std::string extension = path.extension().string();
  throw ParameterError(fmt::format(
      "cannot read lines from {}: {}; known are .geojson and .json, each also with .gz, and "
      "ogr2ogr -f GeoJSON writes them from other formats",
      display_name(path),
      extension.empty() ? "the name has no extension" : "unknown extension '" + extension + "'"));
}

/// The line with its last vertex at its first: the ring of a polygon, whether or not the file
/// repeats the first.
Line closed(Line ring) {
  if (!ring.is_closed()) {
    ring.xy.push_back(ring.xy.front());
    if (ring.has_heights()) ring.z.push_back(ring.z.front());
  } else if (ring.has_heights() && ring.z.front() != ring.z.back()) {
    throw InputError(
        fmt::format("it begins at height {} and ends at the same place at {}; correct one of them",
                    ring.z.front(), ring.z.back()));
  }
  return ring;
}

/// A line that has to be closed as it is, and be a ring.
Line ring_of(Line line) {
  if (!line.is_closed())
    throw InputError(
        fmt::format("it is open: it begins at {}, {} and ends at {}, {}; repeat the first position "
                    "of an outline at its end, or make it a polygon",
                    line.xy.front().x, line.xy.front().y, line.xy.back().x, line.xy.back().y));
  if (line.xy.size() < 4)
    throw InputError("it has fewer than three corners; complete or remove it");
  return closed(std::move(line));
}

/// Appends what `line` makes of lines, and rings of polygons, to `lines`; at least one.
void collect(const InputText& text, std::string_view can_hold,
             const std::function<Line(Line)>& line, std::vector<Line>& lines) {
  GeoJsonTaker taker;
  taker.can_hold = can_hold;
  taker.heights = true;
  taker.skips_empty = true;
  taker.line = [&](Line taken) { lines.push_back(line(std::move(taken))); };
  taker.ring = [&](Line ring, bool) { lines.push_back(closed(std::move(ring))); };
  read_geojson(text, taker);
  if (lines.empty())
    throw InputError(fmt::format("{} holds nothing; {} are what it can hold", text.name, can_hold));
}

}  // namespace

Lines parse_lines(const InputText& text) {
  Lines lines{{}, text.name, "feature"};
  collect(
      text, "lines and polygons", [](Line line) { return line; }, lines.lines);
  return lines;
}

Outline parse_outline(const InputText& text) {
  Outline outline{{}, text.name, "feature"};
  collect(text, "polygons and closed lines", ring_of, outline.rings);
  return outline;
}

Lines read_lines(const std::filesystem::path& path) {
  return parse_lines(input_of(path));
}

Outline read_outline(const std::filesystem::path& path) {
  return parse_outline(input_of(path));
}

}  // namespace hodt
