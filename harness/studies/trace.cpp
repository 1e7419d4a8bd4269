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

std::vector<Column<Trace::Step>> Trace::columns() const {
  const auto name = [n = scaled_.size()](int variable) { return variable_name(variable, n); };
  return {
      {{"", "pivot"},
       [this](const Step& step) { return fmt::format("{:>5}", &step - steps_.data() + 1); }},
      {{"entering", "enters"}, [name](const Step& step) { return name(step.event.entering); }},
      {{"leaving", "leaves"}, [name](const Step& step) { return name(step.event.leaving); }},
      {{"row"}, [](const Step& step) { return step.event.row; }},
      {{"ratio", "ratio", "", "{:.4g}"}, [](const Step& step) { return step.event.ratio; }},
      {{"tied", "tied"}, [](const Step& step) { return step.event.tied; }},
      {{"pivot", "pivot size", "", "{:.4g}"}, [](const Step& step) { return step.event.pivot; }},
      {{"condition", "condition", "", "{:.3g}"},
       [](const Step& step) { return step.condition ? Cell(*step.condition) : Cell(); }},
      {{"node", "node"}, [](const Step& step) { return step.event.node; }},
      {{"parent", "parent"}, [](const Step& step) { return step.event.parent; }}};
}

std::string Trace::text() const {
  if (steps_.empty()) return "  no pivots\n";
  std::vector<Column<Step>> shown = columns();
  const bool search = std::any_of(steps_.begin(), steps_.end(), [](const Step& step) {
    return step.event.parent != step.event.node - 1;
  });
  if (!search) shown.resize(shown.size() - 2);  // node and parent
  return text_table(cells_of(shown, steps_), {.indent = "  "});
}

nlohmann::ordered_json Trace::json() const {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Step& step : steps_) json.push_back(json_object(columns(), step));
  return json;
}

}  // namespace lcp
