#pragma once

#include <chrono>
#include <string>

#include "harness/measure/runner.h"

namespace lcp {

/// `[#####.....] 120/3200  time left 1:42  squat-like/0042`. The time left supposes that the pairs to
/// come take as long as those done, and is missing before the first.
std::string progress_line(const Progress& progress, std::chrono::nanoseconds elapsed);

/// A line on stderr that is redrawn at most ten times a second. Silent where stderr is no terminal.
class ProgressBar {
 public:
  ProgressBar();
  ~ProgressBar();  ///< Clears the line.
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void update(const Progress& progress);

 private:
  bool on_terminal_;
  std::chrono::steady_clock::time_point begin_;
  std::chrono::steady_clock::time_point drawn_;
};

}  // namespace lcp
