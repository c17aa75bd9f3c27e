#include "app/record_lists.h"

#include "app/outputs.h"
#include <fmt/format.h>

#include "hodt/base/parallel.h"
#include "hodt/delaunay/delaunay.h"
#include "hodt/io/number_text.h"

namespace hodt::app {

void add_list_options(CLI::App& command, ListArguments& arguments, const std::string& classes) {
  add_points_input(command, arguments.input);
  command.add_option("-k,--order", arguments.order, "The largest order to list (default: 4)")
      ->type_name("K");
  command.add_option("--class", arguments.list_class, classes)->type_name("CLASS");
  command
      .add_option("-o,--output", arguments.output,
                  "CSV to write; vertices are data rows of the input, from 0; - is standard output")
      ->required()
      ->type_name("OUT");
  add_constraints(command, arguments.constraints);
  add_threads(command, arguments.threads);
}

CsvLines::CsvLines(OutputFile& file, std::string_view header) : file_(file), text_(header) {
  text_ += '\n';
}

void CsvLines::add(std::span<const Index> numbers) {
  constexpr std::size_t kPiece = 1 << 20;
  for (const Index number : numbers) {
    append_number(text_, number);
    text_ += ',';
  }
  text_.back() = '\n';
  ++count_;
  if (text_.size() > kPiece) flush();
}

void CsvLines::flush() {
  file_.write(text_);
  text_.clear();
}

int write_list(const ListArguments& arguments, std::string_view header, std::string_view things,
               const ProduceLines& produce) {
  const Order k = parse_order(arguments.order);
  const ThreadLimit limit(parse_threads(arguments.threads));
  check_choices(arguments.input);
  check_targets(arguments.input, arguments.output, {});
  const std::string input = arguments.input.name();
  check_constraints(arguments.constraints, input, arguments.output, {});
  std::string summary;
  Outputs outputs;
  {
    TerminalProgress progress;
    progress.report("reading");
    InputPoints read = read_input_points(arguments.input);
    const Joined joined =
        read_constraints(arguments.constraints, input, read.system, std::move(read.points));
    const PointSet& points = joined.points;
    progress.report("Delaunay triangulation");
    const auto [triangulation, duplicates, constraints] = delaunay_of_joined(input, joined);
    const std::size_t distinct = triangulation.vertices.size();
    DelaunayGraph graph(triangulation);
    graph.list_neighbours();
    progress.report(fmt::format("{} of order {} or less", things, k.digits));
    CsvLines lines(outputs.open(arguments.output), header);
    // No circle holds more than n - 3 points beside those on it.
    produce(graph, std::min<Index>(k.limit, Index(distinct)),
            row_numbering(triangulation.vertices, points.size()), lines);
    lines.flush();
    summary = fmt::format("{:<9} {}, {} dropped\n", "points", points.size(),
                          counted(duplicates, "duplicate"));
    if (arguments.constraints.any()) summary += constraints_text(joined.report, constraints, 11);
    summary += fmt::format("{:<9} {}, {} of order {} or less\n", things, lines.count(),
                           arguments.list_class, k.digits);
    summary += inputs_text(read, 9);
    summary += fmt::format("{:<9} {}\n", "written", shown(arguments.output));
    print_warnings(read);
    print_warnings(joined);
  }
  outputs.commit(summary);
  return kOk;
}

}  // namespace hodt::app
