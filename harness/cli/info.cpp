#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "harness/cli/page.h"
#include "harness/cli/reading.h"
#include "problems/features.h"
#include "solvers/registry.h"

namespace lcp::cli {

namespace {

using Json = nlohmann::ordered_json;

struct InfoArguments {
  std::string where;
  ReadOptions reading;
  bool json = false;
};

/// Least and greatest number.
Json range(const VectorXd& numbers) {
  if (numbers.size() == 0) return nullptr;
  return {{"least", numbers.minCoeff()}, {"greatest", numbers.maxCoeff()}};
}

template <class Number>
Json or_null(const std::optional<Number>& number) {
  return number ? Json(*number) : Json();
}

/// How many rows each of the first pivots could have taken: rows within the tie threshold of the
/// minimum ratio, on the path of the lexicographic rule with its default options. Step 0, where z0
/// enters, is left out: its ties are those in q.
Json ties_of_first_pivots(const Instance& instance) {
  constexpr const char* rule = "lexicographic-revised:max_pivots=10";
  Json ties = Json::array();
  Call call;
  const Index z0 = 2 * instance.problem.size();
  call.observer = [&](const PivotEvent& pivot) {
    if (pivot.entering != z0) ties.push_back(pivot.tied);
  };
  make_solver(rule).solver->solve(instance.problem, call);
  return ties;
}

/// The features of an instance, named as they are printed.
Json describe(const Instance& instance) {
  const Features of = features(instance.problem);
  Json json = {{"name", instance.name},
               {"sha256", instance.sha256},
               {"n", of.n},
               {"contacts", of.contacts},
               {"active contacts", or_null(instance.active_contacts)},
               {"asymmetry", of.asymmetry},
               {"density", of.density},
               {"rank", or_null(of.rank)},
               {"condition", or_null(of.condition)},
               {"rank and condition of", of.contacts > 0 ? "W" : "M"},
               {"tied in q", of.tied_q},
               {"tied at first pivots", ties_of_first_pivots(instance)},
               {"scales of z", range(instance.problem.s_z)},
               {"scales of w", range(instance.problem.s_w)},
               {"covering vector", instance.problem.c.size() > 0 ? "its own" : "1"},
               {"pivot limit", instance.problem.max_pivots()},
               {"solution known", instance.known_solution.has_value()},
               {"previous solution", instance.previous.has_value()}};
  json["provenance"] = instance.provenance;
  return json;
}

std::string printed(const Json& value) {
  if (value.is_null()) return "unknown";
  if (value.is_string()) return value.get<std::string>();
  if (value.is_object())
    return fmt::format("{} ... {}", value["least"].dump(), value["greatest"].dump());
  if (value.is_array())
    return value.empty() ? "no pivot"
                         : fmt::format("{}", fmt::join(value.get<std::vector<Index>>(), " "));
  return value.dump();
}

int info(const InfoArguments& arguments) {
  Json all = Json::array();
  for (const Instance& instance : read_instances(arguments.where, arguments.reading))
    all.push_back(describe(instance));
  if (arguments.json) {
    fmt::print("{}\n", Json{{"instances", all}}.dump(1));
    return done;
  }
  for (const Json& json : all) {
    for (const auto& [key, value] : json.items())
      if (key != "provenance") fmt::print("{:<22} {}\n", key, printed(value));
    for (const auto& [key, value] : json["provenance"].items())
      fmt::print("  {:<20} {}\n", key, printed(value));
    fmt::print("\n");
  }
  return done;
}

void info_options(CLI::App& page, InfoArguments& arguments) {
  add(page, "INSTANCE", arguments.where, "FILE, FILE#NAME or directory")->required();
  page.add_flag("--json", arguments.json, "As JSON");
  add_reading_option(page, arguments.reading);
}

}  // namespace

Verb add_info(CLI::App& program) {
  return make_verb<InfoArguments>(
      program, "info",
      "Describe instances: size, contacts, rank, condition, ties, scales, provenance", info_options,
      info, "Example:\n  lcpbench info squat.hdf5#squat-like/0003");
}

}  // namespace lcp::cli
