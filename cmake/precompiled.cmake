# hodt_precompile(target [headers...]): with HODT_PRECOMPILE, headers that take long to read are read once for the
# target, if it has more than two sources. They go on to include what they use: a build without finds what is
# missing.
function(hodt_precompile target)
  get_target_property(sources ${target} SOURCES)
  list(LENGTH sources count)
  if(HODT_PRECOMPILE AND count GREATER 2)
    target_precompile_headers(${target} PRIVATE <algorithm> <functional> <string> <vector> <fmt/format.h>
                                                ${PROJECT_SOURCE_DIR}/src/hodt/base/parallel.h ${ARGN})
  endif()
endfunction()
