#pragma once

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

}  // namespace lcp
