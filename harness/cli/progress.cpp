#include "harness/cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace lcp {

namespace {

constexpr std::size_t bar_width = 30;
constexpr auto between_drawings = std::chrono::milliseconds(100);
constexpr const char* clear_line = "\r\033[K";

}  // namespace

std::string progress_line(const Progress& progress, std::chrono::nanoseconds elapsed) {
  const std::size_t filled =
      progress.total == 0 ? bar_width : bar_width * progress.done / progress.total;
  std::string line =
      fmt::format("[{}{}] {}/{}", std::string(filled, '#'), std::string(bar_width - filled, '.'),
                  progress.done, progress.total);
  if (progress.done > 0) {
    const double done = static_cast<double>(progress.done);
    const double to_come = static_cast<double>(progress.total - progress.done);
    const auto left = std::chrono::duration<double>(elapsed).count() / done * to_come;
    const auto seconds = static_cast<long>(left + 0.5);
    line += fmt::format("  time left {}:{:02}", seconds / 60, seconds % 60);
  }
  return progress.at.empty() ? line : line + "  " + progress.at;
}

ProgressBar::ProgressBar()
    : on_terminal_(::isatty(STDERR_FILENO) == 1),
      begin_(std::chrono::steady_clock::now()),
      drawn_(begin_ - between_drawings) {}

ProgressBar::~ProgressBar() {
  if (on_terminal_) std::fputs(clear_line, stderr);
}

void ProgressBar::update(const Progress& progress) {
  const auto now = std::chrono::steady_clock::now();
  if (!on_terminal_ || now - drawn_ < between_drawings) return;
  drawn_ = now;
  fmt::print(stderr, "{}{}", clear_line, progress_line(progress, now - begin_));
  std::fflush(stderr);
}

}  // namespace lcp
