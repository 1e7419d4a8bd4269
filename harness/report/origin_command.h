#pragma once

#include <optional>
#include <string>

#include "harness/record.h"
#include "harness/runs/settings.h"

namespace lcp {

/// How a stranger gets at an instance of a run again, as pieces of a shell command:
///
///     before  PROGRAM VERB  where  ARGUMENTS  after
///
/// `where` is quoted for the shell; `before` draws the instance anew or looks for its file.
struct InstanceCommand {
  std::string before;
  std::string where;
  std::string after;
  std::string note;  ///< What a reader must know of it; empty where the command stands for itself.
};

/// The program as its users call it, from the root of the repository.
inline constexpr const char* report_program = "build/release/lcpbench";

/// Text as one word of a POSIX shell, whatever it holds.
std::string shell_quoted(const std::string& text);

/// How to get at `instance` of `corpus` of a run with this origin:
///
///   - of a suite's family: the family is drawn again, with the suite's count and seed;
///   - of a suite's scene: the scene is simulated again up to this frame;
///   - of a corpus: its file, or where there are several, each of them in turn.
///
/// Without an origin (older runs have none) the file is a placeholder, as the note says.
InstanceCommand origin_command(const std::string& instance, const std::string& corpus,
                               const std::optional<Origin>& origin);

/// For a frame of a scene of the catalogue (`SCENE/00042`, or of a dump's twins such as
/// `SCENE+composite/00042`): the scene is simulated again up to it, as `simulate --dump` does with
/// its default solver. Empty for other instances.
std::optional<InstanceCommand> simulated_again(const std::string& instance,
                                               const std::string& corpus);

/// Options that pick the solver and its start on the command line: ` --solver 'lemke' --start two-step`.
std::string solver_arguments(const Record& record);

}  // namespace lcp
