#include "harness/report/origin_command.h"

#include <fmt/format.h>

#include <charconv>
#include <memory>
#include <stdexcept>

#include "harness/studies/suites.h"
#include "problems/scenes/scene.h"

namespace lcp {

namespace {

/// A name for a file that says what it holds: `replay-stack-mass_ratio-1`.
std::string file_stem(const std::string& corpus) {
  std::string stem = "replay-" + corpus;
  for (char& c : stem) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '.' || c == '_';
    if (!plain) c = '-';
  }
  return stem;
}

std::string in_file(const std::string& file, const std::string& instance) {
  return shell_quoted(file + "#" + instance);
}

InstanceCommand drawn_again(const std::string& instance, const FamilyDraw& draw) {
  const std::string file = file_stem(draw.family) + ".hdf5";
  return {fmt::format("{} generate {} --count {} --seed {} --out {} && ", report_program,
                      shell_quoted(draw.family), draw.count, draw.seed, file),
          in_file(file, instance), "", ""};
}

/// A file, going by the endings of the formats; else a directory.
bool names_a_file(const std::string& corpus) {
  for (const char* ending : {".hdf5", ".h5", ".json", ".mtx", ".dat"})
    if (corpus.ends_with(ending)) return true;
  return false;
}

InstanceCommand in_corpora(const std::string& instance, const std::vector<std::string>& corpora) {
  for (const std::string& corpus : corpora)
    if (corpus.ends_with("#" + instance)) return {"", shell_quoted(corpus), "", ""};
  if (corpora.size() == 1 && names_a_file(corpora.front()))
    return {"", in_file(corpora.front(), instance), "", ""};
  std::string files;
  for (const std::string& corpus : corpora)
    files += " " + shell_quoted(corpus) + (names_a_file(corpus) ? "" : "/*");
  return {
      fmt::format("for f in{}; do ", files), "\"$f\"" + shell_quoted("#" + instance),
      " && break; done",
      "The rows do not say which of the run's files holds the instance: each is tried, and those "
      "that do not hold it say so. Paths are those given to the run."};
}

/// Time step (s) of a scene in full spelling, without setting it up, which may take a while. Empty for
/// what is called like no scene of the catalogue.
std::optional<double> time_step(const std::string& scene) {
  try {
    const Spelling spelling = parse_spelling(scene);
    for (const SceneRow& row : scenes()) {
      if (row.info.name != spelling.name) continue;
      const std::unique_ptr<Scene> knobs = row.make();
      OptionTable table = knobs->options();
      apply(table, spelling, row.info.name);
      for (const Option& option : table)
        if (option.name == "dt") return std::stod(option.get());
    }
  } catch (const std::invalid_argument&) {  // Somebody's corpus that is spelled otherwise.
  }
  return std::nullopt;
}

}  // namespace

std::string shell_quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? "'\\''" : std::string(1, c);
  return out + "'";
}

std::optional<InstanceCommand> simulated_again(const std::string& instance,
                                               const std::string& corpus) {
  if (instance.size() <= corpus.size() + 1) return std::nullopt;
  const std::string scene = corpus.substr(0, corpus.find('+'));
  const std::string digits = instance.substr(corpus.size() + 1);
  Index frame = 0;
  const char* end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, frame);
  if (error != std::errc() || stop != end || frame < 0) return std::nullopt;
  const std::optional<double> dt = time_step(scene);
  if (!dt) return std::nullopt;
  // Dumped are frames 0 and `frame`, so that it stands in the first shard.
  const std::string directory = file_stem(instance);
  return InstanceCommand{
      fmt::format("[ -e {0} ] || {1} simulate {2} --duration {3:.9g}s --every {4} --dump {0} && ",
                  directory, report_program, shell_quoted(scene),
                  *dt * static_cast<double>(frame + 1), std::max<Index>(frame, 1)),
      in_file(directory + "/0000.hdf5", instance), "",
      "The scene is simulated again up to this frame, driven by best-first."};
}

InstanceCommand origin_command(const std::string& instance, const std::string& corpus,
                               const std::optional<Origin>& origin) {
  if (origin && !origin->suite.empty()) {
    if (const auto draw = family_draw(origin->suite, corpus)) return drawn_again(instance, *draw);
    if (const auto simulated = simulated_again(instance, corpus)) return *simulated;
  }
  if (origin && !origin->corpora.empty()) return in_corpora(instance, origin->corpora);
  return {"", in_file("FILE", instance), "",
          "This run does not say where the instance came from: FILE stands for its corpus."};
}

std::string solver_arguments(const Record& record) {
  std::string arguments = " --solver " + shell_quoted(record.solver);
  if (record.start != "cold") arguments += " --start " + shell_quoted(record.start);
  return arguments;
}

}  // namespace lcp
