#include "harness/runs/run_directory.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <system_error>

#include "harness/measure/environment.h"
#include "harness/runs/rows.h"
#include "problems/io/errors.h"
#include "problems/io/replace_file.h"

namespace lcp {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Does what writes rows, turning the system's refusal into an UnwritableOutput.
template <class Write>
auto writing_rows(Write write) {
  try {
    return write();
  } catch (const std::system_error& error) {
    throw UnwritableOutput(error.what());
  }
}

json read_json(const fs::path& file) {
  std::ifstream stream(file);
  if (!stream) throw UnreadableInput(fmt::format("{}: cannot be read", file.string()));
  try {
    return json::parse(stream);
  } catch (const json::exception& error) {
    throw UnreadableInput(fmt::format("{}: {}", file.string(), error.what()));
  }
}

RunSettings read_settings(const fs::path& directory) {
  const fs::path file = directory / "run.json";
  const json object = read_json(file);
  try {
    return object.get<RunSettings>();
  } catch (const std::invalid_argument& error) {
    throw UnreadableInput(fmt::format("{}: {}", file.string(), error.what()));
  }
}

/// An environment's description; it must say its id and commit.
json read_environment(const fs::path& file) {
  const json environment = read_json(file);
  for (const char* field : {"id", "commit"})
    if (!environment.is_object() || !environment.contains(field) ||
        !environment.at(field).is_string())
      throw UnreadableInput(fmt::format("{}: field '{}' is missing", file.string(), field));
  return environment;
}

void write_json(const fs::path& file, const json& object) {
  replace_file(file.string(), object.dump(1) + "\n");
}

fs::path file_of(const fs::path& directory, const json& environment, bool first) {
  return directory /
         (first ? "env.json" : fmt::format("env-{}.json", environment.at("id").get<std::string>()));
}

std::vector<Record> read_rows(const fs::path& directory) {
  try {
    return read_records(directory.string());
  } catch (const std::runtime_error& error) {
    throw UnreadableInput(error.what());
  }
}

/// Throws std::invalid_argument unless the run in `directory` may go on as `now` in `environment`.
void require_same_run(const fs::path& directory, const RunSettings& begun, const RunSettings& now,
                      const json& begun_in, const json& environment) {
  if (begun_in.at("commit") != environment.at("commit"))
    throw std::invalid_argument(fmt::format(
        "{} was begun by commit {}, this program is {}: name a new directory with --out",
        directory.string(), begun_in.at("commit").get<std::string>(),
        environment.at("commit").get<std::string>()));
  if (begun.shard != now.shard)
    throw std::invalid_argument(fmt::format("{} holds shard {}, this is {}: name another directory",
                                            directory.string(), to_string(begun.shard),
                                            to_string(now.shard)));
  if (const std::vector<std::string> found = conflicts(begun, now); !found.empty())
    throw std::invalid_argument(
        fmt::format("{} was begun otherwise (then, now): {}; name a new directory with --out",
                    directory.string(), fmt::join(found, "; ")));
}

/// Makes a directory that holds a run ready to go on with it; the settings to store come back.
RunSettings resume(const fs::path& directory, RunSettings settings, const json& environment,
                   const std::function<void(const std::string&)>& note) {
  const auto [before, known] = read_run_header(directory);
  require_same_run(directory, before, settings, known.front(), environment);
  if (environment.at("dirty") == true)
    note("built from a changed tree: rows of different code cannot be told apart");
  const bool new_here = std::none_of(known.begin(), known.end(), [&](const json& each) {
    return each.at("id") == environment.at("id");
  });
  if (new_here) {
    note("the run goes on in another environment: compare times within one only");
    write_json(file_of(directory, environment, false), environment);
  }
  remove_unfinished(directory);
  std::vector<std::string> solvers = before.solvers;
  append_missing(solvers, settings.solvers);
  settings.solvers = std::move(solvers);
  return settings;
}

}  // namespace

OpenRun open_run(const fs::path& directory, RunSettings settings, int jobs, Existing existing,
                 const std::function<void(const std::string&)>& note) {
  const bool there = fs::exists(directory);
  if (there && existing == Existing::refuse)
    throw std::invalid_argument(
        fmt::format("{} exists: --resume continues it; or name a new directory, or move it aside",
                    directory.string()));
  const bool begun = there && fs::exists(directory / "run.json");
  if (there && !begun && fs::exists(directory / "rows.jsonl"))
    throw std::invalid_argument(fmt::format(
        "{} has rows but no run.json, so it cannot be resumed: name a new directory with --out",
        directory.string()));

  const json environment = describe_environment(jobs);
  if (begun) {
    settings = resume(directory, std::move(settings), environment, note);
  } else {
    make_directories(directory);
    remove_unfinished(directory);  // of a run killed before it had a run.json
    write_json(file_of(directory, environment, true), environment);
  }
  return {std::move(settings), environment.at("id").get<std::string>(), begun};
}

void write_run_settings(const fs::path& directory, const RunSettings& settings) {
  write_json(directory / "run.json", settings);
}

std::function<void(const Record&)> open_rows(const fs::path& directory) {
  const auto writer =
      writing_rows([&] { return std::make_shared<RecordWriter>(directory.string()); });
  return [writer](const Record& record) { writing_rows([&] { writer->write(record); }); };
}

namespace {

/// A run of several parts into one directory.
class RunSession {
 public:
  /// Prepares the directory, and fills environment and done of `plan`.
  RunSession(const fs::path& directory, RunPlan& plan, RunSettings settings, Existing existing,
             const std::function<void(const std::string&)>& note)
      : directory_(directory),
        run_(open_run(directory, std::move(settings), plan.jobs, existing, note)) {
    plan.environment = run_.environment;
    if (run_.begun)
      plan.done = pairs_done(directory);
    else
      begin_rows();
    report_.rows_before = plan.done.size();
  }

  /// Runs what is open of `part`.
  void run_part(const RunPlan& part, const std::function<void(const Progress&)>& progress,
                const std::atomic<bool>& interrupted) {
    if (run_.begun && open_pairs(part).empty()) return;
    begin_rows();
    run(
        part,
        [&](const Record& record) {
          write_row_(record);
          ++report_.rows;
        },
        progress, interrupted);
  }

  RunReport finish(bool interrupted) {
    if (!run_.begun && !interrupted) {
      const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
      run_.settings.seconds = elapsed.count();
      write_run_settings(directory_, run_.settings);
    }
    return report_;
  }

 private:
  /// A run that is resumed only to find nothing left keeps its settings, `seconds` among them.
  void begin_rows() {
    if (write_row_) return;
    write_run_settings(directory_, run_.settings);
    write_row_ = open_rows(directory_);
    begin_ = std::chrono::steady_clock::now();
  }

  const fs::path directory_;
  OpenRun run_;
  std::function<void(const Record&)> write_row_;
  std::chrono::steady_clock::time_point begin_;
  RunReport report_;
};

}  // namespace

RunReport run_into(const fs::path& directory, RunPlan plan, const Origin& origin, Existing existing,
                   const std::function<void(const std::string&)>& note,
                   const std::function<void(const Progress&)>& progress,
                   const std::atomic<bool>& interrupted) {
  RunSession session(directory, plan, settings_of(plan, origin), existing, note);
  session.run_part(plan, progress, interrupted);
  return session.finish(interrupted);
}

RunReport run_into(const fs::path& directory, RunPlan plan, const Expansion& expansion,
                   const Origin& origin, Existing existing,
                   const std::function<void(const std::string&)>& note,
                   const std::function<void(const Progress&)>& progress,
                   const std::atomic<bool>& interrupted) {
  RunSettings settings = settings_of(plan, origin);
  const auto in_shard = [shard = plan.shard](std::size_t k) {
    return static_cast<Index>(k) % shard.count == shard.index;
  };
  const std::size_t entrants = plan.solvers.size() * plan.starts.size();
  Progress whole;
  settings.instances = 0;
  for (std::size_t k = 0; k < plan.instances.size(); ++k) {
    const Index count = expansion.count(plan.instances[k]);
    settings.instances += count;
    if (in_shard(k)) whole.total += static_cast<std::size_t>(count) * entrants;
  }
  RunSession session(directory, plan, std::move(settings), existing, note);

  const std::vector<Instance> instances = std::move(plan.instances);
  RunPlan part = std::move(plan);
  part.shard = {};
  for (std::size_t k = 0; k < instances.size() && !interrupted; ++k) {
    const Index count = expansion.count(instances[k]);
    if (in_shard(k)) {
      part.instances = expansion.make(instances[k]);
      const std::size_t open = open_pairs(part).size();
      whole.total -= static_cast<std::size_t>(count) * entrants - open;
      session.run_part(
          part,
          [&](const Progress& now) {
            progress({whole.done + now.done, whole.total, now.at});
          },
          interrupted);
      whole.done += open;
    }
    part.first_place += count;
  }
  return session.finish(interrupted);
}

std::set<PairKey> pairs_done(const fs::path& directory) {
  std::set<PairKey> keys;
  if (!fs::exists(directory / "rows.jsonl")) return keys;
  for (const Record& record : read_rows(directory)) keys.insert(key_of(record));
  return keys;
}

std::vector<json> read_environments(const fs::path& directory) {
  std::vector<json> environments{read_environment(directory / "env.json")};
  std::vector<fs::path> others;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory))
    if (entry.path().filename().string().starts_with("env-")) others.push_back(entry.path());
  std::sort(others.begin(), others.end());
  for (const fs::path& file : others) environments.push_back(read_environment(file));
  return environments;
}

RunHeader read_run_header(const fs::path& directory) {
  return {read_settings(directory), read_environments(directory)};
}

StoredRun read_stored_run(const fs::path& directory) {
  const RunHeader header = read_run_header(directory);
  StoredRun run{directory, header.settings, header.environments, read_rows(directory)};
  sort_rows(run.rows, run.settings.solvers);
  return run;
}

void write_stored_run(const StoredRun& run) {
  const fs::path& directory = run.directory;
  if (fs::exists(directory))
    throw std::invalid_argument(
        fmt::format("{} exists: name a new directory, or move it aside", directory.string()));
  // All of it in a directory beside, which then takes its name.
  fs::path unfinished = directory;
  unfinished += fmt::format(".{}.tmp", getpid());
  make_directories(unfinished);
  try {
    for (const json& environment : run.environments)
      write_json(file_of(unfinished, environment, &environment == &run.environments.front()),
                 environment);
    write_json(unfinished / "run.json", run.settings);
    writing_rows([&] {
      RecordWriter writer(unfinished.string());
      for (const Record& record : run.rows) writer.write(record);
    });
    std::error_code error;
    fs::rename(unfinished, directory, error);
    if (error)
      throw UnwritableOutput(
          fmt::format("{}: cannot create: {}", directory.string(), error.message()));
  } catch (...) {
    std::error_code nobody_minds;
    fs::remove_all(unfinished, nobody_minds);
    throw;
  }
}

std::vector<Record> read_run(const fs::path& directory) {
  std::vector<Record> rows = read_rows(directory);
  if (fs::exists(directory / "run.json")) sort_rows(rows, read_settings(directory).solvers);
  return rows;
}

}  // namespace lcp
