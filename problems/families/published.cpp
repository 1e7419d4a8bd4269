// published: the table of problems/published.h as a family, in the order of the table. Nothing is
// drawn at random, and a seed changes nothing.

#include "problems/published.h"

#include "problems/registry.h"
#include "solvers/errors.h"

namespace lcp {

namespace {

struct Knobs {};

OptionTable table(Knobs&) { return {}; }

std::vector<Instance> first_instances(const Knobs&, const Draw& draw) {
  const std::vector<PublishedInstance>& all = published_instances();
  const Index known = static_cast<Index>(all.size());
  if (draw.count < 0 || draw.count > known)
    throw InvalidArgument("published: {} instances asked for, expected 1 ... {}", draw.count,
                          known);
  std::vector<Instance> instances;
  for (Index i = 0; i < draw.count; ++i) instances.push_back(all[i].instance);
  return instances;
}

const FamilyRegistration registration{
    {.name = "published",
     .summary = "small LCPs from books, papers and test suites: cycling, rays, ties, exponential "
                "families",
     .source = "each instance names its own",
     .default_count = static_cast<Index>(published_instances().size())},
    Knobs{},
    table,
    first_instances};

}  // namespace

}  // namespace lcp
