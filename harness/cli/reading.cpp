#include "harness/cli/reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "harness/cli/page.h"
#include "problems/io/load.h"

namespace lcp::cli {

namespace {

constexpr std::size_t names_listed = 8;  // Of instances, in an error.

}  // namespace

void add_reading_option(CLI::App& page, ReadOptions& reading) {
  add_with_default(page, "--directions", reading.directions,
                   "Friction directions of contacts that come without them (FCLIB, Siconos); even");
}

std::vector<Instance> read_instances(const std::string& where, const ReadOptions& reading) {
  return load_instances(
      where, [](const std::string& line) { fmt::print(stderr, "left out: {}\n", line); }, reading);
}

Instance read_instance(const std::string& where, const ReadOptions& reading) {
  std::vector<Instance> instances = read_instances(where, reading);
  if (instances.size() == 1) return std::move(instances.front());
  std::string names;
  for (std::size_t k = 0; k < std::min(instances.size(), names_listed); ++k)
    names += (k > 0 ? ", " : "") + instances[k].name;
  if (instances.size() > names_listed) names += ", ...";
  throw std::invalid_argument(
      fmt::format("{} holds {} instances, expected one: name it as FILE#NAME: {}", where,
                  instances.size(), names));
}

}  // namespace lcp::cli
