// hodt formats: what can be read and written, and what is kept.
// Tested by tests/app/formats_test.cpp.
#include "hodt/io/formats.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "app/common.h"
#include "app/outputs.h"
#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/raster_file.h"

namespace hodt::app {

namespace {

using Row = std::vector<std::string>;

struct Arguments {
  bool is_markdown = false;
  std::string json;
};

struct Column {
  std::string_view title;
  Use use;
};
constexpr Column kReads[] = {
    {"points", Use::read_points}, {"features", Use::read_features}, {"mesh", Use::read_tin}};
constexpr Column kWrites[] = {
    {"points", Use::write_points}, {"mesh", Use::write_tin}, {"features", Use::write_features}};

/// What the format can be used for, as words.
template <std::size_t N>
std::vector<std::string_view> uses_of(const Format& format, const Column (&columns)[N]) {
  std::vector<std::string_view> uses;
  for (const Column& column : columns)
    if (can(format, column.use)) uses.push_back(column.title);
  return uses;
}

/// Rasters are sampled from a mesh.
std::vector<std::string_view> written_by(const Format& format) {
  std::vector<std::string_view> uses = uses_of(format, kWrites);
  const auto extensions = extensions_of(format);
  if (std::any_of(extensions.begin(), extensions.end(), [](std::string_view extension) {
        return is_raster_name(fmt::format("a{}", extension));
      }))
    uses.push_back("raster");
  return uses;
}

std::vector<Row> table() {
  std::vector<Row> rows = {
      {"format", "file names", "reads", "writes", "heights exact", "CRS", "order"}};
  for (const Format& format : formats()) {
    const auto kept = [&](bool is_kept) {
      return !can(format, Use::write_tin) ? "" : is_kept ? "yes" : "no";
    };
    rows.push_back({std::string(format.name),
                    fmt::format("{}", fmt::join(extensions_of(format), ", ")),
                    fmt::format("{}", fmt::join(uses_of(format, kReads), ", ")),
                    fmt::format("{}", fmt::join(written_by(format), ", ")),
                    kept(format.keeps.heights), kept(format.keeps.crs), kept(format.keeps.order)});
  }
  return rows;
}

std::string markdown() {
  std::string text;
  bool is_title = true;
  for (const Row& row : table()) {
    text += fmt::format("| {} |\n", fmt::join(row, " | "));
    if (is_title) {
      for (std::size_t i = 0; i < row.size(); ++i) text += "|---";
      text += "|\n";
    }
    is_title = false;
  }
  return text;
}

/// Some of the table depend on a library that may be missing where hodt runs.
std::string about_gdal() {
  std::string state = "it is there";
  try {
    check_raster_output("any.tif");
  } catch (const ParameterError& error) {
    state = error.what();
  }
  return fmt::format("Map features but GeoJSON, and rasters, need GDAL: {}.\n", state);
}

std::string plain_text() {
  const std::vector<Row> rows = table();
  std::vector<std::size_t> widths(rows.front().size());
  for (const Row& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  std::string text;
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) line += fmt::format("{:<{}}  ", row[i], widths[i]);
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text +
         "\nWhat can be read may also be packed with gzip, the name ending in .gz, and points may "
         "be "
         "written so.\nThe last three columns are of meshes that are written.\n" +
         about_gdal();
}

Json to_json(const Format& format) {
  Json keeps = nullptr;
  if (can(format, Use::write_tin))
    keeps = {{"heights", format.keeps.heights},
             {"crs", format.keeps.crs},
             {"order", format.keeps.order}};
  return {{"name", format.name},
          {"extensions", extensions_of(format)},
          {"packed", format.can_be_packed},
          {"reads", uses_of(format, kReads)},
          {"writes", written_by(format)},
          {"keeps", keeps}};
}

int run(const Arguments& arguments) {
  Json all = Json::array();
  for (const Format& format : formats()) all.push_back(to_json(format));
  Outputs outputs;
  outputs.write_json(all, arguments.json);
  outputs.commit(arguments.is_markdown ? markdown() : plain_text());
  return kOk;
}

}  // namespace

void add_formats(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App& command =
      *app.add_subcommand("formats", "List the formats of files, and what meshes keep in them");
  command.add_flag("--markdown", arguments->is_markdown, "Print the table as Markdown");
  command.add_option("--json", arguments->json, "Write the list as JSON; - is standard output")
      ->type_name("FILE");
  command.footer(
      "heights exact: every bit of x, y and z stays. CRS: the coordinate reference system is\n"
      "kept. order: triangles keep how many points their circles hold.\n"
      "Examples:\n"
      "  hodt formats\n"
      "  hodt formats --json -");
  command.callback([arguments, &action] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace hodt::app
