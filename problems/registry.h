#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "problems/instance.h"
#include "solvers/options.h"

namespace lcp {

/// How many instances of a family and from which seed.
struct Draw {
  Index count = 1;
  std::uint64_t seed = 1;
  /// What instances' names begin with: the family in full spelling. generate() fills it.
  std::string corpus = {};
};

/// A generated family of instances with its knobs set.
class Family {
 public:
  virtual ~Family() = default;
  /// Deterministic: same knobs and draw, same bits. Throws std::invalid_argument when the knobs
  /// contradict one another.
  virtual std::vector<Instance> generate(const Draw& draw) const = 0;
  /// Live access to the knobs.
  virtual OptionTable options() = 0;
};

struct FamilyInfo {
  std::string name;
  std::string summary;
  std::string source;
  Index default_count = 1;  ///< Instances drawn when no --count is given.
};

struct FamilyRow {
  FamilyInfo info;
  std::function<std::unique_ptr<Family>()> make;
};

/// All families, sorted by name.
const std::vector<FamilyRow>& families();

/// `name:key=value,...` with the knobs that differ from their defaults alone, in their order: what
/// the names of the family's instances begin with. Throws std::invalid_argument with the list of what
/// is allowed.
std::string full_family_spelling(const std::string& text);

/// Draws instances of `name:key=value,...`; `draw.count` 0 means the family's default. Names are
/// `name:key=value,.../0000`..., with the knobs that differ from their defaults; provenance holds
/// family (full spelling) and seed. Throws
/// std::invalid_argument with the list of what is allowed.
std::vector<Instance> generate(const std::string& text, Draw draw);

/// Registers a family for as long as the program runs; construct it at the foot of its file.
/// `table(Knobs&)` lists the knobs, `draw(Knobs, Draw)` makes the instances.
struct FamilyRegistration {
  template <class Knobs, class Table, class Make>
  FamilyRegistration(FamilyInfo info, Knobs defaults, Table table, Make make) {
    class Generated final : public Family {
     public:
      Generated(Knobs knobs, Table list, Make draw)
          : knobs_(std::move(knobs)), list_(list), draw_(draw) {}
      std::vector<Instance> generate(const Draw& draw) const override {
        return draw_(knobs_, draw);
      }
      OptionTable options() override { return list_(knobs_); }

     private:
      Knobs knobs_;
      Table list_;
      Make draw_;
    };
    add({std::move(info), [=] { return std::make_unique<Generated>(defaults, table, make); }});
  }

 private:
  static void add(FamilyRow row);
};

}  // namespace lcp
