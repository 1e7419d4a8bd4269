#include <fmt/format.h>
#include <fmt/ranges.h>
#include <malloc.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "harness/cli/verbs.h"
#include "problems/io/errors.h"

namespace lcp::cli {
namespace {

/// Freed memory stays with the process. Otherwise a step with large matrices hands its pages back
/// and faults them in again, which may take longer than its arithmetic, and how often that happens
/// depends on where blocks happen to lie: times of equal work differ.
void keep_freed_memory() {
  constexpr int kept = 1 << 30;  // bytes
  mallopt(M_MMAP_THRESHOLD, kept);
  mallopt(M_TRIM_THRESHOLD, kept);
}

int complain(const std::string& who, const std::string& what, int status) {
  fmt::print(stderr, "{}: {}\n", who, what);
  return status;
}

/// "--jobs, --out, ...", without --help.
std::string allowed_options(const CLI::App& page) {
  std::vector<std::string> names;
  for (const CLI::Option* option : page.get_options())
    if (option != page.get_help_ptr()) names.push_back(option->get_name());
  return fmt::format("{}", fmt::join(names, ", "));
}

int complain_of_output(const std::string& who) {
  return complain(
      who, fmt::format("standard output: cannot write: {}", std::generic_category().message(errno)),
      unwritable_output);
}

/// Results that did not reach a full disk are an error, not a success.
int flushed(int status, const std::string& who) {
  const bool written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  return written ? status : complain_of_output(who);
}

int act(const Verb& verb, const std::string& who) {
  try {
    return flushed(verb.act(), who);
  } catch (const std::invalid_argument& error) {
    return complain(who, error.what(), usage);
  } catch (const UnreadableInput& error) {
    return complain(who, error.what(), unreadable_input);
  } catch (const UnwritableOutput& error) {
    return complain(who, error.what(), unwritable_output);
  } catch (const std::filesystem::filesystem_error& error) {
    return complain(who, error.what(), unreadable_input);
  } catch (const std::exception& error) {
    if (std::ferror(stdout) != 0) return complain_of_output(who);
    return complain(who, error.what(), system_failure);
  }
}

std::string unknown_verb(const std::string& word, const std::vector<Verb>& known, int depth) {
  const char* kind = depth == 1 ? "verb" : "part";
  std::vector<std::string> names;
  for (const Verb& each : known) names.push_back(each.page->get_name());
  return fmt::format("{}, {}s are: {}",
                     word.empty() ? fmt::format("a {} is missing", kind)
                                  : fmt::format("unknown {} '{}'", kind, word),
                     kind, fmt::join(names, ", "));
}

int run_program(int argc, char** argv) {
  CLI::App program{
      "A benchmark of pivoting solvers for linear complementarity problems, on "
      "frictional contact.",
      "lcpbench"};
  program.set_version_flag("--version", LCPBENCH_VERSION);
  program.require_subcommand(1);
  program.footer("Examples:\n  lcpbench run --suite small\n  lcpbench run --help");
  const std::vector<Verb> verbs = {
      add_list(program),   add_generate(program),   add_simulate(program),    add_solve(program),
      add_run(program),    add_table(program),      add_sheet(program),       add_sweep(program),
      add_merge(program),  add_report(program),     add_stability(program),   add_shrink(program),
      add_replay(program), add_sufficient(program), add_compare(program),     add_paper(program),
      add_info(program),   add_convert(program),    add_test_solver(program),
  };

  const Verb* verb = nullptr;
  std::string who = "lcpbench";
  int depth = 1;
  for (const std::vector<Verb>* level = &verbs; !level->empty(); level = &verb->parts, ++depth) {
    const std::string word = depth < argc ? argv[depth] : "";
    if (!word.empty() && word.front() == '-') break;
    const auto named = std::find_if(level->begin(), level->end(), [&](const Verb& each) {
      return each.page->get_name() == word;
    });
    if (named == level->end()) return complain(who, unknown_verb(word, *level, depth), usage);
    verb = &*named;
    who += " " + word;
  }

  try {
    program.parse(argc, argv);
  } catch (const CLI::ExtrasError& error) {
    const CLI::App& page = verb ? *verb->page : program;
    return complain(who, fmt::format("{}; allowed are: {}", error.what(), allowed_options(page)),
                    usage);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return flushed(program.exit(error), who);  // --help, --version
    return complain(who, error.what(), usage);
  }
  return act(*verb, who);
}

}  // namespace
}  // namespace lcp::cli

int main(int argc, char** argv) {
  lcp::cli::keep_freed_memory();
  std::signal(SIGXFSZ, SIG_IGN);  // A file that may not grow is an error like a full disk.
  return lcp::cli::run_program(argc, argv);
}
