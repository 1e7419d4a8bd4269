#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "problems/instance.h"
#include "problems/io/read_options.h"

namespace lcp::cli {

/// Adds --directions to the page of a verb that reads instances.
void add_reading_option(CLI::App& page, ReadOptions& reading);

/// Instances at `where` (see load_instances); files of a directory that cannot be read are left out
/// and named on stderr.
std::vector<Instance> read_instances(const std::string& where, const ReadOptions& reading);

/// The only instance at `where`; throws std::invalid_argument with their names where there are several.
Instance read_instance(const std::string& where, const ReadOptions& reading);

}  // namespace lcp::cli
