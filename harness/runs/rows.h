#pragma once

#include <string>
#include <vector>

#include "harness/record.h"
#include "problems/io/file_descriptor.h"

namespace lcp {

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
