#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "harness/judge.h"

namespace lcp {

/// One row: what one solver did with one instance. Written as one line of JSON.
struct Record {
  static constexpr int schema = 1;

  std::string instance;
  std::string corpus;  ///< What comes before the first '/' of the instance's name.
  std::string sha256;
  Index n = 0;
  Index contacts = 0;
  std::optional<Index> active_contacts;
  std::string solver;            ///< Full spelling.
  std::string row;               ///< Name of the registry row.
  std::string version;           ///< Of the registry row.
  nlohmann::json options;        ///< Every option with its value, defaults included.
  std::string start = "cold";
  Claim claim = Claim::singular;  ///< Meaningless (and absent in JSON) where `verdict` is the runner's.
  std::string message;
  Verdict verdict = Verdict::not_run;
  bool unclaimed = false;
  bool trivial = false;
  double tolerance = 1e-6;
  std::optional<Accuracy> accuracy;  ///< Empty where there was no answer to measure.
  Work work;
  std::vector<std::int64_t> times_ns;  ///< One sample per repetition; time to failure on failures.
  int exit_signal = 0;                 ///< Of a crashed or killed worker.
  std::string stderr_end;              ///< Last 400 bytes a worker wrote to stdout or stderr.
  int jobs = 1;
  std::string environment;             ///< Id of env.json.

  /// Median of times_ns; empty when there is none.
  std::optional<std::int64_t> median_ns() const;
};

/// Non-finite numbers are written as strings ("inf", "nan"), which from_json reads back.
void to_json(nlohmann::json& json, const Record& record);
/// Throws std::invalid_argument saying which field is missing or malformed.
void from_json(const nlohmann::json& json, Record& record);

/// Reads rows.jsonl of a run directory, in file order. Throws std::runtime_error naming file and
/// line on a malformed row; an unfinished last line (a killed writer's) is dropped.
std::vector<Record> read_records(const std::string& directory);

/// Appends whole lines to rows.jsonl of a run directory, each flushed before the next begins.
class RecordWriter {
 public:
  /// Creates the file; throws std::system_error when it cannot.
  explicit RecordWriter(const std::string& directory);
  ~RecordWriter();
  RecordWriter(const RecordWriter&) = delete;
  RecordWriter& operator=(const RecordWriter&) = delete;
  /// Throws std::system_error on a full disk, leaving the rows before this one intact: what was
  /// written of this one is cut off again.
  void write(const Record& record);

 private:
  std::string path_;
  int file_ = -1;
};

/// Machine, compiler, flags, commit, library versions and jobs of a run, with a hash as "id".
nlohmann::json describe_environment(int jobs);

}  // namespace lcp
