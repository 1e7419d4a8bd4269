#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "solvers/result.h"

namespace lcp {

/// The decision of the judge, or of the runner where there is nothing to judge, on one run. Rows hold its name
/// with '-' for '_': false-infeasible, not-run.
enum class Verdict {
  solved,      ///< Claimed solved, natural residual within the tolerance.
  wrong,       ///< Claimed solved or infeasible, and fails the check.
  inaccurate,  ///< Only in re-judged tables: passed at the run's tolerance, not at a smaller.
  ray,         ///< As claimed; so are the following where nothing is said.
  exhausted,
  infeasible,        ///< The certificate was checked, and no solution is known.
  false_infeasible,  ///< Claimed infeasible, but a checked solution is known.
  cycle,
  limit,
  singular,
  timeout,  ///< The runner's: one solve took longer than it may.
  memory,   ///< The runner's: the worker held more memory than it may.
  crash,    ///< The runner's: the worker died or an exception left the solver.
  unsupported,
  not_run,  ///< The runner's: the pair was left out.
};

/// How good an answer is. Everything is computed from M, q and the answer in __float128 (113 bits)
/// and rounded at the end. Where z, w or the covering vector is not n finite numbers, or
/// the basis names a row that does not exist, every figure of the answer is infinite (the minima
/// minus infinity).
struct Accuracy {
  double residual;           ///< max_i |min(z_i / s_z,i, w_i / s_w,i)|, w = M z + q recomputed.
  double residual_unscaled;  ///< max_i |min(z_i, w_i)|.
  double zero_residual;      ///< Of z = 0: a figure of the problem alone.
  double paper_error;        ///< |w - M z - q - z0 c|_inf of the solver's own w, z0; NaN without.
  double min_z;              ///< 0 where n = 0, as min_w.
  double min_w;
  double max_zw;  ///< max_i |z_i w_i|.
  /// omega, the componentwise backward error of the basis alpha: with z set to 0 outside alpha and
  /// w = M z + q of that z, the largest of |w_i| (i in alpha) and max(0, -w_i) (other i), each over
  /// (|M||z| + |q|)_i, where 0/0 = 0; infinite where some z_i < 0 in alpha. An answer without a
  /// basis is measured at alpha = {i : z_i / s_z,i > w_i / s_w,i}: compared in the problem's scales,
  /// since z_i and w_i have different units.
  double backward_error;
};

/// One row: what one solver did with one instance. Written as one line of JSON.
struct Record {
  static constexpr int schema = 1;

  std::string instance;
  Index place = 0;     ///< Of the instance among all of the run, counted before it is sharded.
  std::string corpus;  ///< What comes before the first '/' of the instance's name.
  std::string sha256;  ///< Of the instance, from a previous solution of that too (see run).
  Index n = 0;
  Index contacts = 0;
  std::optional<Index> active_contacts;
  std::string solver;      ///< Full spelling.
  std::string row;         ///< Name of the registry row.
  std::string version;     ///< Of the registry row.
  nlohmann::json options;  ///< Every option with its value, defaults included.
  std::string start = "cold";
  Claim claim = Claim::singular;  ///< Meaningless (and absent in JSON) where the verdict is the
                                  ///< runner's.
  std::string message;
  Verdict verdict = Verdict::not_run;
  bool unclaimed = false;
  bool trivial = false;
  double tolerance = 1e-6;
  std::optional<Accuracy> accuracy;  ///< Empty where there was no answer to measure.
  Work work;
  std::optional<VectorXd> z;           ///< Of a solved pair, in runs that keep answers.
  std::vector<std::int64_t> times_ns;  ///< One sample per repetition; time to failure on failures.
  int exit_signal = 0;                 ///< Of a crashed or killed worker.
  std::string stderr_end;              ///< Last 400 bytes a worker wrote to stdout or stderr.
  int jobs = 1;
  std::string environment;  ///< Id of env.json.

  /// Median of times_ns (see observed_quantile); empty when there is none.
  std::optional<std::int64_t> median_ns() const;
};

/// The key by which two rows are the same piece of work. The name stands beside the hash because a corpus may
/// hold one problem twice.
struct PairKey {
  std::string instance;
  std::string sha256;
  std::string solver;  ///< Full spelling.
  std::string start;

  auto operator<=>(const PairKey&) const = default;
};

PairKey key_of(const Record& record);

/// True for timeout, memory, crash and not-run: there was no answer to judge.
bool decided_by_runner(Verdict verdict);

void to_json(nlohmann::json& json, const Work& work);
/// Throws as from_json of a record.
void from_json(const nlohmann::json& json, Work& work);

/// Non-finite numbers are written as strings ("inf", "-inf", "nan"), which from_json reads back.
void to_json(nlohmann::json& json, const Record& record);
/// Throws std::invalid_argument saying which field is missing or malformed.
void from_json(const nlohmann::json& json, Record& record);

}  // namespace lcp
