#include <fmt/format.h>

#include "harness/cli/page.h"
#include "problems/io/load.h"
#include "problems/registry.h"

namespace lcp::cli {

namespace {

struct GenerateArguments {
  std::string family;
  Index count = 0;
  std::uint64_t seed = 1;
  std::string out;
};

int generate_to_file(const GenerateArguments& arguments) {
  const std::vector<Instance> instances =
      generate(arguments.family, {.count = arguments.count, .seed = arguments.seed});
  save_instances(arguments.out, instances);
  fmt::print(stderr, "{} instances are in {}\n", instances.size(), arguments.out);
  return done;
}

void generate_options(CLI::App& page, GenerateArguments& arguments) {
  add(page, "FAMILY", arguments.family, "NAME[:key=value,...] (see: lcpbench list families)")
      ->required();
  add(page, "--count", arguments.count, "Instances; default: the family's", CLI::PositiveNumber);
  add_with_default(page, "--seed", arguments.seed, "Same seed, same bits");
  add(page, "--out", arguments.out, "File to write: .hdf5, or NAME.M.mtx for one instance")
      ->required();
}

}  // namespace

Verb add_generate(CLI::App& program) {
  return make_verb<GenerateArguments>(
      program, "generate", "Draw instances of a family into a file", generate_options,
      generate_to_file,
      "Example:\n  lcpbench generate squat-like:contacts=8 --count 20 --out squat.hdf5");
}

}  // namespace lcp::cli
