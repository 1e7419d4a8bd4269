#include "problems/rigid/assembly_plan.h"

#include <algorithm>
#include <numeric>

namespace lcp {

namespace {

/// A joint between two bodies.
struct Edge {
  Index parent, child, joint;
};

bool contains(const std::vector<Index>& bodies, Index body) {
  return std::find(bodies.begin(), bodies.end(), body) != bodies.end();
}

Index copy_of_world(Index joint) { return -1 - joint; }

class Planner {
 public:
  Planner(const Model& model, const std::vector<Index>& handles)
      : handles_(handles), set_of_(model.size()) {
    std::iota(set_of_.begin(), set_of_.end(), Index{0});
    for (Index i = 0; i < model.size(); ++i)
      if (model.link(i).joint != JointKind::free) add({model.link(i).parent, i, i});
    for (Index i = 0; i < static_cast<Index>(model.loops().size()); ++i)
      add({model.loops()[i].link1, model.loops()[i].link2, model.size() + i});
    for (Index i = 0; i < model.size(); ++i) {
      if (contains(planned_, i)) continue;
      const std::vector<Index> bodies = reach(i, nullptr, {});
      plan(bodies);
      plan_.roots.push_back(last());
      planned_.insert(planned_.end(), bodies.begin(), bodies.end());
    }
  }

  AssemblyPlan take() { return std::move(plan_); }

 private:
  void add(Edge edge) {
    if (edge.parent == Link::world) {
      edge.parent = copy_of_world(edge.joint);
      tree_.push_back(edge);
      return;
    }
    const Index from = set_of_[edge.parent], to = set_of_[edge.child];
    if (from == to) {
      loops_.push_back(edge);
      return;
    }
    std::replace(set_of_.begin(), set_of_.end(), from, to);
    tree_.push_back(edge);
  }

  Index last() const { return static_cast<Index>(plan_.parts.size()) - 1; }

  /// Appends the parts that `bodies`, connected by joints, are assembled from; the whole comes last.
  void plan(const std::vector<Index>& bodies) {
    AssemblyPart part;
    if (bodies.size() == 1) {
      part.open = bodies;
      plan_.parts.push_back(std::move(part));
      return;
    }
    const Edge cut = halving_edge(bodies);
    const std::vector<Index> beyond = reach(cut.child, &cut, bodies);
    std::vector<Index> rest;
    for (const Index body : bodies)
      if (!contains(beyond, body)) rest.push_back(body);
    plan(rest);
    part.left = last();
    plan(beyond);
    part.right = last();
    part.redundant = holds_world(rest) && holds_world(beyond);
    part.merged = plan_.parts[part.left].open;
    const std::vector<Index>& others = plan_.parts[part.right].open;
    part.merged.insert(part.merged.end(), others.begin(), others.end());
    close(cut, bodies, std::move(part));

    for (const Edge& loop : loops_) {
      const auto inside = [&](const std::vector<Index>& some) {
        return contains(some, loop.parent) && contains(some, loop.child);
      };
      if (!inside(bodies) || inside(rest) || inside(beyond)) continue;
      AssemblyPart closed;
      closed.left = last();
      closed.redundant = true;
      closed.merged = plan_.parts[closed.left].open;
      close(loop, bodies, std::move(closed));
    }
  }

  /// Appends `part`, whose parts and merged bodies are set, with `edge` closed among `bodies`.
  void close(const Edge& edge, const std::vector<Index>& bodies, AssemblyPart part) {
    closed_.push_back(edge.joint);
    part.joint = edge.joint;
    for (Index place = 0; place < static_cast<Index>(part.merged.size()); ++place) {
      const Index body = part.merged[place];
      if (body == edge.parent) part.parent = place;
      if (body == edge.child) part.child = place;
      if (!stays_open(body, bodies)) continue;
      part.kept.push_back(place);
      part.open.push_back(body);
    }
    plan_.parts.push_back(std::move(part));
  }

  static bool holds_world(const std::vector<Index>& bodies) {
    return std::any_of(bodies.begin(), bodies.end(), is_world);
  }

  /// Bodies reachable from `start` by the tree's joints but `cut`, inside `within` (empty: anywhere).
  std::vector<Index> reach(Index start, const Edge* cut, const std::vector<Index>& within) const {
    std::vector<Index> found{start};
    for (std::size_t next = 0; next < found.size(); ++next) {
      for (const Edge& edge : tree_) {
        if (cut && edge.joint == cut->joint) continue;
        for (const auto& [from, to] :
             {std::pair(edge.parent, edge.child), {edge.child, edge.parent}})
          if (from == found[next] && !contains(found, to) &&
              (within.empty() || contains(within, to)))
            found.push_back(to);
      }
    }
    std::sort(found.begin(), found.end());
    return found;
  }

  Edge halving_edge(const std::vector<Index>& bodies) const {
    Edge best{};
    std::size_t least = bodies.size();
    for (const Edge& edge : tree_) {
      if (!contains(bodies, edge.parent) || !contains(bodies, edge.child)) continue;
      const std::size_t beyond = reach(edge.child, &edge, bodies).size();
      const std::size_t larger = std::max(beyond, bodies.size() - beyond);
      if (larger < least) {
        least = larger;
        best = edge;
      }
    }
    return best;
  }

  /// Whether anything outside `bodies`, or a loop not closed yet, will push `body`.
  bool stays_open(Index body, const std::vector<Index>& bodies) const {
    if (contains(handles_, body)) return true;
    const auto pushes = [&](const Edge& edge) { return edge.parent == body || edge.child == body; };
    return std::any_of(tree_.begin(), tree_.end(),
                       [&](const Edge& edge) {
                         return pushes(edge) &&
                                !(contains(bodies, edge.parent) && contains(bodies, edge.child));
                       }) ||
           std::any_of(loops_.begin(), loops_.end(), [&](const Edge& edge) {
             return pushes(edge) && !contains(closed_, edge.joint);
           });
  }

  const std::vector<Index>& handles_;
  std::vector<Index> set_of_;  ///< Links with the same number are connected.
  std::vector<Edge> tree_, loops_;
  std::vector<Index> closed_, planned_;
  AssemblyPlan plan_;
};

}  // namespace

AssemblyPlan plan_assembly(const Model& model, const std::vector<Index>& handles) {
  return Planner(model, handles).take();
}

}  // namespace lcp
