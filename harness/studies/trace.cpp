#include "harness/studies/trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "problems/decompositions.h"

namespace lcp {

std::string variable_name(int variable, Index n) {
  if (variable == 2 * n) return "z0";
  return variable < n ? fmt::format("w_{}", variable + 1) : fmt::format("z_{}", variable - n + 1);
}

Trace::Trace(const Problem& problem, const Options& options)
    : scaled_(problem, true), options_(options) {}

Observer Trace::observer() {
  return [this](const PivotEvent& event) {
    Step step{event, {}};
    const bool asked = options_.first <= steps_.size() && steps_.size() < options_.last;
    if (event.basic && asked && scaled_.size() <= options_.largest_condition)
      step.condition = condition(*event.basic);
    step.event.basic = nullptr;  // lives in the solver
    steps_.push_back(step);
  };
}

/// The basis matrix holds, of  I w - M z - c z0 = q,  the columns of the basic variables.
double Trace::condition(const std::vector<int>& basic) const {
  const Index n = scaled_.size();
  MatrixXd B = MatrixXd::Zero(n, n);
  for (Index k = 0; k < n; ++k) {
    const Index variable = basic[k];
    if (variable < n) {
      B(variable, k) = 1;
    } else if (variable < 2 * n) {
      B.col(k) = -scaled_.M().col(variable - n);
    } else {
      B.col(k) = -scaled_.c();
    }
  }
  const VectorXd values = small_singular_values(B);
  const double least = values(n - 1);
  return least > 0 ? values(0) / least : std::numeric_limits<double>::infinity();
}

std::string Trace::text() const {
  if (steps_.empty()) return "  no pivots\n";
  const bool search = std::any_of(steps_.begin(), steps_.end(), [](const Step& step) {
    return step.event.parent != step.event.node - 1;
  });
  const Index n = scaled_.size();
  std::string out = fmt::format("  {:>6} {:>7} {:>7} {:>11} {:>5} {:>11} {:>10}", "pivot", "enters",
                                "leaves", "ratio", "tied", "pivot size", "condition");
  out += search ? fmt::format(" {:>6} {:>6}\n", "node", "parent") : "\n";
  for (std::size_t k = 0; k < steps_.size(); ++k) {
    const PivotEvent& event = steps_[k].event;
    out += fmt::format("  {:>6} {:>7} {:>7} {:>11.4g} {:>5} {:>11.4g} {:>10}", k + 1,
                       variable_name(event.entering, n), variable_name(event.leaving, n),
                       event.ratio, event.tied, event.pivot,
                       steps_[k].condition ? fmt::format("{:.3g}", *steps_[k].condition) : "-");
    out += search ? fmt::format(" {:>6} {:>6}\n", event.node, event.parent) : "\n";
  }
  return out;
}

nlohmann::ordered_json Trace::json() const {
  const Index n = scaled_.size();
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Step& step : steps_) {
    const PivotEvent& event = step.event;
    json.push_back({{"entering", variable_name(event.entering, n)},
                    {"leaving", variable_name(event.leaving, n)},
                    {"row", event.row},
                    {"ratio", event.ratio},
                    {"tied", event.tied},
                    {"pivot", event.pivot},
                    {"condition", nullptr},
                    {"node", event.node},
                    {"parent", event.parent}});
    if (step.condition) json.back()["condition"] = *step.condition;
  }
  return json;
}

}  // namespace lcp
