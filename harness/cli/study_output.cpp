#include "harness/cli/study_output.h"

#include <fmt/format.h>

#include <optional>

#include "harness/cli/interrupt.h"
#include "harness/cli/output_directory.h"
#include "harness/cli/page.h"
#include "harness/cli/progress.h"
#include "harness/measure/environment.h"
#include "harness/studies/loop/drift_study.h"
#include "problems/io/replace_file.h"

namespace lcp::cli {

void add_study_output(CLI::App& page, StudyOutput& output, const std::string& name) {
  add_format(page, output.format, {"text", "csv", "json"});
  page.add_flag("--json", output.json, "The same as --format json");
  page.add_flag("--dry-run", output.dry_run, "Print what would be simulated, simulate nothing");
  add(page, "--out", output.out,
      ("New directory for " + name + ".txt, .csv, .json, .svg and env.json").c_str());
}

void write_texts(const std::filesystem::path& directory, const std::string& name,
                 const Described& study) {
  const auto write = [&](const char* ending, const std::string& text) {
    replace_file((directory / (name + ending)).string(), text);
  };
  write(".txt", study.text);
  write(".csv", study.csv);
  write(".json", study.json.dump(1) + "\n");
}

void print(const Described& study, const std::string& format) {
  fmt::print("{}", format == "csv"    ? study.csv
                   : format == "json" ? study.json.dump(1) + "\n"
                                      : study.text);
}

int publish(const StudyOutput& output, const std::string& name,
            const std::function<Described(const std::function<void(const Progress&)>&,
                                          const std::atomic<bool>&)>& make) {
  if (!output.out.empty()) require_new(output.out);
  Described study;
  try {
    std::optional<ProgressBar> bar;
    std::size_t before = 0;
    const auto update = [&](const Progress& progress) {
      if (!bar || progress.done < before) bar.emplace();  // another phase
      before = progress.done;
      bar->update(progress);
    };
    study = make(update, catch_interruptions());
  } catch (const Interrupted&) {
    fmt::print(stderr, "interrupted: nothing is written\n");
    return interrupted_by_user;
  }
  if (!output.out.empty())
    write_directory(output.out, [&](const std::filesystem::path& into) {
      write_texts(into, name, study);
      replace_file((into / "env.json").string(), describe_environment(1).dump(1) + "\n");
      draw_figure(into / (name + ".svg"), study.figure);
    });
  print(study, output.json ? "json" : output.format);
  if (!output.out.empty()) fmt::print(stderr, "tables and picture are in {}\n", output.out);
  return done;
}

}  // namespace lcp::cli
