#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "harness/measure/solve.h"

namespace lcp::cli {

/// Adds --start, repeatable, to the page of a verb that solves instances; `starts` are then names of
/// StartKinds.
void add_start_option(CLI::App& page, std::vector<std::string>& starts);

/// The kinds of start named, each once, in the order of all_start_kinds.
std::vector<StartKind> start_kinds(const std::vector<std::string>& names);

}  // namespace lcp::cli
