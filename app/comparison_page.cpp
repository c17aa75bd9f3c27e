#include "app/comparison_page.h"

#include <algorithm>
#include <filesystem>

#include "app/comparison_chart.h"
#include "app/comparison_table.h"
#include <fmt/format.h>

#include "hodt/io/input_text.h"
#include "hodt/picture/markup.h"

namespace hodt::app {

namespace {

constexpr std::string_view kStyle = R"(
body { margin: 0 auto; max-width: 60rem; padding: 2rem 1.5rem 4rem; background: #ffffff;
  color: #2b2a28; font: 16px/1.5 system-ui, -apple-system, "Segoe UI", Roboto, sans-serif; }
h1 { font-size: 1.7rem; font-weight: 600; margin: 0 0 0.3rem; overflow-wrap: anywhere; }
h3 { font-size: 1rem; font-weight: 600; margin: 1.6rem 0 0.8rem; }
h2 { font-size: 1.2rem; font-weight: 600; margin: 3rem 0 0.8rem; padding-top: 1.2rem;
  border-top: 1px solid #e4e1db; }
p { max-width: 44rem; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 0.15rem 1.2rem; margin: 1.2rem 0; }
dt { color: #75716a; }
dd { margin: 0; overflow-wrap: anywhere; }
a { color: #0f55a8; text-decoration: none; }
a:hover { text-decoration: underline; }
details { margin: 0.8rem 0; }
summary { cursor: pointer; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-size: 0.8rem;
  font-variant-numeric: tabular-nums; }
th, td { padding: 0.3rem 0.35rem; text-align: right; white-space: nowrap; }
th { color: #75716a; font-weight: 500; border-bottom: 1px solid #b9b4aa; white-space: normal;
  vertical-align: bottom; line-height: 1.25; }
td { border-bottom: 1px solid #eeebe6; }
.summary table { font-size: 0.95rem; }
.summary th:first-child, .summary td:first-child { text-align: left; }
svg { display: block; width: 100%; margin: 0 0 1.2rem; }
svg text { font: 13px system-ui, -apple-system, "Segoe UI", Roboto, sans-serif; fill: #5d5952; }
svg .grid { stroke: #eeebe6; }
svg .axis { stroke: #b9b4aa; }
)";

constexpr std::string_view kExplanation =
    "<p>A triangulation of order k has at most k points inside the circumcircle of any triangle; "
    "k&nbsp;=&nbsp;0 is the Delaunay triangulation. For each k, <em>value</em> is the best that "
    "was found, and no triangulation of order k can be better than <em>bound</em>; "
    "<em>proved</em> means that it is reached. "
    "<em>Change</em> is against the Delaunay triangulation, <em>order</em> the largest order of a "
    "triangle, <em>smallest angle</em> that of the whole mesh, <em>mean</em> that of the angles "
    "that a value adds up, <em>seconds</em> the time of search, bound and verification.";

constexpr std::string_view kPitsExplanation =
    " <em>Interior</em> are the local minima that are not on the "
    "hull. How deep these pits are until they flow over: <em>pit depth</em> is the sum, "
    "<em>deepest</em> the largest. <em>Pit volume</em> is the water that stands on the surface "
    "once all are full.";

/// The file's name as a title: no folders, no extension.
std::string title_of(const std::string& input) {
  if (input == "-") return "points from standard input";
  std::filesystem::path name = std::filesystem::path(input).filename();
  if (name.extension() == ".gz") name = name.stem();
  return display_name(name.stem());
}

std::string head(const std::string& title) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}</title>\n<style>{}</style>\n</head>\n",
      escaped(title), kStyle);
}

std::string facts_list(const Comparison& comparison, const std::string& input,
                       const std::string& constraints) {
  std::string html = "<dl>\n";
  const auto add = [&](const std::string& name, const std::string& text) {
    html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escaped(name), escaped(text));
  };
  if (input != "-") add("file", display_name(std::filesystem::path(input).filename()));
  for (const auto& [name, text] : facts_of(comparison)) add(name, text);
  if (!constraints.empty()) add("constraints", constraints);
  return html + "</dl>\n";
}

/// The section of an objective, or of several in order.
std::string anchor_of(const ObjectiveComparison& objective) {
  return names_of(objective.objectives, "+");
}

std::string link_to(const ObjectiveComparison& objective) {
  return fmt::format("<a href=\"#{}\">{}</a>", anchor_of(objective), objective.title());
}

template <class CellText>
std::string table_row(const std::vector<std::string>& cells, std::string_view tag,
                      const CellText& text) {
  std::string html = "<tr>";
  for (std::size_t i = 0; i < cells.size(); ++i)
    html += fmt::format("<{}>{}</{}>", tag, text(i, cells[i]), tag);
  return html + "</tr>\n";
}

template <class CellText>
std::string html_table(const Table& table, std::string_view name, const CellText& text) {
  const auto plain = [](std::size_t, const std::string& cell) { return escaped(cell); };
  std::string html = fmt::format("<div class=\"{}\"><table>\n<thead>\n", name) +
                     table_row(table.headings, "th", plain) + "</thead>\n<tbody>\n";
  for (const auto& row : table.rows) html += table_row(row, "td", text);
  return html + "</tbody>\n</table></div>\n";
}

/// A link, if some objectives have this title.
std::string link_to_title(const Comparison& comparison, const std::string& title) {
  for (const ObjectiveComparison& objective : comparison.objectives)
    if (objective.title() == title) return link_to(objective);
  return escaped(title);
}

/// What is gained at best, and what gains nothing.
std::string summary(const Comparison& comparison) {
  std::string html;
  if (const Table table = summary_table(comparison); !table.rows.empty())
    html += html_table(table, "summary", [&](std::size_t column, const std::string& cell) {
      return column == 0 ? link_to_title(comparison, cell) : escaped(cell);
    });
  std::string unchanged;
  for (const ObjectiveComparison& objective : comparison.objectives)
    if (!objective.why_unchanged.empty())
      unchanged += (unchanged.empty() ? "" : ", ") + link_to(objective);
  if (!unchanged.empty()) html += fmt::format("<p>No order changes {}.</p>\n", unchanged);
  return html;
}

std::string charts_and_tables(const Comparison& comparison, const ObjectiveComparison& objective) {
  const auto plain = [](std::size_t, const std::string& cell) { return escaped(cell); };
  std::string html =
      comparison_chart(objective) + html_table(table_of(comparison, objective), "scroll", plain);
  for (std::size_t i = 0; i + 1 < objective.objectives.size(); ++i) {
    const ObjectiveComparison later = objective.by_later(i);
    html += fmt::format("<h3>then {}{}</h3>\n", later.title(), given_text(later)) +
            comparison_chart(later) + html_table(later_table(objective, i), "scroll", plain);
  }
  return html;
}

std::string section(const Comparison& comparison, const ObjectiveComparison& objective) {
  return fmt::format("<section>\n<h2 id=\"{}\">{}{}</h2>\n{}</section>\n", anchor_of(objective),
                     objective.title(), given_text(objective),
                     charts_and_tables(comparison, objective));
}

std::string folded(const Comparison& comparison, const ObjectiveComparison& objective) {
  return fmt::format("<details id=\"{}\">\n<summary><b>{}</b>: {}</summary>\n{}</details>\n",
                     anchor_of(objective), objective.title(), escaped(objective.why_unchanged),
                     charts_and_tables(comparison, objective));
}

constexpr std::string_view kLaterExplanation =
    " Of objectives in order each counts among the triangulations that are as good for those "
    "before it.";

}  // namespace

std::string comparison_page(const Comparison& comparison, const std::string& input,
                            const std::string& constraints) {
  const std::string title = fmt::format("What higher orders gain: {}", title_of(input));
  std::string html = head(title) + fmt::format("<body>\n<h1>{}</h1>\n", escaped(title));
  html +=
      facts_list(comparison, input, constraints) + summary(comparison) + std::string(kExplanation);
  if (comparison.delaunay_pits) html += kPitsExplanation;
  if (std::any_of(comparison.objectives.begin(), comparison.objectives.end(),
                  [](const auto& each) { return each.objectives.size() > 1; }))
    html += kLaterExplanation;
  html += "</p>\n";
  std::string unchanged;
  for (const ObjectiveComparison& objective : comparison.objectives)
    if (objective.why_unchanged.empty())
      html += section(comparison, objective);
    else
      unchanged += folded(comparison, objective);
  if (!unchanged.empty())
    html += fmt::format("<section>\n<h2>What no order changes</h2>\n{}</section>\n", unchanged);
  return html + "</body>\n</html>\n";
}

}  // namespace hodt::app
