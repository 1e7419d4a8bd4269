#include "problems/contact/islands.h"

#include <algorithm>
#include <numeric>

#include "solvers/errors.h"

namespace lcp {

namespace {

/// Contacts of each connected component of W's non-zero blocks, ascending.
std::vector<std::vector<Index>> components(const MatrixXd& W) {
  const Index contacts = W.rows() / 3;
  const auto touch = [&W](Index i, Index j) {
    return !W.block<3, 3>(3 * i, 3 * j).isZero(0) || !W.block<3, 3>(3 * j, 3 * i).isZero(0);
  };
  std::vector<std::vector<Index>> found;
  std::vector<bool> taken(contacts, false);
  for (Index seed = 0; seed < contacts; ++seed) {
    if (taken[seed]) continue;
    taken[seed] = true;
    std::vector<Index> members{seed};
    for (std::size_t next = 0; next < members.size(); ++next) {
      for (Index j = 0; j < contacts; ++j) {
        if (taken[j] || !touch(members[next], j)) continue;
        taken[j] = true;
        members.push_back(j);
      }
    }
    std::sort(members.begin(), members.end());
    found.push_back(std::move(members));
  }
  return found;
}

/// Rows of the LCP that belong to `members`, ascending.
std::vector<Index> rows_of(const FrictionBlocks& blocks, const std::vector<Index>& members) {
  std::vector<Index> rows;
  for (const Index i : members) {
    const std::vector<Index> own = blocks.rows_of(i);
    rows.insert(rows.end(), own.begin(), own.end());
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

FrictionBlocks take_blocks(const FrictionBlocks& blocks, const std::vector<Index>& members,
                           const std::vector<Index>& rows) {
  const Index m = blocks.directions_per_contact;
  const auto local = [&rows](Index row) -> Index {
    return row < 0 ? -1 : std::lower_bound(rows.begin(), rows.end(), row) - rows.begin();
  };
  std::vector<Index> axes, directions;
  FrictionBlocks part;
  for (const Index i : members) {
    for (Index k = 0; k < 3; ++k) axes.push_back(3 * i + k);
    for (Index k = 0; k < m; ++k) directions.push_back(m * i + k);
    part.normal_row.push_back(local(blocks.normal_row[i]));
    part.friction_row.push_back(local(blocks.friction_row[i]));
    part.cone_row.push_back(local(blocks.cone_row[i]));
  }
  part.W = blocks.W(axes, axes);
  part.vbar = blocks.vbar(axes);
  part.mu = blocks.mu(members);
  part.directions = blocks.directions(Eigen::all, directions);
  part.directions_per_contact = m;
  return part;
}

void require_every_row_once(const std::vector<Island>& islands, Index n) {
  std::vector<Index> times(n, 0);
  for (const Island& island : islands)
    for (const Index row : island.rows) ++times.at(row);
  for (Index row = 0; row < n; ++row)
    if (times[row] != 1)
      throw InvalidArgument("islands: row {} belongs to {} contacts, expected exactly 1", row,
                            times[row]);
}

}  // namespace

Island part_of_contacts(const Problem& problem, const std::vector<Index>& contacts) {
  const std::vector<Index> rows = rows_of(*problem.friction, contacts);
  Island island{restricted(problem, rows), rows};
  island.problem.friction = take_blocks(*problem.friction, contacts, rows);
  return island;
}

bool has_islands(const Problem& problem) {
  return problem.friction && components(problem.friction->W).size() > 1;
}

std::vector<Island> split_islands(const Problem& problem) {
  std::vector<Index> all(problem.size());
  std::iota(all.begin(), all.end(), Index{0});
  if (!problem.friction) return {{problem, all}};
  const std::vector<std::vector<Index>> groups = components(problem.friction->W);
  if (groups.size() <= 1) return {{problem, all}};

  std::vector<Island> islands;
  for (const std::vector<Index>& members : groups)
    islands.push_back(part_of_contacts(problem, members));
  require_every_row_once(islands, problem.size());
  return islands;
}

}  // namespace lcp
