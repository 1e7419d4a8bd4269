#pragma once

#include <CLI/CLI.hpp>
#include <atomic>
#include <filesystem>
#include <functional>
#include <string>

#include "harness/measure/runner.h"
#include "harness/present/described.h"

namespace lcp::cli {

/// How a study is printed, and where it is written.
struct StudyOutput {
  std::string format = "text";
  bool json = false, dry_run = false;
  std::string out;  ///< Directory; empty: none.
};

/// --format, --json, --dry-run and --out of a study whose files are called NAME.txt, ...
void add_study_output(CLI::App& page, StudyOutput& output, const std::string& name);

/// Writes NAME.txt, .csv and .json. Throws UnwritableOutput.
void write_texts(const std::filesystem::path& directory, const std::string& name,
                 const Described& study);

/// Prints a study as text, csv or json.
void print(const Described& study, const std::string& format);

/// Prints what `make` describes, and writes it with its picture and env.json into a new directory where
/// one is named. Returns an ExitStatus; an Interrupted that `make` throws is one.
int publish(const StudyOutput& output, const std::string& name,
            const std::function<Described(const std::function<void(const Progress&)>& progress,
                                          const std::atomic<bool>& interrupted)>& make);

}  // namespace lcp::cli
