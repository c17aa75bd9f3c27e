#include "hodt/optimize/solve/selection_parts.h"

namespace hodt {

std::vector<SelectionPart> parts_of(const SelectionProblem& problem, const SelectionKernel& kernel,
                                    const Deadline& deadline) {
  std::vector<SelectionPart> parts;
  Buffer<bool> is_seen(problem.edges_of.size(), false);
  for (Index seed = 0; seed < is_seen.size(); ++seed) {
    if (!kernel.has_target(seed) || is_seen[seed]) continue;
    std::vector<Index> targets{seed};
    is_seen[seed] = true;
    const auto see = [&](Index edge) {
      for (const Index t : kernel.targets_of(edge)) {
        if (is_seen[t]) continue;
        is_seen[t] = true;
        targets.push_back(t);
      }
    };
    for (std::size_t i = 0; i < targets.size(); ++i)
      for (const Index e : kernel.edges_of(targets[i])) {
        deadline.check();
        see(e);
        for (const Index rival : kernel.rivals(e)) see(rival);
      }
    std::sort(targets.begin(), targets.end());
    parts.push_back(part_of(
        problem, std::move(targets), [&](Index t) { return kernel.edges_of(t); },
        [&](Index e) { return kernel.rivals(e); }));
  }
  return parts;
}

}  // namespace hodt
