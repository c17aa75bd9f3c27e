#include "app/comparison_table.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/common.h"
#include "app/duplicates_text.h"
#include "app/keep.h"
#include <fmt/format.h>

namespace hodt::app {

namespace {

constexpr const char* kNothing = "-";

/// Writes the numbers of one column with the same decimals: enough for so many digits of the
/// largest.
class ColumnFormat {
 public:
  explicit ColumnFormat(int digits = 7) : digits_(digits) {}

  void include(double value) {
    if (!std::isfinite(value)) return;
    whole_ = whole_ && value == std::floor(value);
    largest_ = std::max(largest_, std::fabs(value));
  }

  std::string text(double value) const {
    const std::string text = written(value);
    // Rounding can leave a bound a little below 0.
    const bool is_minus_zero = text[0] == '-' && text.find_first_not_of("-0.") == text.npos;
    return is_minus_zero ? text.substr(1) : text;
  }

 private:
  std::string written(double value) const {
    constexpr double longest = 1e15;
    if (whole_ && largest_ < longest) return fmt::format("{:.0f}", value);
    const int before_point = static_cast<int>(std::floor(std::log10(largest_))) + 1;
    if (before_point > digits_ || before_point < -2)
      return fmt::format("{:.{}e}", value, digits_ - 1);
    return fmt::format("{:.{}f}", value, std::max(digits_ - std::max(before_point, 1), 1));
  }

  int digits_;
  bool whole_ = true;
  double largest_ = 0;
};

ColumnFormat format_of_values(const ObjectiveComparison& objective) {
  ColumnFormat format;
  for (const ComparisonRow& row : objective.rows)
    for (const double value : {row.value.result, row.value.bound}) format.include(value);
  return format;
}

/// Of what is measured in the terrain's pits, over all rows, so that objectives can be compared.
ColumnFormat format_of_pits(const Comparison& comparison, double PitTotals::*member) {
  ColumnFormat format(5);
  if (comparison.delaunay_pits) format.include((*comparison.delaunay_pits).*member);
  for (const ObjectiveComparison& objective : comparison.objectives)
    for (const ComparisonRow& row : objective.rows)
      if (row.pits) format.include((*row.pits).*member);
  return format;
}

ColumnFormat format_of_errors(const Comparison& comparison) {
  ColumnFormat format;
  if (comparison.truth && comparison.truth->delaunay) {
    format.include(comparison.truth->delaunay->rmse);
    format.include(comparison.truth->delaunay->max_error);
  }
  for (const ObjectiveComparison& objective : comparison.objectives) {
    for (const ComparisonRow& row : objective.rows) {
      if (!row.fit) continue;
      format.include(row.fit->rmse);
      format.include(row.fit->max_error);
    }
  }
  return format;
}

ColumnFormat format_of_fill(const Comparison& comparison) {
  ColumnFormat format(5);
  if (comparison.truth && comparison.truth->delaunay_land) {
    format.include(comparison.truth->delaunay_land->fill.volume);
    format.include(comparison.truth->land_fill.volume);
  }
  for (const ObjectiveComparison& objective : comparison.objectives)
    for (const ComparisonRow& row : objective.rows)
      if (row.land) format.include(row.land->fill.volume);
  return format;
}

/// Error of slopes, agreement of streams.
std::string slope_text(const LandFit& land) {
  return land.slope_error ? fmt::format("{:.2f}°", *land.slope_error) : kNothing;
}
std::string streams_text(const LandFit& land) {
  return land.stream_agreement ? fmt::format("{:.3f}", *land.stream_agreement) : kNothing;
}

/// Interior minima, sum of depths, largest depth, volume.
class PitCells {
 public:
  explicit PitCells(const Comparison& comparison)
      : depth_(format_of_pits(comparison, &PitTotals::depth)),
        deepest_(format_of_pits(comparison, &PitTotals::deepest)),
        volume_(format_of_pits(comparison, &PitTotals::volume)) {}

  std::vector<std::string> of(const PitTotals& pits) const {
    return {fmt::format("{}", pits.count), depth_.text(pits.depth), deepest_.text(pits.deepest),
            volume_.text(pits.volume)};
  }

 private:
  ColumnFormat depth_, deepest_, volume_;
};

std::string interior_minima(std::size_t count) {
  return fmt::format("{} interior {}", count, count == 1 ? "minimum" : "minima");
}

std::string proof_text(const ComparisonRow& row) {
  if (row.value.optimal) return "proved";
  const std::optional<double> gap = row.gap();
  return gap ? fmt::format("gap {:.2f} %", *gap) : "gap";
}

std::string change_text(const ComparisonRow& row) {
  const std::optional<double> change = row.change();
  if (!change) return kNothing;
  // Not "-0.00 %".
  return std::fabs(*change) < 0.005 ? "0.00 %" : fmt::format("{:+.2f} %", *change);
}

/// In characters: a degree sign is one, though of two bytes.
std::size_t width_of(const std::string& text) {
  const auto begins_character = [](char c) { return (c & 0xC0) != 0x80; };
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins_character));
}

}  // namespace

Table table_of(const Comparison& comparison, const ObjectiveComparison& objective) {
  const ColumnFormat value = format_of_values(objective), error = format_of_errors(comparison);
  const PitCells pits(comparison);
  const bool heights = !objective.rows.empty() && objective.rows[0].local_minima.has_value();
  const bool fits = comparison.truth && comparison.truth->delaunay;
  const bool flows = comparison.truth && comparison.truth->delaunay_land;
  const ColumnFormat fill = format_of_fill(comparison);

  const bool means = !objective.rows.empty() && objective.rows[0].mean_angle.has_value();

  Table table{{"k", "value", "bound", "proof", "change", "order", "smallest angle"}, {}};
  if (means) table.headings.insert(table.headings.begin() + 1, "mean");
  if (heights)
    table.headings.insert(table.headings.end(),
                          {"local minima", "interior", "pit depth", "deepest", "pit volume"});
  if (fits) table.headings.insert(table.headings.end(), {"RMSE", "max error"});
  if (flows) table.headings.insert(table.headings.end(), {"slope error", "fill volume", "streams"});
  table.headings.push_back("seconds");

  for (const ComparisonRow& row : objective.rows) {
    std::vector<std::string> cells{fmt::format("{}", row.k),
                                   value.text(row.value.result),
                                   value.text(row.value.bound),
                                   proof_text(row),
                                   change_text(row),
                                   fmt::format("{}", row.order),
                                   fmt::format("{:.3g}°", row.smallest_angle)};
    if (means) cells.insert(cells.begin() + 1, fmt::format("{:.4f}°", row.mean_angle.value_or(0)));
    if (heights) {
      cells.push_back(fmt::format("{}", row.local_minima.value_or(0)));
      for (std::string& cell : pits.of(row.pits.value_or(PitTotals{})))
        cells.push_back(std::move(cell));
    }
    if (fits) {
      cells.push_back(row.fit ? error.text(row.fit->rmse) : kNothing);
      cells.push_back(row.fit ? error.text(row.fit->max_error) : kNothing);
    }
    if (flows) {
      const LandFit& land = *row.land;
      cells.insert(cells.end(),
                   {slope_text(land), fill.text(land.fill.volume), streams_text(land)});
    }
    cells.push_back(fmt::format("{:.3f}", row.seconds));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

Table later_table(const ObjectiveComparison& objective, std::size_t later) {
  const ObjectiveComparison by_later = objective.by_later(later);
  const ColumnFormat value = format_of_values(by_later);
  Table table{{"k", "value", "bound", "proof", "change"}, {}};
  for (const ComparisonRow& row : by_later.rows)
    table.rows.push_back({fmt::format("{}", row.k), value.text(row.value.result),
                          value.text(row.value.bound), proof_text(row), change_text(row)});
  return table;
}

std::string given_text(const ObjectiveComparison& objective) {
  return objective.given.empty() ? "" : fmt::format(", of the input {}", objective.given.front());
}

Table summary_table(const Comparison& comparison) {
  Table table{{"objective", "Delaunay", "best", "at k", "change", "proof"}, {}};
  const auto add = [&](const std::string& name, const ComparisonRow& best) {
    ColumnFormat format;
    for (const double value : {best.value.delaunay, best.value.result}) format.include(value);
    table.rows.push_back({name, format.text(best.value.delaunay), format.text(best.value.result),
                          fmt::format("{}", best.k), change_text(best), proof_text(best)});
  };
  for (const ObjectiveComparison& objective : comparison.objectives) {
    if (objective.rows.empty() || !objective.why_unchanged.empty()) continue;
    const ComparisonRow& best = objective.best();
    add(objective.title(), best);
    for (std::size_t i = 0; i + 1 < objective.objectives.size(); ++i) {
      add("then " + name_of(objective.objectives[i + 1]), best.by_later(i));
    }
  }
  return table;
}

std::string aligned(const Table& table) {
  std::vector<std::size_t> widths(table.headings.size());
  const auto widen = [&](const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i)
      widths[i] = std::max(widths[i], width_of(cells[i]));
  };
  widen(table.headings);
  for (const auto& row : table.rows) widen(row);
  std::string text;
  const auto add = [&](const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i)
      text += std::string(2 + widths[i] - width_of(cells[i]), ' ') + cells[i];
    text += '\n';
  };
  add(table.headings);
  for (const auto& row : table.rows) add(row);
  return text;
}

std::vector<Fact> facts_of(const Comparison& comparison) {
  std::vector<Fact> facts{
      {"points", fmt::format("{}, {}", comparison.points,
                             dropped_text(comparison.duplicates, comparison.duplicate_heights))}};
  if (comparison.delaunay_pits) {
    const std::vector<std::string> cells = PitCells(comparison).of(*comparison.delaunay_pits);
    facts.push_back({"pits", fmt::format("Delaunay: {}, {} deep in all, the deepest {}, volume {}",
                                         interior_minima(comparison.delaunay_pits->count), cells[1],
                                         cells[2], cells[3])});
  }
  if (comparison.kept)
    facts.push_back({"kept", kept_text(*comparison.kept, comparison.empty_polygons)});
  if (comparison.given_order)
    facts.push_back({"input", fmt::format("a mesh of order {}", *comparison.given_order)});
  if (!comparison.truth) return facts;
  const TruthSummary& truth = *comparison.truth;
  facts.push_back(
      {"truth", fmt::format("{}, {} outside the {}", counted(truth.points, "point"), truth.outside,
                            comparison.constraints.edges > 0 ? "domain" : "hull")});
  if (truth.delaunay) {
    const ColumnFormat error = format_of_errors(comparison);
    facts.push_back(
        {"Delaunay", fmt::format("RMSE {}, largest error {}", error.text(truth.delaunay->rmse),
                                 error.text(truth.delaunay->max_error))});
  }
  if (const std::optional<LandFit>& land = truth.delaunay_land) {
    const ColumnFormat fill = format_of_fill(comparison);
    facts.push_back(
        {"water", fmt::format("Delaunay: fill volume {}, of the land itself {}; agreement of "
                              "streams {}; slope error {}",
                              fill.text(land->fill.volume), fill.text(truth.land_fill.volume),
                              streams_text(*land), slope_text(*land))});
  }
  return facts;
}

}  // namespace hodt::app
