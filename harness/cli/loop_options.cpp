#include "harness/cli/loop_options.h"

#include "harness/cli/page.h"
#include "harness/cli/quantity.h"

namespace lcp::cli {

std::optional<double> LoopOptions::duration_s() const {
  return parse_seconds(duration, "--duration");
}

std::optional<double> LoopOptions::dt_s() const { return parse_seconds(dt, "--dt"); }

Acceptance LoopOptions::acceptance() const {
  Acceptance acceptance = criterion == "paper" ? by_paper : Acceptance();
  if (tolerance) acceptance.tolerance = *tolerance;
  return acceptance;
}

void add_loop_options(CLI::App& page, LoopOptions& options) {
  add(page, "--duration", options.duration,
      "Simulated time, number with ms, s or min. Default: the scene's");
  add(page, "--dt", options.dt, "Time step, likewise. Default: the scene's");
  add_with_default(page, "--criterion", options.criterion,
                   "When an answer may act: residual (the judge's natural residual, scaled) or "
                   "paper (|w - M z - q - z0 c| of the solver's own w, unscaled)",
                   CLI::IsMember({"residual", "paper"}));
  add(page, "--tolerance", options.tolerance,
      "Of the criterion. Default: 1e-6 for residual, 1e-3 for paper", CLI::PositiveNumber);
}

std::optional<double> parse_seconds(const std::string& text, const char* option) {
  if (text.empty()) return std::nullopt;
  return std::chrono::duration<double>(parse_duration(text, option)).count();
}

}  // namespace lcp::cli
