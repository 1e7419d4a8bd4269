#pragma once

#include <atomic>

namespace lcp::cli {

/// From now on Ctrl-C (SIGINT) and SIGTERM set the returned flag instead of ending the program.
const std::atomic<bool>& catch_interruptions();

}  // namespace lcp::cli
