#pragma once

#include <vector>

#include "harness/present/described.h"
#include "harness/studies/sufficient/study.h"

namespace lcp {

/// Studies in every format. Text: of each its table, the noise floor, and which model is enough, and a
/// line for each of several at the end; CSV: a line per model and scene; JSON: an object per scene;
/// figure: physical error over tolerance against the time saved, a panel per study.
Described described(const std::vector<Study>& studies);
Figure figure_of(const std::vector<Study>& studies);

}  // namespace lcp
