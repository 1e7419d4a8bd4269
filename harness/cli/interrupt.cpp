#include "harness/cli/interrupt.h"

#include <csignal>

namespace lcp::cli {

namespace {

std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may set no other");

}  // namespace

const std::atomic<bool>& catch_interruptions() {
  struct sigaction action {};
  action.sa_handler = [](int) { interrupted = true; };
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  return interrupted;
}

}  // namespace lcp::cli
