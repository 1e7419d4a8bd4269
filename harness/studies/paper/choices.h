#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "harness/present/columns.h"
#include "harness/studies/paper/columns/loop_columns.h"
#include "harness/studies/paper/sections.h"

namespace lcp {

/// One thing that the paper leaves open, decided one way. All else is as in the first choice.
struct Choice {
  std::string what;       ///< Pivot tolerance, tie order, ...
  std::string way;        ///< How it is decided.
  std::string knobs;      ///< Of the scene: `key=value,...`; may be empty.
  std::string solver;     ///< Spelling.
  Acceptance acceptance;  ///< Residual 1e-6 unless the choice is about another.
};

const std::vector<Choice>& choices();

/// What is printed of each.
const std::vector<Column<LoopColumn>>& choice_columns();

/// Every choice in the loop of one scene.
struct ChoiceTable {
  std::string scene;
  std::vector<LoopColumn> columns;  ///< As choices().
};

/// What each choice that the paper leaves open does to failures, nodes and violated contacts, in the
/// loop of `squat` and of `tap-dance`. Computes what the directory does not hold yet, as reproduce
/// does; empty when interrupted.
std::optional<std::vector<ChoiceTable>> decide_each_way(const Reproduction& how,
                                                        const std::atomic<bool>& interrupted);

/// Its json is {"rows": [...]} with the summary of each simulation, its csv has a line per simulation.
PaperPage page_of(const std::vector<ChoiceTable>& tables);

}  // namespace lcp
