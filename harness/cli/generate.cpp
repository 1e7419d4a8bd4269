#include <fmt/format.h>

#include <memory>

#include "harness/cli/verbs.h"
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

}  // namespace

Verb add_generate(CLI::App& program) {
  CLI::App* page = program.add_subcommand("generate", "Draw instances of a family into a file");
  auto arguments = std::make_shared<GenerateArguments>();
  page->add_option("FAMILY", arguments->family,
                   "NAME[:key=value,...] (see: lcpbench list families)")
      ->required();
  page->add_option("--count", arguments->count, "Instances; default: the family's")
      ->check(CLI::PositiveNumber);
  page->add_option("--seed", arguments->seed, "Same seed, same bits")->capture_default_str();
  page->add_option("--out", arguments->out, "File to write: .hdf5, or NAME.M.mtx for one instance")
      ->required();
  page->footer("Example:\n  lcpbench generate squat-like:contacts=8 --count 20 --out squat.hdf5");
  return {page, [arguments] { return generate_to_file(*arguments); }};
}

}  // namespace lcp::cli
