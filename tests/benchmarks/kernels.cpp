// Micro-benchmarks of the kernels that a pivot is made of, at n = 80, 160, 320 and 640 (squat-like
// frames with 8 ... 64 contacts), and of the limit that no pivoting method can pass: one LU of the
// final basis plus one product M z. Ratios between them are what counts; run them in one go.

#include <benchmark/benchmark.h>

#include <map>

#include "harness/judge/judge.h"
#include "problems/contact/friction_lcp.h"
#include "problems/registry.h"
#include "solvers/linalg/basis.h"
#include "solvers/linalg/pivot_candidates.h"
#include "solvers/linalg/ratio_test.h"
#include "solvers/linalg/tableau.h"
#include "solvers/registry.h"

namespace lcp {
namespace {

/// The tenth frame with n / 10 contacts (8 directions: 10 unknowns each).
const Instance& frame(Index n) {
  static std::map<Index, Instance> frames;
  if (!frames.contains(n))
    frames[n] = generate("squat-like:contacts=" + std::to_string(n / 10), {10, 1}).back();
  return frames[n];
}

/// The pivots with which `solver` solves the frame.
std::vector<Pivot> path_of(const std::string& solver, const Problem& problem) {
  std::vector<Pivot> path;
  const Result result =
      make_solver(solver).solver->solve(problem, {{}, [&](const PivotEvent& event) {
                                                    path.push_back({event.row, event.entering});
                                                  }});
  if (result.claim != Claim::solved) throw std::runtime_error(solver + " did not solve the frame");
  return path;
}

/// A solve's pivots on one dictionary, without ratio tests: time per pivot at the basis sizes met.
template <class Dictionary>
void one_pivot(benchmark::State& state) {
  const Problem& problem = frame(state.range(0)).problem;
  const ScaledProblem scaled(problem, true);
  const std::vector<Pivot> path = path_of("lexicographic-revised", problem);
  VectorXd column;
  for (auto _ : state) {
    state.PauseTiming();
    Dictionary dictionary(scaled, {}, {});
    state.ResumeTiming();
    for (const Pivot& pivot : path) {
      dictionary.column(pivot.entering, column);
      dictionary.pivot(pivot, column);
    }
    benchmark::DoNotOptimize(dictionary.q().data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(path.size()));
}

/// A dictionary in the middle of a solve and the driving variable's column there.
struct Middle {
  ScaledProblem scaled;
  Basis basis;
  std::vector<Variable> first;
  VectorXd column;

  explicit Middle(const Problem& problem) : scaled(problem, true), basis(scaled, {}, {}) {
    first = basis.labels().basic();
    const std::vector<Pivot> path = path_of("lexicographic-revised", problem);
    const std::size_t half = path.size() / 2;
    basis.rebuild({path.begin(), path.begin() + static_cast<std::ptrdiff_t>(half)});
    basis.column(path[half].entering, column);
  }
};

void first_index_test(benchmark::State& state) {
  const Middle middle(frame(state.range(0)).problem);
  for (auto _ : state)
    benchmark::DoNotOptimize(first_index_ratio_test(middle.basis.q(), middle.column, 1e-12));
}

void lexicographic_test(benchmark::State& state) {
  Middle middle(frame(state.range(0)).problem);
  for (auto _ : state)
    benchmark::DoNotOptimize(lexicographic_ratio_test(middle.basis, middle.column, middle.first,
                                                      {.pivot = 1e-12, .delta = 1e-8, .z0 = 1e-8}));
}

/// A column of the dictionary: a solve with the factors, and a product with the columns of the basis.
void basis_column(benchmark::State& state) {
  Middle middle(frame(state.range(0)).problem);
  const Labels& labels = middle.basis.labels();
  Variable nonbasic = labels.w(0);
  while (labels.is_basic(nonbasic)) ++nonbasic;
  VectorXd column;
  for (auto _ : state) {
    middle.basis.column(nonbasic, column);
    benchmark::DoNotOptimize(column.data());
  }
}

/// The search's ratio test, with prices.
void pivot_candidates(benchmark::State& state) {
  const Middle middle(frame(state.range(0)).problem);
  const auto blocks = [](double m) { return m < -1e-12; };
  VectorXd ratios;
  std::vector<PivotCandidate> candidates;
  for (auto _ : state) {
    find_candidates(middle.basis.q(), middle.column, blocks, {.epsilon = 1e-9, .grid = 1e-11},
                    ratios, candidates);
    benchmark::DoNotOptimize(candidates.data());
  }
  state.counters["found"] = static_cast<double>(candidates.size());
}

void judging(benchmark::State& state) {
  const Instance& instance = frame(state.range(0));
  const Result result = make_solver("best-first").solver->solve(instance.problem);
  for (auto _ : state) benchmark::DoNotOptimize(judge(instance, result, 1e-6));
}

void assembly(benchmark::State& state) {
  const FrictionBlocks& blocks = *frame(state.range(0)).problem.friction;
  ContactProblem contacts;
  contacts.W = blocks.W;
  contacts.vbar = blocks.vbar;
  for (Index i = 0; i < blocks.contacts(); ++i)
    contacts.contacts.push_back(make_contact({0, 0, 1}, {1, 0, 0}, blocks.mu(i), {0, 1, i}));
  for (auto _ : state) benchmark::DoNotOptimize(friction_lcp(contacts).M.data());
}

void whole_solve(benchmark::State& state, const std::string& solver) {
  const Problem& problem = frame(state.range(0)).problem;
  const NamedSolver named = make_solver(solver);
  Result result;
  for (auto _ : state) result = named.solver->solve(problem);
  state.counters["pivots"] = static_cast<double>(result.work.pivots);
  state.counters["alpha"] = static_cast<double>(result.basis->size());
}

/// One LU of M_alpha,alpha for the final basis and one product M z over its columns.
void limit(benchmark::State& state) {
  const Problem& problem = frame(state.range(0)).problem;
  const std::vector<Index> alpha = *make_solver("best-first").solver->solve(problem).basis;
  const MatrixXd kernel = problem.M(alpha, alpha), columns = problem.M(Eigen::all, alpha);
  const VectorXd q_alpha = problem.q(alpha);
  for (auto _ : state) {
    const VectorXd z = -kernel.partialPivLu().solve(q_alpha);
    const VectorXd w = problem.q + columns * z;
    benchmark::DoNotOptimize(w.data());
  }
  state.counters["alpha"] = static_cast<double>(alpha.size());
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(80)->Arg(160)->Arg(320)->Arg(640)->Unit(benchmark::kMicrosecond);
}

BENCHMARK(one_pivot<Tableau>)->Apply(sizes);
BENCHMARK(one_pivot<Basis>)->Apply(sizes);
BENCHMARK(first_index_test)->Apply(sizes);
BENCHMARK(lexicographic_test)->Apply(sizes);
BENCHMARK(basis_column)->Apply(sizes);
BENCHMARK(pivot_candidates)->Apply(sizes);
BENCHMARK(judging)->Apply(sizes);
BENCHMARK(assembly)->Apply(sizes);
BENCHMARK_CAPTURE(whole_solve, best_first, "best-first")->Apply(sizes);
BENCHMARK_CAPTURE(whole_solve, lexicographic_revised, "lexicographic-revised")->Apply(sizes);
BENCHMARK(limit)->Apply(sizes);

}  // namespace
}  // namespace lcp

BENCHMARK_MAIN();
