#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "harness/cli/verbs.h"
#include "harness/present/figure.h"

namespace lcp::cli {

/// The parts of the verb `stability`, one per file.
Verb add_stability_perturb(CLI::App& page);

Verb add_stability_loop(CLI::App& page);
Verb add_stability_frontier(CLI::App& stability);

/// What a study says of itself.
struct StudyPages {
  std::string text, csv, json;
  std::function<Figure()> figure;  ///< Empty where there is nothing to draw.
};

/// Writes `directory`/NAME.txt, .csv, .json and .svg, and prints the page of --format. Throws
/// UnwritableOutput.
void write_pages(const std::filesystem::path& directory, const std::string& name,
                 const StudyPages& pages, const std::string& format);

/// Says that an interrupted run can go on; returns the exit status.
int report_interruption(const std::string& rows, const std::filesystem::path& directory);

}  // namespace lcp::cli
