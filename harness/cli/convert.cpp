#include <fmt/format.h>

#include "harness/cli/page.h"
#include "harness/cli/reading.h"
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

void convert_options(CLI::App& page, ConvertArguments& arguments) {
  add(page, "IN", arguments.in, "FILE, FILE#NAME or directory")->required();
  add(page, "OUT", arguments.out, "File to write; its ending says the format")->required();
  add_reading_option(page, arguments.reading);
}

}  // namespace

Verb add_convert(CLI::App& program) {
  return make_verb<ConvertArguments>(
      program, "convert", "Write instances in another format", convert_options, convert,
      "Example:\n  lcpbench convert squat.hdf5#squat-like/0003 third.M.mtx");
}

}  // namespace lcp::cli
