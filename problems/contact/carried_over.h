#pragma once

#include <optional>
#include <vector>

#include "problems/contact/contact_problem.h"
#include "solvers/result.h"

namespace lcp {

/// A solution of the LCP (25) taken apart by contact, so that it can be carried over to a frame in
/// which contacts have come, gone or changed places.
struct SolutionByContact {
  struct Share {
    ContactId id;
    VectorXd z;                ///< a, then b_1 ... b_m and lambda where the contact has friction.
    std::vector<Index> basic;  ///< Entries of z that are basic, ascending.
  };

  std::vector<Share> shares;
};

/// Takes `solution` of the LCP with these blocks apart; `contacts` are theirs, in the same order.
/// Nothing is basic where the method keeps no basis. Throws std::invalid_argument when there are more
/// or fewer contacts than blocks, or z is too short for them.
SolutionByContact by_contact(const Result& solution, const FrictionBlocks& blocks,
                             const std::vector<Contact>& contacts);

/// The start that a solution of another frame gives to an LCP (25) of n rows with these blocks:
/// contacts are matched by their id, whatever their index (of several with one id the first with the
/// first); friction directions by their number, which is counted from a contact's own first one (along
/// its slip, where they are laid so). What a contact's unknowns were there they are here, a and b in N
/// and lambda in m/s, basic or not. A contact that was not there begins without force and with nothing
/// basic; of one that had friction in one frame only, or another number of directions, a alone is kept.
///
/// The basis need not be regular here: it is the solver that says whether it can start from it.
Start carried_over(const SolutionByContact& solution, const FrictionBlocks& blocks,
                   const std::vector<Contact>& contacts, Index n);

/// A frame's legacy to the next one: its solutions, where they were accepted.
struct FrameSolutions {
  std::optional<SolutionByContact> frictional, frictionless;
};

}  // namespace lcp
