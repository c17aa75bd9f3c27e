// The parts of the extension module, each in a file of its own.
#pragma once

#include <nanobind/nanobind.h>

namespace hodt::python {

void add_errors(nanobind::module_& module);
void add_jobs(nanobind::module_& module);
void add_delaunay(nanobind::module_& module);
void add_triangulate(nanobind::module_& module);
void add_lists(nanobind::module_& module);
void add_voronoi(nanobind::module_& module);
void add_compare(nanobind::module_& module);
void add_mesh(nanobind::module_& module);
void add_files(nanobind::module_& module);

}  // namespace hodt::python
