#include "problems/io/text/matrix_market.h"

#include <cholmod.h>
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <new>
#include <string_view>

#include "problems/io/errors.h"
#include "problems/io/replace_file.h"
#include "problems/io/text/matrix_market_text.h"
#include "problems/io/text/read_text.h"

namespace lcp {

namespace {

/// CHOLMOD writes numbers from here on as if they were infinite.
constexpr double cholmod_infinity = 1e308;

std::string file_of_q(const std::string& path_of_M) {
  const std::string_view ending = matrix_market_ending;
  return path_of_M.substr(0, path_of_M.size() - ending.size()) + ".q.mtx";
}

/// CHOLMOD's workspace, with its printing switched off.
class Cholmod {
 public:
  Cholmod() {
    cholmod_start(&common_);
    common_.print = 0;
  }
  ~Cholmod() { cholmod_finish(&common_); }
  Cholmod(const Cholmod&) = delete;
  Cholmod& operator=(const Cholmod&) = delete;
  cholmod_common* common() { return &common_; }

  auto own(cholmod_sparse* matrix) {
    const auto free = [this](cholmod_sparse* it) { cholmod_free_sparse(&it, &common_); };
    return std::unique_ptr<cholmod_sparse, decltype(free)>(matrix, free);
  }
  auto own(cholmod_dense* matrix) {
    const auto free = [this](cholmod_dense* it) { cholmod_free_dense(&it, &common_); };
    return std::unique_ptr<cholmod_dense, decltype(free)>(matrix, free);
  }

 private:
  cholmod_common common_;
};

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

// --- reading ---

MatrixXd from_dense(const cholmod_dense& matrix) {
  return Eigen::Map<const MatrixXd, 0, Eigen::OuterStride<>>(
      static_cast<const double*>(matrix.x), static_cast<Index>(matrix.nrow),
      static_cast<Index>(matrix.ncol), Eigen::OuterStride<>(static_cast<Index>(matrix.d)));
}

/// Reads a matrix of any storage, both triangles of it.
MatrixXd read_matrix(const std::string& path) {
  std::string text = read_text(path, "a Matrix Market file", longest_file);
  check_matrix_market_text(path, text);
  constexpr int both_triangles = 1;
  const File file(fmemopen(text.data(), text.size(), "r"));
  Cholmod cholmod;
  int type = CHOLMOD_DENSE;
  void* found = cholmod_read_matrix(file.get(), both_triangles, &type, cholmod.common());
  if (found == nullptr)
    throw UnreadableInput(
        fmt::format("{}: CHOLMOD cannot read it, expected a Matrix Market file", path));
  const auto sparse =
      cholmod.own(type == CHOLMOD_SPARSE ? static_cast<cholmod_sparse*>(found) : nullptr);
  const auto dense = cholmod.own(sparse ? cholmod_sparse_to_dense(sparse.get(), cholmod.common())
                                        : static_cast<cholmod_dense*>(found));
  if (!dense) throw std::bad_alloc();
  return from_dense(*dense);
}

// --- writing ---

/// Why a pair of matrices cannot hold the problem; empty when it can.
std::string reason_to_refuse(const Problem& problem) {
  if (problem.size() == 0) return "the instance is empty (n = 0)";
  if (problem.friction) return "the instance has friction blocks";
  if (problem.c.size() > 0) return "the instance has a covering vector of its own";
  if (problem.pivot_limit != 0) return "the instance has a pivot limit of its own";
  if (problem.M.cwiseAbs().maxCoeff() >= cholmod_infinity ||
      problem.q.cwiseAbs().maxCoeff() >= cholmod_infinity)
    return fmt::format("the instance has numbers beyond {}", cholmod_infinity);
  Problem plain = problem;
  set_plain_scales(plain);
  if (plain.s_z != problem.s_z || plain.s_w != problem.s_w)
    return "the instance has scales of its own";
  return "";
}

/// What `write` prints to a file, as text.
template <class Write>
std::string print(const std::string& path, Write write) {
  char* bytes = nullptr;
  std::size_t size = 0;
  bool done = false;
  {
    const File memory(open_memstream(&bytes, &size));
    done = memory && write(memory.get()) >= 0;
  }
  const std::unique_ptr<char, decltype(&std::free)> owned(bytes, &std::free);
  if (!done) throw UnwritableOutput(fmt::format("{}: CHOLMOD cannot write the matrix", path));
  return std::string(bytes, size);
}

/// A view of a matrix or vector for CHOLMOD, which takes no const but does not write.
cholmod_dense view(const double* numbers, Index rows, Index columns) {
  cholmod_dense matrix{};
  matrix.nrow = static_cast<std::size_t>(rows);
  matrix.ncol = static_cast<std::size_t>(columns);
  matrix.nzmax = matrix.nrow * matrix.ncol;
  matrix.d = matrix.nrow;
  matrix.x = const_cast<double*>(numbers);
  matrix.xtype = CHOLMOD_REAL;
  matrix.dtype = CHOLMOD_DOUBLE;
  return matrix;
}

}  // namespace

Instance read_matrix_market(const std::string& path, const std::string& name) {
  const std::string path_of_q = file_of_q(path);
  Problem problem;
  problem.M = read_matrix(path);
  const Index n = problem.M.rows();
  if (problem.M.cols() != n)
    throw UnreadableInput(
        fmt::format("{}: M is {} x {}, expected a square matrix", path, n, problem.M.cols()));
  const MatrixXd q = read_matrix(path_of_q);
  if (q.rows() != n || q.cols() != 1)
    throw UnreadableInput(
        fmt::format("{}: q is {} x {}, expected {} x 1", path_of_q, q.rows(), q.cols(), n));
  problem.q = q.col(0);
  try {
    return make_instance(name, std::move(problem), {{"file", path}});
  } catch (const std::invalid_argument& error) {
    throw UnreadableInput(fmt::format("{}: {}", path, error.what()));
  }
}

void write_matrix_market(const std::string& path, const Instance& instance) {
  const Problem& problem = instance.problem;
  const std::string reason = reason_to_refuse(problem);
  if (!reason.empty())
    throw UnwritableOutput(fmt::format("{}: Matrix Market cannot hold '{}': {}; write .hdf5", path,
                                       instance.name, reason));
  Cholmod cholmod;
  cholmod_dense dense = view(problem.M.data(), problem.size(), problem.size());
  cholmod_dense q = view(problem.q.data(), problem.size(), 1);
  const auto M = cholmod.own(cholmod_dense_to_sparse(&dense, true, cholmod.common()));
  const std::string text_of_M = print(path, [&](std::FILE* file) {
    return cholmod_write_sparse(file, M.get(), nullptr, nullptr, cholmod.common());
  });
  const std::string text_of_q = print(file_of_q(path), [&](std::FILE* file) {
    return cholmod_write_dense(file, &q, nullptr, cholmod.common());
  });
  replace_file(file_of_q(path), text_of_q);
  replace_file(path, text_of_M);
}

}  // namespace lcp
