#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "harness/judge/acceptance.h"

namespace lcp::cli {

/// Options that verbs have in common which put a solver into the loop of a scene.
struct LoopOptions {
  std::string duration, dt;  ///< Empty: the scene's.
  std::string criterion = "residual";
  std::optional<double> tolerance;  ///< Of the criterion; its own default where empty.

  /// s. Throw std::invalid_argument on text that is not a duration.
  std::optional<double> duration_s() const;
  std::optional<double> dt_s() const;
  Acceptance acceptance() const;
};

void add_loop_options(CLI::App& page, LoopOptions& options);

/// A duration in s; empty where the text is. Throws as parse_duration.
std::optional<double> parse_seconds(const std::string& text, const char* option);

}  // namespace lcp::cli
