#include "app/command_line.h"

namespace hodt::app {

std::unique_ptr<CLI::App> command_line(Action& action) {
  auto app = std::make_unique<CLI::App>(
      "Higher order Delaunay triangulations: terrain meshes of controlled quality.", "hodt");
  app->set_version_flag("--version", "hodt " HODT_VERSION);
  app->require_subcommand(1);
  app->failure_message([](const CLI::App*, const CLI::Error& error) { return error.what(); });
  app->footer("'hodt COMMAND --help' explains a command, with examples.");
  add_triangulate(*app, action);
  add_check(*app, action);
  add_info(*app, action);
  add_sample(*app, action);
  add_edges(*app, action);
  add_triangles(*app, action);
  add_voronoi(*app, action);
  add_compare(*app, action);
  add_contours(*app, action);
  add_formats(*app, action);
  add_raster(*app, action);
  return app;
}

}  // namespace hodt::app
