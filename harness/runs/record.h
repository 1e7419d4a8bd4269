#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "harness/file_descriptor.h"
#include "harness/judge.h"

namespace lcp {

/// One row: what one solver did with one instance. Written as one line of JSON.
struct Record {
  static constexpr int schema = 1;

  std::string instance;
  Index place = 0;     ///< Of the instance among all of the run, counted before it is sharded.
  std::string corpus;  ///< What comes before the first '/' of the instance's name.
  std::string sha256;  ///< Of the instance, from a previous solution of that too (see run).
  Index n = 0;
  Index contacts = 0;
  std::optional<Index> active_contacts;
  std::string solver;      ///< Full spelling.
  std::string row;         ///< Name of the registry row.
  std::string version;     ///< Of the registry row.
  nlohmann::json options;  ///< Every option with its value, defaults included.
  std::string start = "cold";
  Claim claim = Claim::singular;  ///< Meaningless (and absent in JSON) where the verdict is the
                                  ///< runner's.
  std::string message;
  Verdict verdict = Verdict::not_run;
  bool unclaimed = false;
  bool trivial = false;
  double tolerance = 1e-6;
  std::optional<Accuracy> accuracy;  ///< Empty where there was no answer to measure.
  Work work;
  std::optional<VectorXd> z;           ///< Of a solved pair, in runs that keep answers.
  std::vector<std::int64_t> times_ns;  ///< One sample per repetition; time to failure on failures.
  int exit_signal = 0;                 ///< Of a crashed or killed worker.
  std::string stderr_end;              ///< Last 400 bytes a worker wrote to stdout or stderr.
  int jobs = 1;
  std::string environment;  ///< Id of env.json.

  /// Median of times_ns (see observed_quantile); empty when there is none.
  std::optional<std::int64_t> median_ns() const;
};

/// What makes two rows the same piece of work. The name stands beside the hash because a corpus may
/// hold one problem twice.
struct PairKey {
  std::string instance;
  std::string sha256;
  std::string solver;  ///< Full spelling.
  std::string start;

  auto operator<=>(const PairKey&) const = default;
};

PairKey key_of(const Record& record);

/// True for timeout, memory, crash and not-run: there was no answer to judge.
bool decided_by_runner(Verdict verdict);

void to_json(nlohmann::json& json, const Work& work);
/// Throws as from_json of a record.
void from_json(const nlohmann::json& json, Work& work);

/// Non-finite numbers are written as strings ("inf", "-inf", "nan"), which from_json reads back.
void to_json(nlohmann::json& json, const Record& record);
/// Throws std::invalid_argument saying which field is missing or malformed.
void from_json(const nlohmann::json& json, Record& record);

/// Reads rows.jsonl of a run directory, in file order; where there is none, rows.jsonl.xz, which the
/// program xz unpacks. Throws std::runtime_error naming the file,
/// and the line of a malformed row; an unfinished last line (a killed writer's) is dropped.
std::vector<Record> read_records(const std::string& directory);

/// Appends whole lines to rows.jsonl of a run directory, each handed to the system in one piece
/// before the next begins.
class RecordWriter {
 public:
  /// Creates the file or continues it, cutting off an unfinished last line; throws
  /// std::system_error when it cannot, or when another process is writing it.
  explicit RecordWriter(const std::string& directory);
  /// Throws std::system_error on a full disk, leaving the rows before this one intact: what was
  /// written of this one is cut off again. Bytes that are not UTF-8 (a worker's output may be
  /// anything) are replaced by U+FFFD.
  void write(const Record& record);

 private:
  std::string path_;
  FileDescriptor file_;
};

}  // namespace lcp
