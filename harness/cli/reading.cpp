#include "harness/cli/reading.h"

#include <fmt/format.h>

#include <cstdio>

#include "problems/io/load.h"

namespace lcp::cli {

void add_reading_option(CLI::App& page, ReadOptions& reading) {
  page.add_option("--directions", reading.directions,
                  "Friction directions of contacts that come without them (FCLIB, Siconos); even")
      ->capture_default_str();
}

std::vector<Instance> read_instances(const std::string& where, const ReadOptions& reading) {
  return load_instances(
      where, [](const std::string& line) { fmt::print(stderr, "left out: {}\n", line); }, reading);
}

}  // namespace lcp::cli
