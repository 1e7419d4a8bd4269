// Best-first search over pivot candidates: the paper's robust solver and its variants.
//
// Source    K. Yamane, Y. Nakamura (2008), III, Algorithms 1 and 2.
// Notation  A node x is one pivot after the path of its ancestors; y_r the driving variable after
//           it, m' its column, q_min(i) the least element of q' after a pivot in row i; epsilon,
//           e_max and totalCost as in the paper. Each node has its own basis; goal nodes are those
//           in which z0 leaves.
// Cost      A node opened costs one basis change. On a factorised basis that is one product with n x k
//           doubles, n for each pivot since the last LU, and an LU every `refactor_every` nodes along a
//           path, where rounding may have grown, and on every return to an abandoned branch. On a
//           tableau it is n (n + 1) multiply-adds, which such a return repeats from where it forked.
//           Candidates cost O(n) each, after O(n) that rules out the rest. Bases opened are kept: n/64
//           words each; of the children of a node only the best one waiting is in the queue.
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
  PivotingOptions pivoting = {.pivot = 1e-12, .scale = true, .refactor_every = 32};
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
      choice("ties", options.ties,
             "nodes of equal cost: deeper first, then earlier generated; newest; oldest first"),
      choice("step0", options.step0,
             "Step 0 takes the least q_i, or every row is a candidate as in Step 1"),
      choice("cost", options.cost, "a pivot costs exp(-q_min) - 1, or exp(-q_min) as printed"),
      real("cost_grid", options.cost_grid, 1e-15, 1,
           "costs are rounded to multiples of this, so that the C library's exp decides nothing"),
      choice(
          "order", options.order,
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

/// Nodes and children for which there is room before anything is allocated again.
constexpr std::size_t kRoom = 64;

/// A pivot that was carried out.
struct Node {
  Index parent;
  Index depth;
  Pivot pivot;
  Variable leaving;
  std::int64_t cost;  ///< totalCost in units of cost_grid.
  Index number;       ///< In order of generation, from 1.
  Index key;          ///< Number of its basis and driving variable among those visited.
};

/// A candidate of a node, not opened yet.
struct Child {
  Index row;
  Variable leaving;
  double ratio;  ///< For the observer.
  double pivot_size;
  std::int64_t cost;  ///< Of this pivot alone.
  Index number;
};

/// The candidates of one node, children_[next] ... [end - 1] still waiting, best first.
struct Siblings {
  Index parent;
  Variable entering;
  Index next, end;
  Index count;
};

/// The best of the siblings that wait; the others follow when it is taken.
struct Waiting {
  std::int64_t cost;
  Index depth;
  Index siblings;
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
        queue_(Later{options.ties}) {
    work_.start_pivots = static_cast<Index>(alpha_.size());
  }

  /// Algorithm 1.
  Result run() {
    if (!dictionary_.usable()) return not_usable();
    const double accepted = alpha_.empty() ? 0 : options_.epsilon;
    if (scaled_.size() == 0 || dictionary_.q().minCoeff() >= -accepted)
      return finish(Claim::solved, "");

    nodes_.reserve(kRoom);
    children_.reserve(kRoom);
    siblings_.reserve(kRoom);
    candidates_.reserve(kRoom);
    step0();
    while (!queue_.empty()) {
      if (work_.nodes == options_.max_nodes)
        return finish(Claim::limit, fmt::format("max_nodes={} reached", options_.max_nodes));
      if (!open_next()) continue;
      if (nodes_[opened_].leaving == labels().z0()) return finish(Claim::solved, "");
      add_descendants();
    }
    return finish(Claim::exhausted, "no pivot candidate is left");
  }

 private:
  /// Orders the queue: a after b. Siblings are numbered in order of generation.
  struct Later {
    Ties ties;

    bool operator()(const Waiting& a, const Waiting& b) const {
      if (a.cost != b.cost) return a.cost > b.cost;
      if (ties == Ties::deepest && a.depth != b.depth) return a.depth < b.depth;
      return ties == Ties::lifo ? a.siblings < b.siblings : a.siblings > b.siblings;
    }
  };

  const Labels& labels() const { return dictionary_.labels(); }

  /// Candidates of Step 0: z0 grows until every row is non-negative, so that rows block whose c is
  /// positive.
  void step0() {
    dictionary_.column(labels().z0(), m_);
    const auto positive = [](double m) { return m > 0; };
    find_candidates(dictionary_.q(), m_, positive, pricing_, ratios_, candidates_);
    if (options_.step0 == Step0::argmin) {
      const VectorXd ratio = dictionary_.q().cwiseQuotient(m_);
      Index r;
      const double least = ratio.minCoeff(&r);
      if (options_.order == Order::lexicographic)  // the last of the tied rows is lexico-positive
        for (Index i = r + 1; i < ratio.size(); ++i)
          if (ratio(i) <= least + options_.delta) r = i;
      candidates_ = {{r, -ratio(r), 0}};
    }
    append_candidates(labels().z0());
  }

  /// Algorithm 2.
  void add_descendants() {
    const Variable driving = labels().complement(nodes_[opened_].leaving);
    dictionary_.column(driving, m_);
    const double pivot = options_.pivoting.pivot;
    const auto blocks = [pivot](double m) { return m < -pivot; };
    find_candidates(dictionary_.q(), m_, blocks, pricing_, ratios_, candidates_);
    const Index z0_row = labels().row_of(labels().z0());
    const auto z0 = std::find_if(candidates_.begin(), candidates_.end(),
                                 [=](const PivotCandidate& c) { return c.row == z0_row; });
    if (z0 != candidates_.end()) {  // a solution: nothing else matters
      candidates_ = {PivotCandidate(*z0)};
      // Nor may its q_min make it wait: whole levels of cost 0 would be searched first.
      if (options_.cost == Cost::excess) candidates_.front().cost = 0;
    }
    if (options_.order == Order::lexicographic && candidates_.size() > 1)
      put_lexicographic_choice_first();
    if (options_.order == Order::pivot)
      std::sort(candidates_.begin(), candidates_.end(),
                [this](const PivotCandidate& a, const PivotCandidate& b) {
                  return m_(a.row) != m_(b.row) ? m_(a.row) < m_(b.row) : a.row < b.row;
                });
    append_candidates(driving);
  }

  void put_lexicographic_choice_first() {
    const Blocking choice = lexicographic_ratio_test(
        dictionary_, m_, first_, {options_.pivoting.pivot, options_.delta, options_.delta});
    const auto chosen = std::find_if(candidates_.begin(), candidates_.end(),
                                     [&](const PivotCandidate& c) { return c.row == choice.row; });
    if (chosen != candidates_.end()) std::rotate(candidates_.begin(), chosen, chosen + 1);
  }

  /// The candidates of the node that is open become its children; the best is queued.
  void append_candidates(Variable entering) {
    if (candidates_.empty()) return;
    const Index begin = static_cast<Index>(children_.size());
    for (const PivotCandidate& candidate : candidates_)
      children_.push_back({candidate.row, labels().basic(candidate.row), candidate.ratio,
                           m_(candidate.row), candidate.cost, ++work_.generated});
    if (options_.ties == Ties::lifo) std::reverse(children_.begin() + begin, children_.end());
    const auto cheaper = [](const Child& a, const Child& b) { return a.cost < b.cost; };
    if (!std::is_sorted(children_.begin() + begin, children_.end(), cheaper))
      std::stable_sort(children_.begin() + begin, children_.end(), cheaper);
    const Index count = static_cast<Index>(candidates_.size());
    siblings_.push_back({opened_, entering, begin, begin + count, count});
    waiting_ += count;
    work_.largest_queue = std::max(work_.largest_queue, waiting_);
    queue_next(static_cast<Index>(siblings_.size()) - 1);
  }

  void queue_next(Index family) {
    const Siblings& siblings = siblings_[family];
    if (siblings.next == siblings.end) return;
    queue_.push({cost_of(siblings.parent) + children_[siblings.next].cost,
                 depth_of(siblings.parent) + 1, family});
  }

  std::int64_t cost_of(Index x) const { return x == no_node ? 0 : nodes_[x].cost; }
  Index depth_of(Index x) const { return x == no_node ? 0 : nodes_[x].depth; }

  /// Takes the best pivot that waits and brings the dictionary there. False if its basis was opened
  /// before with the same driving variable, or if the branch ends here for want of accuracy. q_min is
  /// checked again: a nearly singular pivot can pass on its parent's numbers, leave no error in
  /// w - M z - q, and yet have a q' far below zero once its basis is factorised.
  bool open_next() {
    const Waiting best = queue_.top();
    queue_.pop();
    Siblings& siblings = siblings_[best.siblings];
    const Child child = children_[siblings.next++];
    const Index parent = siblings.parent, count = siblings.count;
    const Variable entering = siblings.entering;
    queue_next(best.siblings);
    --waiting_;

    if (parent == no_node) {
      key_ = first_key_;
    } else {
      visited_.copy_key(nodes_[parent].key, key_);
    }
    key_.follow(labels(), entering, child.leaving,
                child.leaving == labels().z0() ? -1 : labels().complement(child.leaving));
    if (!visited_.insert(key_)) return false;

    const Index x = static_cast<Index>(nodes_.size());
    nodes_.push_back({parent,
                      depth_of(parent) + 1,
                      {child.row, entering},
                      child.leaving,
                      best.cost,
                      child.number,
                      visited_.size() - 1});
    if (parent == opened_) {
      dictionary_.pivot(nodes_[x].pivot, m_);
    } else {
      dictionary_.rebuild(path_to(x));
    }
    opened_ = x;
    ++work_.nodes;
    ++work_.pivots;
    if (call_.observer)
      call_.observer({child.number, parent == no_node ? 0 : nodes_[parent].number, child.row,
                      entering, child.leaving, child.ratio, child.pivot_size, count,
                      &labels().basic()});
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
    work_.path = opened_ == no_node ? 0 : nodes_[opened_].depth;
    Result result = basic_result(scaled_, dictionary_, work_, claim, std::move(message));
    if (result.claim == Claim::solved && options_.polish) polish_on_factors(result);
    return result;
  }

  void polish_on_factors(Result& result) {
    if constexpr (std::is_same_v<Dictionary, Basis>) {
      polish(problem_, scaled_, dictionary_, result);
    } else {
      Basis afresh(scaled_, *result.basis, options_.pivoting);
      result.work.factorisations += afresh.factorisations();
      polish(problem_, scaled_, afresh, result);
    }
  }

  const Problem& problem_;
  const BestFirstOptions& options_;
  const Call& call_;
  ScaledProblem scaled_;
  std::vector<Index> alpha_;
  Dictionary dictionary_;
  std::vector<Variable> first_;  ///< Basic variables of the first dictionary.
  Pricing pricing_;
  std::vector<Node> nodes_;  ///< Every node opened, in order.
  std::vector<Child> children_;
  std::vector<Siblings> siblings_;
  std::priority_queue<Waiting, std::vector<Waiting>, Later> queue_;
  Index waiting_ = 0;  ///< Children not taken yet.
  Visited visited_;
  BasisKey first_key_{dictionary_.labels(), -1};
  BasisKey key_ = first_key_;
  Index opened_ = no_node;  ///< Node the dictionary stands at.
  VectorXd m_;              ///< m' there.
  VectorXd ratios_;
  std::vector<PivotCandidate> candidates_;
  Work work_;
};

/// Work of attempts one after the other.
Work together(const Work& before, const Work& last) {
  Work work = before;
  work += last;
  work.path = last.path;
  return work;
}

/// The three orders in which an attempt takes nodes of equal cost: as asked, and two others.
BestFirstOptions in_order(const BestFirstOptions& options, int order) {
  BestFirstOptions other = options;
  if (order == 1)
    other.order = options.order == Order::lexicographic ? Order::pivot : Order::lexicographic;
  if (order == 2) other.ties = options.ties == Ties::lifo ? Ties::deepest : Ties::lifo;
  return other;
}

/// Attempts of `patience` nodes: on each cost grid in the three orders; then one in which all nodes left
/// may be opened, as asked.
template <class Dictionary>
Result solve(const Problem& problem, const BestFirstOptions& options, const Call& call) {
  Work before;
  BestFirstOptions asked = options;
  asked.max_nodes = options.patience;
  for (; options.patience > 0 && asked.cost_grid < kWidest * options.epsilon;
       asked.cost_grid *= kWiden)
    for (const int order : {0, 1, 2}) {
      if (before.nodes + options.patience >= options.max_nodes) break;
      const BestFirstOptions attempt = in_order(asked, order);
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

const InSuites seldom_ends{.settings = {"max_nodes=300"}, .place = 3};  // More takes minutes.

const Registration best_first{
    {.name = "best-first",
     .summary = "best-first search over pivot candidates, on a factorised basis, scaled",
     .source = "Yamane and Nakamura 2008, III, with minus the depth as heuristic",
     .version = "2",
     .in_suites = {.place = 3}},
    BestFirstOptions{},
    factorised_options,
    solve<Basis>};

const Registration best_first_lexicographic{
    {.name = "best-first-lexicographic",
     .summary =
         "the same, opening the lexicographic rule's choice first among siblings of equal cost",
     .source = "best-first with the order of Yamane and Nakamura 2008, II-B; ours",
     .version = "2",
     .in_suites = {.place = 3}},
    BestFirstOptions{.order = Order::lexicographic},
    factorised_options,
    solve<Basis>};

const Registration best_first_tableau{
    {.name = "best-first-tableau",
     .summary = "the same search on an incrementally updated tableau with the paper's constants",
     .source = "Yamane and Nakamura 2008, III and V",
     .version = "2",
     .in_suites = seldom_ends},
    BestFirstOptions{.epsilon = 1e-3,
                     .e_max = 1e-3,
                     .order = Order::row,
                     .patience = 0,
                     .polish = false,
                     .pivoting = {.pivot = 0, .scale = false}},
    tableau_options,
    solve<Tableau>};

const Registration best_first_uniform{
    {.name = "best-first-uniform",
     .summary = "best-first with the cost exactly as printed (no depth term)",
     .source = "Yamane and Nakamura 2008, Algorithm 2, line 7",
     .in_suites = seldom_ends},
    BestFirstOptions{.cost = Cost::printed, .order = Order::row, .patience = 0},
    factorised_options,
    solve<Basis>};

}  // namespace
}  // namespace lcp
