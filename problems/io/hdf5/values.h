#pragma once

#include <H5Cpp.h>
#include <fmt/format.h>

#include <map>
#include <string>
#include <vector>

#include "problems/io/limits.h"
#include "solvers/problem.h"

namespace lcp::hdf5 {

/// Bytes of the longest text we read.
inline constexpr std::size_t longest_text = 1 << 20;

/// A group of a file that is not trusted. Every reading function checks kind, extents and size
/// before it allocates, and throws UnreadableInput `file: /group/name: what is wrong, expected ...`
/// otherwise; whether numbers are finite is left to check(Problem).
class GroupReader {
 public:
  /// The root group of `file`.
  explicit GroupReader(const std::string& file);

  /// Path inside the file: empty for the root group, else /a/b.
  const std::string& path() const { return path_; }
  /// How messages about it begin: file: /a/b.
  std::string place() const { return file_ + ": " + (path_.empty() ? "/" : path_); }

  /// Whether there is a group or dataset of that name here.
  bool has(const std::string& name) const;
  bool has_group(const std::string& name) const;
  bool has_dataset(const std::string& name) const;
  GroupReader group(const std::string& name) const;
  /// Paths of all groups below this one relative to it, each object once however it is linked, in
  /// order of names.
  std::vector<std::string> groups_below() const;

  /// Numbers of any floating-point or integer type, converted to double.
  VectorXd vector(const std::string& name, Index size) const;
  /// A vector of any size up to `largest_rows`.
  VectorXd vector(const std::string& name) const;
  MatrixXd matrix(const std::string& name, Index rows, Index columns) const;
  std::vector<Index> integers(const std::string& name, Index size) const;
  /// A vector of integers of any size up to `most`.
  std::vector<Index> integers_up_to(const std::string& name, Index most) const;
  /// A vector of numbers of any size up to `most`.
  VectorXd vector_up_to(const std::string& name, Index most) const;
  /// A dataset of one integer.
  Index integer(const std::string& name) const { return integers(name, 1).front(); }

  bool has_attribute(const std::string& name) const;
  Index integer_attribute(const std::string& name) const;
  /// A text of fixed or variable length.
  std::string text_attribute(const std::string& name) const;
  /// Attributes of this group that are one text or one number, as text.
  std::map<std::string, std::string> printed_attributes() const;
  /// A dataset that is one text of fixed length; empty where it is something else or missing.
  std::string text(const std::string& name) const;

  /// Throws UnreadableInput about the object `name` of this group, or the group itself if empty.
  [[noreturn]] void fail(const std::string& name, const std::string& what) const;
  template <class... Arguments>
  [[noreturn]] void fail(const std::string& name, fmt::format_string<Arguments...> text,
                         Arguments&&... arguments) const {
    fail(name, fmt::format(text, std::forward<Arguments>(arguments)...));
  }

 private:
  GroupReader(std::string file, std::string path, H5::Group group);

  /// Opens a dataset of integers, or with `real` also of floating-point numbers, whose extents are
  /// `expected`.
  H5::DataSet open(const std::string& name, bool real, const std::vector<Index>& expected) const;
  /// The size of a vector of at most `most` numbers.
  Index size_of(const std::string& name, Index most) const;
  bool holds(const std::string& name, H5O_type_t type) const;
  H5::DataSet existing(const std::string& name, const char* expected) const;
  std::string printed_attribute(const std::string& name) const;
  /// Returns what `read` returns, and turns what the HDF5 library throws into UnreadableInput about `name`.
  template <class Read>
  auto guard(const std::string& name, Read read) const {
    try {
      return read();
    } catch (const H5::Exception& error) {
      fail(name, "the HDF5 library cannot read it ({})", error.getDetailMsg());
    }
  }
  /// Throws unless an attribute is one value of that kind.
  H5::Attribute attribute(const std::string& name, H5T_class_t kind, const char* expected) const;

  std::string file_;
  std::string path_;
  H5::Group group_;
};

/// Writers into a group. They throw H5::Exception, which write_corpus reports.
void write(H5::Group& group, const std::string& name, const VectorXd& numbers);
/// Row by row, as a reader of the file expects; compressed where that pays.
void write(H5::Group& group, const std::string& name, const MatrixXd& numbers);
/// As 32-bit integers, FCLIB's kind.
void write(H5::Group& group, const std::string& name, const std::vector<int>& numbers);
void write(H5::Group& group, const std::string& name, const std::vector<Index>& numbers);
void write_attribute(H5::Group& group, const std::string& name, Index value);
void write_attribute(H5::Group& group, const std::string& name, double value);
void write_attribute(H5::Group& group, const std::string& name, const std::string& text);

}  // namespace lcp::hdf5
