#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/judge/acceptance.h"
#include "harness/present/curve.h"
#include "harness/record.h"

namespace lcp {

/// The sheet of a run: speed against accuracy, from its rows alone. Everything that is drawn or
/// printed of it is one of the following.
///
/// *Setting* s: a solver in full spelling, with what it starts from.
/// *Group*: the instances of one corpus, or of all corpora together.
/// *Standing* of a row at accuracy E, judged anew from its residual (judged() of the judge):
/// `unsupported` or `not_run` as stored; `trivial`, where it is solved and z = 0 passes at E too;
/// `solved`; every other verdict is `failed`.
/// *Mass*: solved + failed + trivial + unsupported + not_run = rows of s in the group. A failure has
/// no place in the plane: it lies at its edge, cost infinity, never at the limit of the run.
/// *Counted* D_s: the instances that s solved or failed at, the denominator of each of its shares. So
/// `unsupported`, `not_run` and `trivial` leave it, and instances that nobody solves stay.
/// *Cost* c_{i,s} of a solved instance i: median of its time samples (ms), or a count of work.
///
/// *Profile* (Dolan and More, Math. Program. 91, 2002): share of D_s with r_{i,s} <= tau, where
///   r_{i,s} = (c_{i,s} + o) / (min_t c_{i,t} + o),  t over the settings that solve i,
/// o = 0 for time and `count_offset` for counts, which may be 0; infinite where s failed. Ratios are
/// to the best of the settings at hand: adding or removing one moves the curves of the others, and
/// may swap them (Gould and Scott, ACM TOMS 43, 2016).
/// *Cumulative curve* at accuracy E: share of D_s(E) solved at E with cost <= t.
/// *Accuracy in time* T: share of D_s whose answer, claimed solved, came within T and has a natural
/// residual <= r. Its right end is the share done.
/// *Shifted geometric mean* of cost over the solved: exp(mean log(c + h)) - h, where the shift h is the
/// median over instances of the least cost (plus o for counts). Since settings solve different
/// instances, `slowdown` divides it by that of the least costs of the same instances.
/// *Front*: settings that no other one dominates in median cost, median residual (both over the
/// solved) and share solved of D_s, i.e. is as good in all three and better in one.
/// *Ladder*: settings of one row that differ in one option alone.

/// Of what cost is made.
enum class Measure { time, pivots, nodes, factorisations };

const std::vector<Measure>& all_measures();
std::string to_string(Measure measure);
/// Throws std::invalid_argument with the list of measures.
Measure measure_from_string(const std::string& name);
/// For a reader, with unit: `time (ms)`, `pivots`.
std::string printed(Measure measure);

struct SheetOptions {
  Measure measure = Measure::time;
  std::optional<double> tolerance;   ///< At which `solved` is judged; without it that of the rows.
  std::vector<std::string> corpora;  ///< Names or patterns; empty takes all.
  /// Of the cumulative curves; natural residual, scaled.
  std::vector<double> accuracies = {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12};
  std::vector<double> budgets_ms = {0.1, 1, 10};  ///< Of the accuracy in time.
  double count_offset = 1;                        ///< o of ratios of counts; above 0.
};

/// Cost of a row; infinity where no time was sampled.
double cost_of(const Record& record, Measure measure);

struct Mass {
  Index instances = 0;  ///< Rows; what follows adds up to them.
  Index solved = 0, failed = 0, trivial = 0, unsupported = 0, not_run = 0;

  Index counted() const { return solved + failed; }
  double share_solved() const {
    return counted() == 0 ? 0 : static_cast<double>(solved) / static_cast<double>(counted());
  }
  void add(const Judged& judged);
};

/// Quartiles and median over the instances that a setting solved.
struct Spread {
  double low = 0;
  double median = 0;
  double high = 0;
};

struct Setting {
  std::string solver;  ///< Full spelling.
  std::string start;
  std::string row;    ///< Of the registry, with ` [START]` where rows start differently.
  std::string label;  ///< As in the table.
};

/// One setting on one group.
struct SheetRow {
  std::size_t setting = 0;  ///< Its place in Sheet::settings.
  Mass mass;
  std::optional<Spread> cost;  ///< Empty when nothing was solved.
  std::optional<Spread>
      residual;  ///< Natural, scaled; exact zeros stay 0; empty when nothing was solved.
  std::optional<double> shifted_mean;
  std::optional<double> slowdown;
  Index best = 0;  ///< Instances on which no setting costs less.
  bool front = false;
  Curve profile;                        ///< Of ratios.
  std::vector<Curve> within;            ///< Of costs, one per accuracy.
  std::vector<Curve> accuracy_in_time;  ///< Of residuals, one per budget; with Measure::time alone.
};

/// One step of a ladder against its default, on the instances that both solve.
struct Step {
  std::string value;
  std::size_t row = 0;               ///< Place in Group::rows.
  Index common = 0;                  ///< Instances both solve.
  std::optional<double> cost_ratio;  ///< Median of cost over that at the default value.
  /// Median over them of residual over that at the default value, both at least `residual_floor`.
  std::optional<double> residual_ratio;
};

struct Ladder {
  std::string name;  ///< The row, with whatever else its settings have in common.
  std::string option;
  std::size_t base = 0;     ///< Step that the others are compared with: the row's commonest value.
  std::vector<Step> steps;  ///< Rough to exact: by falling value where values are numbers.
};

struct Group {
  std::string name;  ///< Corpus, or `all_corpora`.
  Index instances = 0;
  Index unsolved_by_all = 0;   ///< Instances counted for some setting and solved by none.
  double shift = 0;            ///< h; 0 where nothing is solved.
  std::vector<SheetRow> rows;  ///< In the order of Sheet::settings; those with rows here.
  std::vector<Ladder> ladders;
};

struct Sheet {
  SheetOptions options;
  double tolerance = 0;
  int jobs = 1;  ///< Most pairs that ran at the same time: it disturbs times.
  std::vector<Setting> settings;
  /// Settings of rows that did none of the work that is measured; in no group.
  std::vector<std::string> without_work;
  /// All corpora together, where there are several, then each in order of appearance.
  std::vector<Group> groups;
};

inline constexpr char all_corpora[] = "all corpora";

/// Smallest residual told from zero where residuals are divided or drawn on a logarithmic axis.
inline constexpr double residual_floor = 1e-18;

/// Computes the sheet. Costs O(rows log rows) per accuracy. A registry row of which some pair brought
/// an answer and none counts any of `measure` is left out and named. Throws std::invalid_argument when
/// a pattern of `corpora` matches none (with the list), and when rows were judged at different
/// tolerances and none is given. Without rows there are no groups.
Sheet make_sheet(const std::vector<Record>& records, const SheetOptions& options = {});

/// Places in `group.rows` of the settings that a picture shows in colour, at most `most`: the best of
/// each registry row by area under its profile (on a logarithmic axis), then the next best ones.
std::vector<std::size_t> highlights(const Sheet& sheet, const Group& group, std::size_t most);

enum class SheetFormat { text, csv, json };

/// `text`: per group the front with numbers and a sentence, and what each ladder buys; `csv`: a line
/// per group and setting; `json`: all of it, curves as their steps,
/// those over cost and residual of the first group alone.
std::string render(const Sheet& sheet, SheetFormat format);

}  // namespace lcp
