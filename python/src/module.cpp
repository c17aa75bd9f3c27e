// The extension module hodt._hodt: arrays in, arrays out. What users see of it is python/hodt.
#include "sections.h"

NB_MODULE(_hodt, module) {
  module.attr("__version__") = HODT_VERSION;
  hodt::python::add_errors(module);
  hodt::python::add_jobs(module);
  hodt::python::add_delaunay(module);
  hodt::python::add_triangulate(module);
  hodt::python::add_lists(module);
  hodt::python::add_voronoi(module);
  hodt::python::add_compare(module);
  hodt::python::add_mesh(module);
  hodt::python::add_files(module);
}
