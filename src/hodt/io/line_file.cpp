#include "hodt/io/line_file.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/formats.h"
#include "hodt/io/geojson_reader.h"

namespace hodt {

namespace {

/// Hands what a file holds to a taker; returns the coordinate reference system.
using Reading = std::function<std::string(const FeatureTaker&)>;

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

/// Appends what `line` makes of lines, and rings of polygons, to `lines`; at least one. Returns the
/// coordinate reference system.
std::string collect(const Reading& read, const std::string& name, std::string_view can_hold,
                    const std::function<Line(Line)>& line, std::vector<Line>& lines,
                    std::vector<std::string>& warnings) {
  FeatureTaker taker;
  taker.can_hold = can_hold;
  taker.heights = true;
  taker.skips_empty = true;
  taker.line = [&](Line taken) { lines.push_back(line(std::move(taken))); };
  taker.ring = [&](Line ring, bool) { lines.push_back(closed(std::move(ring))); };
  taker.warning = [&](std::string warning) { warnings.push_back(std::move(warning)); };
  std::string crs = read(taker);
  if (lines.empty())
    throw InputError(fmt::format("{} holds nothing; {} are what it can hold", name, can_hold));
  return crs;
}

Lines lines_of(const Reading& read, const std::string& name) {
  Lines lines{{}, name, "feature"};
  lines.crs = collect(
      read, name, "lines and polygons", [](Line line) { return line; }, lines.lines,
      lines.warnings);
  return lines;
}

Outline outline_of(const Reading& read, const std::string& name) {
  Outline outline{{}, name, "feature"};
  outline.crs =
      collect(read, name, "polygons and closed lines", ring_of, outline.rings, outline.warnings);
  return outline;
}

Reading reading(const InputText& text) {
  return [&text](const FeatureTaker& taker) { return read_geojson(text, taker); };
}

Reading reading(const std::filesystem::path& path, const std::string& layer) {
  return [&, &format = format_for(path, Use::read_features)](const FeatureTaker& taker) {
    return format.read_features(path, layer, taker);
  };
}

}  // namespace

Lines parse_lines(const InputText& text) {
  return lines_of(reading(text), text.name);
}

Outline parse_outline(const InputText& text) {
  return outline_of(reading(text), text.name);
}

Lines read_lines(const std::filesystem::path& path, const std::string& layer) {
  return lines_of(reading(path, layer), display_name(path));
}

Outline read_outline(const std::filesystem::path& path, const std::string& layer) {
  return outline_of(reading(path, layer), display_name(path));
}

}  // namespace hodt
