#include "harness/studies/frontier/frontier.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "harness/observed_quantile.h"
#include "harness/studies/suites.h"
#include "problems/io/errors.h"

namespace lcp {

namespace {

/// What is kept of a row.
struct DrawOutcome {
  Verdict verdict;
  bool trivial;
  std::int64_t pivots;
};

/// The draws of one cell that are still to be solved.
struct OpenDraws {
  std::size_t x, y;
  std::map<Index, std::vector<std::size_t>> solvers;  ///< By draw, by number.

  std::size_t pairs() const {
    std::size_t sum = 0;
    for (const auto& [draw, which] : solvers) sum += which.size();
    return sum;
  }
};

/// Everything drawn so far, and what is to be drawn.
class Sampling {
 public:
  explicit Sampling(const FrontierPlan& plan) : plan_(plan) {
    for (std::size_t x = 0; x < plan.grid.x.size(); ++x)
      for (std::size_t y = 0; y < plan.grid.y.size(); ++y) {
        const std::string corpus = corpus_of(draw_of_cell(plan.grid, x, y, plan.seed, 0).name);
        for (const NamedSolver& solver : plan.limits.solvers) {
          place_of_[{corpus, solver.spelling}] = samples_.size();
          samples_.push_back({plan.count, {}});
        }
      }
  }

  void take(const Record& record) {
    const auto place = place_of_.find({corpus_of(record.instance), record.solver});
    const std::optional<Index> draw = draw_number(record.instance);
    if (place != place_of_.end() && draw)  // else another question's
      samples_[place->second].outcomes[*draw] = {record.verdict, record.trivial,
                                                 record.work.pivots};
  }

  std::vector<OpenDraws> open() const {
    std::vector<OpenDraws> all;
    for (std::size_t x = 0; x < plan_.grid.x.size(); ++x)
      for (std::size_t y = 0; y < plan_.grid.y.size(); ++y) {
        OpenDraws open{x, y, {}};
        for (std::size_t s = 0; s < solvers(); ++s) {
          const Sample& here = samples_[place(s, x, y)];
          for (Index draw = 0; draw < here.target; ++draw)
            if (!here.outcomes.contains(draw)) open.solvers[draw].push_back(s);
        }
        if (!open.solvers.empty()) all.push_back(std::move(open));
      }
    return all;
  }

  /// Asks for more draws where they would help; false if nowhere.
  bool raise() {
    bool raised = false;
    for (std::size_t s = 0; s < solvers(); ++s)
      for (std::size_t x = 0; x < plan_.grid.x.size(); ++x) {
        const FrontierColumn found = column(s, x);
        const std::vector<bool> wanted =
            more_wanted(found.line, share_points(plan_.grid.y, found), plan_.width());
        for (std::size_t y = 0; y < wanted.size(); ++y) {
          Sample& here = samples_[place(s, x, y)];
          if (!wanted[y] || here.target >= plan_.max_count) continue;
          here.target = std::min(here.target + plan_.count, plan_.max_count);
          raised = true;
        }
      }
    return raised;
  }

  Frontier frontier() const {
    Frontier all{plan_, {}};
    for (std::size_t s = 0; s < solvers(); ++s) {
      FrontierRow row{plan_.limits.solvers[s].spelling, {}};
      for (std::size_t x = 0; x < plan_.grid.x.size(); ++x) row.columns.push_back(column(s, x));
      all.rows.push_back(std::move(row));
    }
    return all;
  }

 private:
  struct Sample {
    Index target = 0;  ///< Draws wanted.
    std::map<Index, DrawOutcome> outcomes;
  };

  std::size_t solvers() const { return plan_.limits.solvers.size(); }
  std::size_t place(std::size_t s, std::size_t x, std::size_t y) const {
    return (x * plan_.grid.y.size() + y) * solvers() + s;
  }

  /// Counts the draws wanted; those beyond, of an earlier session that asked for more, are left
  /// out.
  FrontierCell cell(const Sample& sample) const {
    FrontierCell cell;
    std::vector<std::int64_t> pivots;
    for (const auto& [draw, outcome] : sample.outcomes) {
      if (draw >= sample.target) break;
      ++cell.drawn;
      if (outcome.trivial) continue;
      ++cell.verdicts[outcome.verdict];
      if (outcome.verdict == Verdict::unsupported || outcome.verdict == Verdict::not_run) continue;
      ++cell.counted;
      if (outcome.verdict != Verdict::solved) continue;
      ++cell.solved;
      pivots.push_back(outcome.pivots);
    }
    cell.pivots = observed_quantile(std::move(pivots), 0.5);
    return cell;
  }

  FrontierColumn column(std::size_t s, std::size_t x) const {
    FrontierColumn found;
    for (std::size_t y = 0; y < plan_.grid.y.size(); ++y)
      found.cells.push_back(cell(samples_[place(s, x, y)]));
    const std::vector<SharePoint> points = share_points(plan_.grid.y, found);
    found.line = find_line(points);
    found.settled = settled(found.line, points, plan_.width());
    return found;
  }

  const FrontierPlan& plan_;
  std::map<std::pair<std::string, std::string>, std::size_t>
      place_of_;  ///< By corpus and spelling.
  std::vector<Sample> samples_;
};

/// The plan of one cell's open draws.
RunPlan plan_of(const OpenDraws& open, const FrontierPlan& plan, const std::string& environment) {
  RunPlan cell = plan.limits;
  cell.environment = environment;
  cell.max_samples = 1;  // shares and pivots, no times
  for (const auto& [draw, solvers] : open.solvers) {
    cell.instances.push_back(draw_of_cell(plan.grid, open.x, open.y, plan.seed, draw));
    const Instance& drawn = cell.instances.back();
    for (std::size_t s = 0; s < plan.limits.solvers.size(); ++s)
      if (std::find(solvers.begin(), solvers.end(), s) == solvers.end())
        cell.done.insert({drawn.name, drawn.sha256, plan.limits.solvers[s].spelling,
                          to_string(StartKind::cold)});
  }
  return cell;
}

/// Facts about the instances in run.json, which --resume may not change.
Origin origin_of(const FrontierPlan& plan) {
  return {"",
          {plan.grid.family, "--x " + to_string(plan.grid.x), "--y " + to_string(plan.grid.y),
           fmt::format("--seed {}", plan.seed), fmt::format("--count {}", plan.count)},
          1,
          0};
}

void check_plan(const FrontierPlan& plan) {
  check_knobs(plan.grid);
  if (plan.limits.solvers.empty()) throw std::invalid_argument("no solver is named");
  if (plan.count < 1 || plan.max_count < plan.count || plan.max_count > most_draws)
    throw std::invalid_argument(
        fmt::format("--count {} --max-count {}: expected 1 <= count <= max-count <= {}", plan.count,
                    plan.max_count, most_draws));
}

}  // namespace

std::vector<SharePoint> share_points(const KnobAxis& y, const FrontierColumn& column) {
  std::vector<SharePoint> points;
  for (std::size_t i = 0; i < column.cells.size(); ++i)
    points.push_back({y.position(i), column.cells[i].solved, column.cells[i].counted});
  return points;
}

std::optional<Frontier> run_frontier(const std::filesystem::path& directory,
                                     const FrontierPlan& plan, Existing existing,
                                     const std::function<void(const std::string&)>& note,
                                     const std::function<void(const Progress&)>& progress,
                                     const std::atomic<bool>& interrupted) {
  check_plan(plan);
  Sampling sampling(plan);  // refuses knobs
  OpenRun open = open_run(directory, settings_of(plan.limits, origin_of(plan)), plan.limits.jobs,
                          existing, note);
  write_run_settings(directory, open.settings);
  if (std::filesystem::exists(directory / "rows.jsonl"))
    for (const Record& record : read_run(directory)) sampling.take(record);
  const auto write_row = open_rows(directory);
  const auto begin = std::chrono::steady_clock::now();

  Progress so_far;
  do {
    const std::vector<OpenDraws> round = sampling.open();
    for (const OpenDraws& cell : round) so_far.total += cell.pairs();
    for (const OpenDraws& cell : round) {
      run(
          plan_of(cell, plan, open.environment),
          [&](Record record) {
            record.place = draw_number(record.instance).value();
            write_row(record);
            sampling.take(record);
          },
          [&](const Progress& here) {
            progress(
                {so_far.done + here.done, so_far.total, cell_spelling(plan.grid, cell.x, cell.y)});
          },
          interrupted);
      if (interrupted) return std::nullopt;
      so_far.done += cell.pairs();
    }
  } while (sampling.raise());

  if (!open.begun) {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    open.settings.seconds = elapsed.count();
    write_run_settings(directory, open.settings);
  }
  return sampling.frontier();
}

std::vector<SeedAgreement> seed_agreements(const Frontier& first, const Frontier& second) {
  const KnobAxis& y = first.plan.grid.y;
  std::vector<SeedAgreement> all;
  for (std::size_t s = 0; s < first.rows.size(); ++s) {
    SeedAgreement solver;
    for (std::size_t x = 0; x < first.rows[s].columns.size(); ++x) {
      const FrontierColumn &a = first.rows[s].columns[x], &b = second.rows[s].columns[x];
      const bool same = agree(a.line, share_points(y, a), b.line, share_points(y, b));
      solver.column_agrees.push_back(same);
      if (same) ++solver.agree;
      if (a.line.kind != ShareLine::Kind::crossing || b.line.kind != a.line.kind) continue;
      ++solver.lines;
      if (a.line.rising == b.line.rising && a.line.low <= b.line.u && b.line.u <= a.line.high)
        ++solver.within;
    }
    all.push_back(std::move(solver));
  }
  return all;
}

}  // namespace lcp
