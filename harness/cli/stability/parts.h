#pragma once

#include <filesystem>
#include <string>

#include "harness/cli/verbs.h"
#include "harness/present/described.h"

namespace lcp::cli {

/// The parts of the verb `stability`, one per file.
Verb add_stability_perturb(CLI::App& page);

Verb add_stability_loop(CLI::App& page);
Verb add_stability_frontier(CLI::App& stability);

/// Writes a study to `directory`/NAME.txt, .csv and .json, prints it in the format, and then draws NAME.svg
/// where it has a figure. Throws UnwritableOutput.
void write_pages(const std::filesystem::path& directory, const std::string& name,
                 const Described& study, const std::string& format);

/// Says that an interrupted run can go on; returns the exit status.
int report_interruption(const std::string& rows, const std::filesystem::path& directory);

}  // namespace lcp::cli
