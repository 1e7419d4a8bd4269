// Best-first search over pivot candidates: the paper's robust solver and its variants.
//
// Source    K. Yamane, Y. Nakamura (2008), III, Algorithms 1 and 2.
// Notation  A node x is one pivot after the path of its ancestors; y_r the driving variable after
//           it, m' its column, q_min(i) the least element of q' after a pivot in row i; epsilon,
//           e_max and totalCost as in the paper. Each node has its own basis; goal nodes are those
//           in which z0 leaves.
// Cost      A node opened costs one basis change: on a factorised basis two products with n x k doubles,
//           and an LU every `refactor_every` nodes along a path and on every return to an abandoned
//           branch; n (n + 1) multiply-adds on a tableau, which such a return repeats from where it
//           forked. Candidates cost O(n) each, after O(n) that rules
//           out the rest. The queue holds (basis, driving variable) of every node generated: n/64
//           words each.
// Class     The complementary path of Lemke's algorithm is among those searched (exactly tied rows
//           all have q_min = 0), so whatever that path solves is solved if the queue may grow; no
//           basis is opened twice with the same driving variable, so the search ends. In floating
//           point a branch ends when its basis becomes singular or its error passes e_max, and
//           another is taken; candidates are lost when epsilon is below the rounding error of q'.
// Order     Where many contacts hold few freedoms most candidates cost nothing. Among them larger
//           pivots come first (Harris' idea for the ratio test): a pivot of 1e-9 among fourteen tied
//           ones leads into a subtree without a way out, which is then searched to its end.
// Patience  What leads astray is seldom near: a bad choice among tied rows at depth 50 shows as
//           thousands of nodes at depth 90, orders of the same few ties, of which the deepest are always
//           next. And where all candidates are noise of about 1e-10, a fine cost grid sends the search
//           from one branch to the next and never down, while a coarse one takes bad pivots for good
//           ones elsewhere. No order and no grid suits all frames, and most that one suits need few
//           nodes: so an attempt that takes long, or ends empty-handed, is followed by others in another
//           order among equals, then on a coarser grid.
// Differs   from lexicographic.cpp: a bad choice among tied rows can be taken back. The cost as
//           printed, sum of exp(-q_min), is about 1 per pivot where problems are degenerate and
//           makes the search breadth-first; `best-first-uniform` keeps it for the record, the other
//           rows sum exp(-q_min) - 1, that is, use minus the depth as a heuristic.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

#include "solvers/linalg/basis.h"
#include "solvers/linalg/complementary_path.h"
#include "solvers/linalg/pivot_candidates.h"
#include "solvers/linalg/polish.h"
#include "solvers/linalg/ratio_test.h"
#include "solvers/linalg/tableau.h"
#include "solvers/linalg/visited.h"
#include "solvers/registry.h"

namespace lcp {
namespace {

enum class Ties { deepest, lifo, fifo };
enum class Step0 { argmin, branch };
enum class Cost { excess, printed };
enum class Order { pivot, row, lexicographic };

struct BestFirstOptions {
  double epsilon = 1e-9;
  double e_max = 1e-6;
  Ties ties = Ties::deepest;
  Step0 step0 = Step0::argmin;
  Cost cost = Cost::excess;
  double cost_grid = 1e-11;
  Order order = Order::pivot;
  double delta = 1e-9;
  Index patience = 500;
  Index max_nodes = 20000;
  bool polish = true;
  PivotingOptions pivoting = {.pivot = 1e-12, .scale = true, .refactor_every = 8};
};

OptionTable option_table(BestFirstOptions& options, OptionTable pivoting) {
  OptionTable table = {
      real("epsilon", options.epsilon, 0, 1,
           "a row is a candidate if min q' after its pivot is above -epsilon; scale worked in")
          .accuracy({"1e-03", "1e-04", "1e-05", "1e-06", "1e-07", "1e-08", "1e-09", "1e-10",
                     "1e-11", "1e-12"}),
      real("e_max", options.e_max, 0, 1,
           "largest |w - M z - q - z0 c| a node may have when opened; scale worked in")
          .accuracy({"1e-03", "1e-06", "1e-09", "1e-12"}),
      choice("ties", options.ties, {"deepest", "lifo", "fifo"},
             "nodes of equal cost: deeper first, then earlier generated; newest; oldest first"),
      choice("step0", options.step0, {"argmin", "branch"},
             "Step 0 takes the least q_i, or every row is a candidate as in Step 1"),
      choice("cost", options.cost, {"excess", "printed"},
             "a pivot costs exp(-q_min) - 1, or exp(-q_min) as printed"),
      real("cost_grid", options.cost_grid, 1e-15, 1,
           "costs are rounded to multiples of this, so that the C library's exp decides nothing"),
      choice(
          "order", options.order, {"pivot", "row", "lexicographic"},
          "siblings of equal cost: larger pivots first; by row; or the lexicographic rule's choice "
          "first, and then pivots with q_min above -cost_grid/2 cost 0"),
      real("delta", options.delta, 0, 1, "tie threshold of order=lexicographic; scale worked in"),
      count(
          "patience", options.patience, 0, 100'000'000,
          "nodes after which the search begins again in another order of equals, then with a cost "
          "grid 100 times as coarse, as far as epsilon, last for good as at first; 0: never"),
      count("max_nodes", options.max_nodes, 1, 100'000'000, "nodes opened before `limit`"),
      flag("polish", options.polish,
           "solve once more on the final basis, refine, and set negative z to 0"),
  };
  for (Option& option : pivoting)
    if (option.name != "max_pivots")
      table.push_back(std::move(option));  // nodes are counted instead
  return table;
}

OptionTable tableau_options(BestFirstOptions& options) {
  return option_table(options, tableau_option_table(options.pivoting));
}

OptionTable factorised_options(BestFirstOptions& options) {
  return option_table(options, factorised_option_table(options.pivoting));
}

constexpr Index no_node = -1;

/// By how much each attempt's cost grid is coarser than the one before, and how far it may be above
/// epsilon: there every candidate costs nothing, and the deepest comes first.
constexpr double kWiden = 100, kWidest = 100;

struct Node {
  Index parent;
  Index depth;
  Pivot pivot;
  Variable leaving;
  std::int64_t cost;  ///< totalCost in units of cost_grid.
  double ratio;       ///< For the observer.
  double pivot_size;
  Index siblings;
  BasisKey key;  ///< Basis after the pivot, and the driving variable.
};

template <class Dictionary>
class Search {
 public:
  Search(const Problem& problem, const BestFirstOptions& options, const Call& call)
      : problem_(problem),
        options_(options),
        call_(call),
        scaled_(problem, options.pivoting.scale),
        alpha_(starting_alpha(problem, call)),
        dictionary_(scaled_, alpha_, options.pivoting),
        first_(dictionary_.labels().basic()),
        pricing_{.epsilon = options.epsilon,
                 .grid = options.cost_grid,
                 .clean_is_free = options.order == Order::lexicographic,
                 .as_printed = options.cost == Cost::printed},
        queue_(Later{&nodes_, options.ties}) {
    work_.start_pivots = static_cast<Index>(alpha_.size());
  }

  /// Algorithm 1.
  Result run() {
    if (!dictionary_.usable()) return not_usable();
    const double accepted = alpha_.empty() ? 0 : options_.epsilon;
    if (scaled_.size() == 0 || dictionary_.q().minCoeff() >= -accepted)
      return finish(Claim::solved, "");

    step0();
    while (!queue_.empty()) {
      if (work_.nodes == options_.max_nodes)
        return finish(Claim::limit, fmt::format("max_nodes={} reached", options_.max_nodes));
      const Index x = queue_.top();
      queue_.pop();
      if (!open(x)) continue;
      if (nodes_[x].leaving == labels().z0()) return finish(Claim::solved, "");
      add_descendants(x);
    }
    return finish(Claim::exhausted, "no pivot candidate is left");
  }

 private:
  /// Orders the queue: x after y. A node's number grows with its time of generation.
  struct Later {
    const std::vector<Node>* nodes;
    Ties ties;

    bool operator()(Index x, Index y) const {
      const Node &a = (*nodes)[x], &b = (*nodes)[y];
      if (a.cost != b.cost) return a.cost > b.cost;
      switch (ties) {
        case Ties::deepest:
          return std::tuple(-a.depth, x) > std::tuple(-b.depth, y);
        case Ties::lifo:
          return x < y;
        case Ties::fifo:
          return x > y;
      }
      return false;
    }
  };

  const Labels& labels() const { return dictionary_.labels(); }

  /// Candidates of Step 0: z0 grows until every row is non-negative, so that rows block whose c is
  /// positive.
  void step0() {
    dictionary_.column(labels().z0(), m_);
    const auto positive = [](double m) { return m > 0; };
    std::vector<PivotCandidate> roots = candidates_of(dictionary_.q(), m_, positive, pricing_);
    if (options_.step0 == Step0::argmin) {
      const VectorXd ratio = dictionary_.q().cwiseQuotient(m_);
      Index r;
      const double least = ratio.minCoeff(&r);
      if (options_.order == Order::lexicographic)  // the last of the tied rows is lexico-positive
        for (Index i = r + 1; i < ratio.size(); ++i)
          if (ratio(i) <= least + options_.delta) r = i;
      roots = {{r, -ratio(r), 0}};
    }
    for (const PivotCandidate& root : roots)
      append(no_node, labels().z0(), root, static_cast<Index>(roots.size()),
             BasisKey(labels(), -1));
  }

  /// Algorithm 2.
  void add_descendants(Index x) {
    const Variable driving = labels().complement(nodes_[x].leaving);
    dictionary_.column(driving, m_);
    const double pivot = options_.pivoting.pivot;
    const auto blocks = [pivot](double m) { return m < -pivot; };
    std::vector<PivotCandidate> candidates = candidates_of(dictionary_.q(), m_, blocks, pricing_);
    const Index z0_row = labels().row_of(labels().z0());
    const auto z0 = std::find_if(candidates.begin(), candidates.end(),
                                 [=](const PivotCandidate& c) { return c.row == z0_row; });
    if (z0 != candidates.end()) {  // a solution: nothing else matters
      candidates = {PivotCandidate(*z0)};
      // Nor may its q_min make it wait: whole levels of cost 0 would be searched first.
      if (options_.cost == Cost::excess) candidates.front().cost = 0;
    }
    if (options_.order == Order::lexicographic && candidates.size() > 1)
      put_lexicographic_choice_first(candidates);
    if (options_.order == Order::pivot)
      std::stable_sort(candidates.begin(), candidates.end(),
                       [this](const PivotCandidate& a, const PivotCandidate& b) {
                         return m_(a.row) < m_(b.row);
                       });
    const BasisKey key = nodes_[x].key;  // nodes_ may move while it grows
    for (const PivotCandidate& candidate : candidates)
      append(x, driving, candidate, static_cast<Index>(candidates.size()), key);
  }

  void put_lexicographic_choice_first(std::vector<PivotCandidate>& candidates) {
    const Blocking choice = lexicographic_ratio_test(
        dictionary_, m_, first_, {options_.pivoting.pivot, options_.delta, options_.delta});
    const auto chosen = std::find_if(candidates.begin(), candidates.end(),
                                     [&](const PivotCandidate& c) { return c.row == choice.row; });
    if (chosen != candidates.end()) std::rotate(candidates.begin(), chosen, chosen + 1);
  }

  /// Queues the pivot of `candidate` unless its basis was there with the same driving variable.
  void append(Index parent, Variable entering, const PivotCandidate& candidate, Index siblings,
              const BasisKey& before) {
    const Variable leaving = labels().basic(candidate.row);
    const Variable driving = leaving == labels().z0() ? -1 : labels().complement(leaving);
    BasisKey key = before.after(labels(), entering, leaving, driving);
    if (!visited_.insert(key)) return;
    const Index depth = parent == no_node ? 1 : nodes_[parent].depth + 1;
    const std::int64_t cost = candidate.cost + (parent == no_node ? 0 : nodes_[parent].cost);
    nodes_.push_back({parent,
                      depth,
                      {candidate.row, entering},
                      leaving,
                      cost,
                      candidate.ratio,
                      m_(candidate.row),
                      siblings,
                      std::move(key)});
    queue_.push(static_cast<Index>(nodes_.size()) - 1);
    work_.largest_queue = std::max(work_.largest_queue, static_cast<Index>(queue_.size()));
  }

  /// Brings the dictionary to node x; false if the branch ends here for want of accuracy. q_min is
  /// checked again: a nearly singular pivot can pass on its parent's numbers, leave no error in
  /// w - M z - q, and yet have a q' far below zero once its basis is factorised.
  bool open(Index x) {
    const Node& node = nodes_[x];
    if (node.parent == opened_) {
      dictionary_.pivot(node.pivot, m_);
    } else {
      dictionary_.rebuild(path_to(x));
    }
    opened_ = x;
    ++work_.nodes;
    ++work_.pivots;
    if (call_.observer)
      call_.observer({x + 1, node.parent + 1, node.pivot.row, node.pivot.entering, node.leaving,
                      node.ratio, node.pivot_size, node.siblings, &labels().basic()});
    return dictionary_.usable() && dictionary_.error_within(options_.e_max) &&
           dictionary_.q().minCoeff() > -options_.epsilon;
  }

  std::vector<Pivot> path_to(Index x) const {
    std::vector<Pivot> path;
    for (; x != no_node; x = nodes_[x].parent) path.push_back(nodes_[x].pivot);
    std::reverse(path.begin(), path.end());
    return path;
  }

  Result not_usable() {
    if (options_.pivoting.restart == Restart::none)
      return finish(Claim::singular, "start not usable");
    Result cold = Search(problem_, options_, {{}, call_.observer}).run();
    cold.work.factorisations += dictionary_.factorisations();
    cold.work.restarts = 1;
    return cold;
  }

  Result finish(Claim claim, std::string message) {
    work_.generated = static_cast<Index>(nodes_.size());
    work_.path = opened_ == no_node ? 0 : nodes_[opened_].depth;
    Result result = basic_result(scaled_, dictionary_, work_, claim, std::move(message));
    if (result.claim == Claim::solved && options_.polish)
      result.work.factorisations += polish(problem_, scaled_, result);
    return result;
  }

  const Problem& problem_;
  const BestFirstOptions& options_;
  const Call& call_;
  ScaledProblem scaled_;
  std::vector<Index> alpha_;
  Dictionary dictionary_;
  std::vector<Variable> first_;  ///< Basic variables of the first dictionary.
  Pricing pricing_;
  std::vector<Node> nodes_;  ///< Every node generated, in order.
  std::priority_queue<Index, std::vector<Index>, Later> queue_;
  Visited visited_;
  Index opened_ = no_node;  ///< Node the dictionary stands at.
  VectorXd m_;              ///< m' there.
  Work work_;
};

/// Work of attempts one after the other.
Work together(const Work& before, const Work& last) {
  Work work = before;
  work += last;
  work.path = last.path;
  return work;
}

/// The attempts before the last: on each cost grid in the order that is asked for, then in two others.
std::vector<BestFirstOptions> short_attempts(const BestFirstOptions& options) {
  std::vector<BestFirstOptions> attempts;
  if (options.patience == 0) return attempts;
  BestFirstOptions asked = options, ordered, tied;
  asked.max_nodes = options.patience;
  for (; asked.cost_grid < kWidest * options.epsilon; asked.cost_grid *= kWiden) {
    ordered = tied = asked;
    ordered.order = options.order == Order::lexicographic ? Order::pivot : Order::lexicographic;
    tied.ties = options.ties == Ties::lifo ? Ties::deepest : Ties::lifo;
    attempts.insert(attempts.end(), {asked, ordered, tied});
  }
  return attempts;
}

template <class Dictionary>
Result solve(const Problem& problem, const BestFirstOptions& options, const Call& call) {
  Work before;
  for (const BestFirstOptions& attempt : short_attempts(options)) {
    if (before.nodes + options.patience >= options.max_nodes) break;
    Result result = Search<Dictionary>(problem, attempt, call).run();
    result.work = together(before, result.work);
    if (result.claim != Claim::limit && result.claim != Claim::exhausted) return result;
    before = result.work;
    ++before.restarts;
  }
  BestFirstOptions last = options;
  last.max_nodes = options.max_nodes - before.nodes;
  Result result = Search<Dictionary>(problem, last, call).run();
  result.work = together(before, result.work);
  if (result.claim == Claim::limit)
    result.message = fmt::format("max_nodes={} reached", options.max_nodes);
  return result;
}

const Registration best_first{
    {"best-first", "best-first search over pivot candidates, on a factorised basis, scaled",
     "Yamane and Nakamura 2008, III, with minus the depth as heuristic", RowInfo::Kind::pivoting,
     "2"},
    BestFirstOptions{},
    factorised_options,
    solve<Basis>};

const Registration best_first_lexicographic{
    {"best-first-lexicographic",
     "the same, opening the lexicographic rule's choice first among siblings of equal cost",
     "best-first with the order of Yamane and Nakamura 2008, II-B; ours", RowInfo::Kind::pivoting,
     "2"},
    BestFirstOptions{.order = Order::lexicographic},
    factorised_options,
    solve<Basis>};

const Registration best_first_tableau{
    {"best-first-tableau",
     "the same search on an incrementally updated tableau with the paper's constants",
     "Yamane and Nakamura 2008, III and V", RowInfo::Kind::pivoting, "2"},
    BestFirstOptions{.epsilon = 1e-3,
                     .e_max = 1e-3,
                     .order = Order::row,
                     .patience = 0,
                     .polish = false,
                     .pivoting = {.pivot = 0, .scale = false}},
    tableau_options,
    solve<Tableau>};

const Registration best_first_uniform{
    {"best-first-uniform", "best-first with the cost exactly as printed (no depth term)",
     "Yamane and Nakamura 2008, Algorithm 2, line 7"},
    BestFirstOptions{.cost = Cost::printed, .order = Order::row, .patience = 0},
    factorised_options,
    solve<Basis>};

}  // namespace
}  // namespace lcp
