#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace lcp {

/// What a program printed and how it ended.
struct Ran {
  int status;  ///< Exit status, or minus the signal that ended it.
  std::string out;
  std::string err;
};

/// Runs `program` with `arguments` in `directory` until it ends; stdin is empty. With
/// `interrupt_when`, sends SIGINT as soon as that file in `directory` has a line.
Ran run_program(const std::string& program, const std::vector<std::string>& arguments,
                const std::string& directory, const std::string& interrupt_when = "");

/// The same; sends SIGKILL after `delay`. A program that ends before that is not touched.
Ran run_and_kill(const std::string& program, const std::vector<std::string>& arguments,
                 const std::string& directory, std::chrono::milliseconds delay);

/// The same; sends SIGKILL inside its write number `count` (from 1) to a file called `file`, when
/// half of the bytes are written.
Ran run_and_kill_in_write(const std::string& program, const std::vector<std::string>& arguments,
                          const std::string& directory, const std::string& file, int count);

}  // namespace lcp
