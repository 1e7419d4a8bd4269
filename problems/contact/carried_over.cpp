#include "problems/contact/carried_over.h"

#include <algorithm>

#include "solvers/errors.h"

namespace lcp {

namespace {

void require_same_number(const FrictionBlocks& blocks, const std::vector<Contact>& contacts) {
  if (blocks.contacts() != static_cast<Index>(contacts.size()))
    throw InvalidArgument("an LCP of {} contacts with {} ids, expected as many", blocks.contacts(),
                          contacts.size());
}

}  // namespace

SolutionByContact by_contact(const Result& solution, const FrictionBlocks& blocks,
                             const std::vector<Contact>& contacts) {
  require_same_number(blocks, contacts);
  SolutionByContact apart;
  for (Index i = 0; i < blocks.contacts(); ++i) {
    const std::vector<Index> rows = blocks.rows_of(i);
    if (const Index last = *std::max_element(rows.begin(), rows.end()); last >= solution.z.size())
      throw InvalidArgument("z has {} entries, but contact {} has row {}", solution.z.size(), i,
                            last);
    SolutionByContact::Share share{contacts[i].id, solution.z(rows), {}};
    for (std::size_t k = 0; solution.basis && k < rows.size(); ++k)
      if (std::binary_search(solution.basis->begin(), solution.basis->end(), rows[k]))
        share.basic.push_back(static_cast<Index>(k));
    apart.shares.push_back(std::move(share));
  }
  return apart;
}

Start carried_over(const SolutionByContact& solution, const FrictionBlocks& blocks,
                   const std::vector<Contact>& contacts, Index n) {
  require_same_number(blocks, contacts);
  Start start{.alpha = {}, .z = VectorXd::Zero(n)};
  std::vector<bool> taken(solution.shares.size(), false);
  for (Index i = 0; i < blocks.contacts(); ++i) {
    std::size_t s = 0;
    while (s < taken.size() && (taken[s] || solution.shares[s].id != contacts[i].id)) ++s;
    if (s == taken.size()) continue;
    taken[s] = true;
    const SolutionByContact::Share& share = solution.shares[s];
    std::vector<Index> rows = blocks.rows_of(i);
    if (static_cast<Index>(rows.size()) != share.z.size()) rows.resize(1);
    for (std::size_t k = 0; k < rows.size(); ++k) start.z(rows[k]) = share.z(static_cast<Index>(k));
    for (const Index k : share.basic)
      if (k < static_cast<Index>(rows.size())) start.alpha.push_back(rows[k]);
  }
  std::sort(start.alpha.begin(), start.alpha.end());
  return start;
}

}  // namespace lcp
