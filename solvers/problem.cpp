#include "solvers/problem.h"

#include "solvers/errors.h"

namespace lcp {

std::vector<Index> FrictionBlocks::rows_of(Index i) const {
  std::vector<Index> rows = {normal_row[i]};
  if (friction_row[i] < 0) return rows;
  for (Index k = 0; k < directions_per_contact; ++k) rows.push_back(friction_row[i] + k);
  rows.push_back(cone_row[i]);
  return rows;
}

Problem restricted(const Problem& problem, const std::vector<Index>& rows) {
  Problem part;
  part.M = problem.M(rows, rows);
  part.q = problem.q(rows);
  part.s_z = problem.s_z(rows);
  part.s_w = problem.s_w(rows);
  if (problem.c.size() > 0) part.c = problem.c(rows);
  part.pivot_limit = problem.pivot_limit;
  return part;
}

void set_plain_scales(Problem& problem) {
  const Index n = problem.size();
  const double largest_q = n > 0 ? problem.q.lpNorm<Eigen::Infinity>() : 0;
  const double largest_M = n > 0 ? problem.M.cwiseAbs().maxCoeff() : 0;
  const double s_w = largest_q > 0 ? largest_q : 1;
  const double s_z = largest_M > 0 ? s_w / largest_M : s_w;
  problem.s_w = VectorXd::Constant(n, s_w);
  problem.s_z = VectorXd::Constant(n, s_z);
}

namespace {

void require_shape(Index rows, Index columns, Index want_rows, Index want_columns,
                   const std::string& where, const char* field) {
  if (rows == want_rows && columns == want_columns) return;
  throw InvalidArgument("{}: {} is {} x {}, expected {} x {}", where, field, rows, columns,
                        want_rows, want_columns);
}

void require_finite(const Eigen::Ref<const MatrixXd>& numbers, const std::string& where,
                    const char* field) {
  for (Index j = 0; j < numbers.cols(); ++j)
    for (Index i = 0; i < numbers.rows(); ++i)
      if (!std::isfinite(numbers(i, j)))
        throw InvalidArgument("{}: {}({}, {}) is {}, expected a finite number", where, field, i, j,
                              numbers(i, j));
}

void require_positive(const VectorXd& numbers, const std::string& where, const char* field) {
  require_finite(numbers, where, field);
  for (Index i = 0; i < numbers.size(); ++i)
    if (!(numbers(i) > 0))
      throw InvalidArgument("{}: {}({}) is {}, expected a positive number", where, field, i,
                            numbers(i));
}

void require_row(Index row, Index size, Index n, const std::string& where, const char* field,
                 Index contact) {
  if (row >= 0 && row <= n - size) return;
  throw InvalidArgument("{}: {} of contact {} is {}, expected 0 ... {}", where, field, contact, row,
                        n - size);
}

void check_friction(const FrictionBlocks& blocks, Index n, const std::string& where) {
  const Index contacts = blocks.contacts(), m = blocks.directions_per_contact;
  require_shape(blocks.W.rows(), blocks.W.cols(), 3 * contacts, 3 * contacts, where, "W");
  require_shape(blocks.vbar.size(), 1, 3 * contacts, 1, where, "vbar");
  require_finite(blocks.W, where, "W");
  require_finite(blocks.vbar, where, "vbar");
  require_finite(blocks.mu, where, "mu");
  require_shape(blocks.directions.rows(), blocks.directions.cols(), 2, contacts * m, where,
                "directions");
  require_finite(blocks.directions, where, "directions");
  const Index rows = static_cast<Index>(blocks.normal_row.size());
  require_shape(rows, 1, contacts, 1, where, "normal_row");
  require_shape(static_cast<Index>(blocks.friction_row.size()), 1, contacts, 1, where,
                "friction_row");
  require_shape(static_cast<Index>(blocks.cone_row.size()), 1, contacts, 1, where, "cone_row");
  for (Index i = 0; i < contacts; ++i) {
    if (blocks.mu(i) < 0)
      throw InvalidArgument("{}: mu({}) is {}, expected 0 or more", where, i, blocks.mu(i));
    require_row(blocks.normal_row[i], 1, n, where, "normal_row", i);
    if (blocks.friction_row[i] < 0 && blocks.cone_row[i] < 0 && blocks.mu(i) == 0) continue;
    require_row(blocks.friction_row[i], m, n, where, "friction_row", i);
    require_row(blocks.cone_row[i], 1, n, where, "cone_row", i);
  }
}

}  // namespace

void check(const Problem& problem, const std::string& where) {
  const Index n = problem.size();
  require_shape(problem.M.rows(), problem.M.cols(), n, n, where, "M");
  require_shape(problem.s_z.size(), 1, n, 1, where, "s_z");
  require_shape(problem.s_w.size(), 1, n, 1, where, "s_w");
  require_finite(problem.M, where, "M");
  require_finite(problem.q, where, "q");
  require_positive(problem.s_z, where, "s_z");
  require_positive(problem.s_w, where, "s_w");
  if (problem.c.size() > 0) {
    require_shape(problem.c.size(), 1, n, 1, where, "c");
    require_positive(problem.c, where, "c");
  }
  if (problem.pivot_limit < 0)
    throw InvalidArgument("{}: pivot_limit is {}, expected 0 or more", where, problem.pivot_limit);
  if (problem.friction) check_friction(*problem.friction, n, where);
}

}  // namespace lcp
