#pragma once

#include <string>

#include "harness/record.h"

namespace lcp {

/// A record as a run writes it: `solver` on INSTANCE of CORPUS, 3 contacts of which 2 are active,
/// 10 pivots, 5 nodes, 1 ms.
inline Record made_up(const std::string& instance, const std::string& solver, Verdict verdict,
                      Claim claim, double residual) {
  Record record;
  record.instance = instance;
  record.corpus = instance.substr(0, instance.find('/'));
  record.sha256 = std::string(64, '0');
  record.n = 30;
  record.contacts = 3;
  record.active_contacts = 2;
  record.solver = solver;
  record.row = solver.substr(0, solver.find(':'));
  record.version = "1";
  record.options = nlohmann::json::object();
  record.claim = claim;
  record.verdict = verdict;
  record.work.pivots = 10;
  record.work.nodes = 5;
  record.times_ns = {1'000'000};
  record.environment = "0";
  record.accuracy = Accuracy{};
  record.accuracy->residual = residual;
  record.accuracy->zero_residual = 1;
  return record;
}

inline Record solved(const std::string& instance, const std::string& solver, double residual) {
  return made_up(instance, solver, Verdict::solved, Claim::solved, residual);
}

/// A pair that the runner ended: no answer, no residual, no work.
inline Record ended(const std::string& instance, const std::string& solver, Verdict verdict) {
  Record record = made_up(instance, solver, verdict, Claim::singular, 0);
  record.accuracy.reset();
  record.work = {};
  return record;
}

}  // namespace lcp
