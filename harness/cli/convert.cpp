#include <fmt/format.h>

#include <memory>

#include "harness/cli/reading.h"
#include "harness/cli/verbs.h"
#include "problems/io/load.h"

namespace lcp::cli {

namespace {

struct ConvertArguments {
  std::string in;
  std::string out;
  ReadOptions reading;
};

int convert(const ConvertArguments& arguments) {
  const std::vector<Instance> instances = read_instances(arguments.in, arguments.reading);
  save_instances(arguments.out, instances);
  fmt::print(stderr, "{} instance{} in {}\n", instances.size(),
             instances.size() == 1 ? " is" : "s are", arguments.out);
  return done;
}

}  // namespace

Verb add_convert(CLI::App& program) {
  CLI::App* page = program.add_subcommand("convert", "Write instances in another format");
  auto arguments = std::make_shared<ConvertArguments>();
  page->add_option("IN", arguments->in, "FILE, FILE#NAME or directory")->required();
  page->add_option("OUT", arguments->out, "File to write; its ending says the format")->required();
  add_reading_option(*page, arguments->reading);
  page->footer("Example:\n  lcpbench convert squat.hdf5#squat-like/0003 third.M.mtx");
  return {page, [arguments] { return convert(*arguments); }};
}

}  // namespace lcp::cli
