#include "app/comparison_page.h"

#include "app/comparison_chart.h"
#include "app/comparison_table.h"
#include <fmt/format.h>

#include "hodt/picture/markup.h"

namespace hodt::app {

namespace {

constexpr std::string_view kStyle = R"(
body { margin: 0 auto; max-width: 60rem; padding: 2.5rem 1.5rem 4rem; background: #ffffff;
  color: #2b2a28; font: 16px/1.55 system-ui, -apple-system, "Segoe UI", Roboto, sans-serif; }
h1 { font-size: 1.7rem; font-weight: 600; margin: 0 0 0.3rem; }
h2 { font-size: 1.2rem; font-weight: 600; margin: 3.2rem 0 0.8rem; padding-top: 1.2rem;
  border-top: 1px solid #e4e1db; }
p { max-width: 44rem; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 0.15rem 1.2rem; margin: 1.2rem 0; }
dt { color: #75716a; }
dd { margin: 0; }
nav a { margin-right: 1.1rem; white-space: nowrap; color: #0f55a8; text-decoration: none; }
nav a:hover { text-decoration: underline; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-size: 0.9rem;
  font-variant-numeric: tabular-nums; }
th, td { padding: 0.32rem 0.6rem; text-align: right; white-space: nowrap; }
th { color: #75716a; font-weight: 500; border-bottom: 1px solid #b9b4aa; }
td { border-bottom: 1px solid #eeebe6; }
svg { display: block; width: 100%; margin: 0 0 1.2rem; }
svg text { font: 13px system-ui, -apple-system, "Segoe UI", Roboto, sans-serif; fill: #5d5952; }
svg .grid { stroke: #eeebe6; }
svg .axis { stroke: #b9b4aa; }
)";

constexpr std::string_view kExplanation =
    "<p>A triangulation of order k has at most k points inside the circumcircle of any triangle; "
    "k&nbsp;=&nbsp;0 is the Delaunay triangulation. For each k, <em>value</em> is the best that "
    "was found, and no triangulation of order k can be better than <em>bound</em>. "
    "<em>Change</em> is against the Delaunay triangulation, <em>order</em> the largest order of a "
    "triangle, <em>smallest angle</em> that of the whole mesh, <em>seconds</em> the time of "
    "search, bound and verification. <em>Interior</em> are the local minima that are not on the "
    "hull. How deep these pits are until they flow over: <em>pit depth</em> is the sum, "
    "<em>deepest</em> the largest. <em>Pit volume</em> is the water that stands on the surface "
    "once all are full.</p>\n";

std::string head(const std::string& title) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}</title>\n<style>{}</style>\n</head>\n",
      escaped(title), kStyle);
}

std::string facts_list(const Comparison& comparison) {
  std::string html = "<dl>\n";
  for (const auto& [name, text] : facts_of(comparison))
    html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escaped(name), escaped(text));
  return html + "</dl>\n";
}

std::string links(const Comparison& comparison) {
  if (comparison.objectives.size() < 2) return {};
  std::string html = "<nav>\n";
  for (const ObjectiveComparison& objective : comparison.objectives) {
    const std::string name = name_of(objective.objective);
    html += fmt::format("<a href=\"#{}\">{}</a>\n", name, name);
  }
  return html + "</nav>\n";
}

std::string table_row(const std::vector<std::string>& cells, std::string_view tag) {
  std::string html = "<tr>";
  for (const std::string& cell : cells) html += fmt::format("<{}>{}</{}>", tag, escaped(cell), tag);
  return html + "</tr>\n";
}

std::string html_table(const Table& table) {
  std::string html = "<div class=\"scroll\"><table>\n<thead>\n" + table_row(table.headings, "th") +
                     "</thead>\n<tbody>\n";
  for (const auto& row : table.rows) html += table_row(row, "td");
  return html + "</tbody>\n</table></div>\n";
}

std::string section(const Comparison& comparison, const ObjectiveComparison& objective) {
  const std::string name = name_of(objective.objective);
  return fmt::format("<section>\n<h2 id=\"{}\">{}</h2>\n{}{}</section>\n", name, name,
                     comparison_chart(objective), html_table(table_of(comparison, objective)));
}

}  // namespace

std::string comparison_page(const Comparison& comparison, std::string_view name) {
  const std::string title = fmt::format("What higher orders gain: {}", name);
  std::string html = head(title) + fmt::format("<body>\n<h1>{}</h1>\n", escaped(title));
  html += facts_list(comparison) + std::string(kExplanation) + links(comparison);
  for (const ObjectiveComparison& objective : comparison.objectives)
    html += section(comparison, objective);
  return html + "</body>\n</html>\n";
}

}  // namespace hodt::app
