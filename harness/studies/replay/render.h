#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "harness/studies/replay/replay.h"

namespace lcp {

/// The departure as a sentence, in the instance's own numbering, rows and pivots from 1: `first wrong
/// pivot: number 5: ...`; without a wrong pivot, how far the two agree.
std::string sentence(const Replay& replay, Index n);

/// One screen of at most 100 columns: verdict, what 113 bits say, the departure, and the pivots from
/// `begin` to `end`, a line each. `title` names instance, solver and start; n is the instance's size.
std::string text(const Replay& replay, const std::string& title, Index n);

/// The same as JSON, with the pivots shown. Infinite figures are strings.
nlohmann::ordered_json json(const Replay& replay, Index n);

}  // namespace lcp
