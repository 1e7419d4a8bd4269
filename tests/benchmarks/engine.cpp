// Pivoting solvers against the limit that no pivoting method can pass, on generated contacts or on
// corpora: per set of instances the median time, and that time in units of
//   cold     (pivots on the path) x (one pass over n x (|alpha| + 1) doubles),
//   started  (one LU of the final basis) + (one product M z over its columns),
// where `started` is a solve that begins at the basis with which the cold one ended. Solve and limit
// of an instance take turns, and the least time of each counts, so that a noisy machine hits both.
//   bench_engine [--solver NAME] [--repetitions K] [CORPUS...]

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>

#include "problems/contact/islands.h"
#include "problems/io/load.h"
#include "problems/registry.h"
#include "solvers/linalg/natural_residual.h"
#include "solvers/registry.h"

namespace lcp {
namespace {

/// Microseconds that `work` takes.
template <class Work>
double microseconds(const Work& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin)
      .count();
}

double median(std::vector<double> values) {
  if (values.empty()) return std::nan("");
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// What is known of one set of instances.
struct Figures {
  Index instances = 0, solved = 0, nodes = 0, factorisations = 0;
  std::vector<double> cold, started, per_pass, per_limit, residuals;
  std::uint64_t pivots_hash = 0xcbf29ce484222325U;  ///< FNV-1a of every pivot sequence.
};

/// Solves one problem cold and from its own final basis; times both and the two limits.
void measure(const Problem& problem, const NamedSolver& named, int repetitions, Figures& figures) {
  ++figures.instances;
  const auto remember = [&](const PivotEvent& event) {
    for (const std::int64_t number :
         {static_cast<std::int64_t>(event.row), static_cast<std::int64_t>(event.entering)})
      figures.pivots_hash =
          (figures.pivots_hash ^ static_cast<std::uint64_t>(number)) * 0x100000001b3U;
  };
  const Result result = named.solver->solve(problem, {{}, remember});
  figures.nodes += result.work.nodes > 0 ? result.work.nodes : result.work.pivots;
  figures.factorisations += result.work.factorisations;
  VectorXd w;
  const double residual = natural_residual(problem, result.z, w);
  if (result.claim != Claim::solved || !(residual <= 1e-6) || !result.basis) return;
  ++figures.solved;
  figures.residuals.push_back(residual);

  const std::vector<Index>& alpha = *result.basis;
  const Index n = problem.size(), k = static_cast<Index>(alpha.size());
  const MatrixXd pass = MatrixXd::Random(n, k + 1);
  const VectorXd x = VectorXd::Random(k + 1);
  const MatrixXd kernel = problem.M(alpha, alpha), columns = problem.M(Eigen::all, alpha);
  const VectorXd q_alpha = problem.q(alpha);
  VectorXd y(n), z;
  double cold = INFINITY, started = INFINITY, one_pass = INFINITY, limit = INFINITY;
  for (int r = 0; r < repetitions; ++r) {
    cold = std::min(cold, microseconds([&] { named.solver->solve(problem); }));
    started = std::min(started, microseconds([&] {
                         named.solver->solve(problem, {Start{alpha}, {}});
                       }));
    one_pass = std::min(one_pass, microseconds([&] {
                                    for (int i = 0; i < 100; ++i) {
                                      y.noalias() = pass * x;
                                      asm volatile("" : : "g"(y.data()) : "memory");
                                    }
                                  }) / 100);
    limit = std::min(limit, microseconds([&] {
                              for (int i = 0; i < 10; ++i) {
                                z = -kernel.partialPivLu().solve(q_alpha);
                                y.noalias() = problem.q + columns * z;
                                asm volatile("" : : "g"(y.data()) : "memory");
                              }
                            }) / 10);
  }
  figures.cold.push_back(cold);
  figures.started.push_back(started);
  if (result.work.path > 0)
    figures.per_pass.push_back(cold / (static_cast<double>(result.work.path) * one_pass));
  if (k > 0) figures.per_limit.push_back(started / limit);
}

void print(const std::string& name, const Figures& f) {
  fmt::print("{:44} {:4} {:6} {:9} {:8} {:9.1f} {:8.2f} {:9.1f} {:8.2f} {:9.1e} {:016x}\n", name,
             f.instances, f.solved, f.nodes, f.factorisations, median(f.cold), median(f.per_pass),
             median(f.started), median(f.per_limit), median(f.residuals), f.pivots_hash);
  std::fflush(stdout);
}

int run(int argc, char** argv) {
  CLI::App app{"Pivoting solvers against the limit"};
  std::vector<std::string> solvers = {"best-first"}, corpora;
  int repetitions = 7;
  app.add_option("--solver", solvers, "NAME[:key=value,...], repeatable")->allow_extra_args(false);
  app.add_option("--repetitions", repetitions, "Of which the least time counts");
  app.add_option("corpora", corpora, "FILE, FILE#NAME or directory; default: generated contacts");
  CLI11_PARSE(app, argc, argv);

  std::vector<std::pair<std::string, std::vector<Instance>>> sets;
  if (corpora.empty()) {
    for (const auto& [family, count] :
         {std::pair("squat-like", 50), std::pair("squat-like:contacts=64", 20),
          std::pair("draped-chain", 25), std::pair("stack", 10), std::pair("body-on-plane", 10)})
      sets.emplace_back(family, generate(family, {count, 1}));
  }
  for (const std::string& where : corpora)
    for (Instance& instance : load_instances(where)) {
      const std::string set = instance.name.substr(0, instance.name.rfind('/'));
      auto known =
          std::find_if(sets.begin(), sets.end(), [&](const auto& s) { return s.first == set; });
      if (known == sets.end()) known = sets.insert(sets.end(), {set, {}});
      known->second.push_back(std::move(instance));
    }

  for (const NamedSolver& named : make_solvers(solvers)) {
    fmt::print("{}\n{:44} {:>4} {:>6} {:>9} {:>8} {:>9} {:>8} {:>9} {:>8} {:>9} {}\n",
               named.spelling, "", "n", "solved", "nodes", "factor", "cold us", "/ pass",
               "start us", "/ limit", "residual", "pivots");
    for (const auto& [name, instances] : sets) {
      Figures figures;
      for (const Instance& instance : instances)
        for (const Island& island : split_islands(instance.problem))
          measure(island.problem, named, repetitions, figures);
      print(name, figures);
    }
  }
  return 0;
}

}  // namespace
}  // namespace lcp

int main(int argc, char** argv) {
  try {
    return lcp::run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_engine: {}\n", error.what());
    return 2;
  }
}
