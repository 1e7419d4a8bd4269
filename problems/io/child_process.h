#pragma once

#include <functional>
#include <string>

namespace lcp {

/// Runs `work` in a forked child process and returns what it returned there, so that a library that
/// crashes, aborts or hangs on a foreign file takes only the child with it. What the child prints is
/// dropped. Throws UnreadableInput: the child's own message where `work` threw a std::exception;
/// otherwise a line beginning with `what` that says how the child died, or that it was stopped after
/// `seconds`. Call it while this process has one thread.
std::string try_in_child(const std::string& what, unsigned seconds,
                         const std::function<std::string()>& work);

}  // namespace lcp
