#include "hodt/io/geojson.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "hodt/base/parallel.h"
#include "hodt/io/number_text.h"

namespace hodt {

namespace {

void append_position(std::string& text, const Point& p) {
  text += '[';
  append_number(text, p.x);
  text += ',';
  append_number(text, p.y);
  text += ']';
}

/// Begins with the comma that parts it from an earlier feature.
void append_feature(std::string& text, const PolygonFeature& feature) {
  text += ",\n{\"type\":\"Feature\",\"properties\":{\"points\":[";
  for (std::size_t i = 0; i < feature.points.size(); ++i) {
    if (i > 0) text += ',';
    append_number(text, feature.points[i]);
  }
  text += "]},\"geometry\":{\"type\":\"Polygon\",\"coordinates\":[[";
  for (const Point& p : feature.ring) {
    append_position(text, p);
    text += ',';
  }
  append_position(text, feature.ring.front());
  text += "]]}}";
}

struct Piece {
  std::string text;
  std::size_t written = 0;
};

}  // namespace

std::size_t write_geojson(OutputFile& file, std::size_t count,
                          const std::function<void(std::size_t, PolygonFeature&)>& make) {
  // A batch of pieces bounds the memory; the cut depends on nothing but the count.
  constexpr std::size_t piece_size = 512, pieces_in_batch = 64;
  file.write("{\"type\":\"FeatureCollection\",\"features\":[");
  std::vector<Piece> batch(pieces_in_batch);
  std::size_t written = 0;
  for (std::size_t first = 0; first < count; first += piece_size * pieces_in_batch) {
    const std::size_t pieces =
        std::min((count - first + piece_size - 1) / piece_size, pieces_in_batch);
    parallel_for(0, pieces, 1, [&](std::size_t begin, std::size_t end) {
      PolygonFeature feature;
      for (std::size_t p = begin; p < end; ++p) {
        batch[p].text.clear();
        batch[p].written = 0;
        const std::size_t last = std::min(first + (p + 1) * piece_size, count);
        for (std::size_t i = first + p * piece_size; i < last; ++i) {
          make(i, feature);
          if (feature.ring.empty()) continue;
          append_feature(batch[p].text, feature);
          ++batch[p].written;
        }
      }
    });
    for (std::size_t p = 0; p < pieces; ++p) {
      if (batch[p].written == 0) continue;
      file.write(std::string_view(batch[p].text).substr(written == 0 ? 1 : 0));
      written += batch[p].written;
    }
  }
  file.write("\n]}\n");
  return written;
}

}  // namespace hodt
