#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace lcp::cli {

/// Adds --start to the page of a verb that solves instances; `start` is then a name of a StartKind.
void add_start_option(CLI::App& page, std::string& start);

}  // namespace lcp::cli
