#include "problems/io/text/json.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "problems/io/errors.h"
#include "problems/io/limits.h"
#include "problems/io/replace_file.h"
#include "problems/io/text/read_text.h"

namespace lcp {

namespace {

using Json = nlohmann::ordered_json;

/// An entry of W: { instances [ { friction { W [ [.
constexpr int deepest = 6;

/// A value with its place in the file, for messages.
class Place {
 public:
  Place(const std::string& file, const Json& value, std::string path = "")
      : file_(&file), value_(&value), path_(std::move(path)) {}

  template <class... Arguments>
  [[noreturn]] void fail(fmt::format_string<Arguments...> what, Arguments&&... arguments) const {
    throw UnreadableInput("{}: {}: {}", *file_, path_.empty() ? "/" : path_,
                          fmt::format(what, std::forward<Arguments>(arguments)...));
  }
  const Json& value() const { return *value_; }
  bool has(const char* key) const { return value_->contains(key); }
  Place operator[](const std::string& key) const {
    if (!value_->contains(key)) Place(*file_, *value_, path_ + "/" + key).fail("is missing");
    return {*file_, (*value_)[key], path_ + "/" + key};
  }
  Place operator[](std::size_t i) const {
    return {*file_, (*value_)[i], fmt::format("{}/{}", path_, i)};
  }

  void require_object(const std::set<std::string>& known) const {
    if (!value_->is_object()) fail("is {}, expected an object", value_->type_name());
    for (const auto& [key, ignored] : value_->items())
      if (!known.contains(key))
        fail("has the unknown key '{}', expected {}", key.substr(0, longest_shown),
             fmt::join(known, ", "));
  }
  /// An array of at most largest_rows entries.
  Index array() const { return array_of_at_most(largest_rows); }
  Index array_of_at_most(Index most) const {
    if (!value_->is_array()) fail("is {}, expected an array", value_->type_name());
    if (value_->size() > static_cast<std::size_t>(most))
      fail("has {} entries, expected at most {}", value_->size(), most);
    return static_cast<Index>(value_->size());
  }

  double number() const {
    if (!value_->is_number()) fail("is {}, expected a number", value_->type_name());
    return value_->get<double>();
  }
  Index integer() const {
    if (!value_->is_number_integer() ||
        (value_->is_number_unsigned() &&
         value_->get<std::uint64_t>() > std::uint64_t{std::numeric_limits<Index>::max()}))
      fail("is {}, expected a whole number", value_->type_name());
    return value_->get<Index>();
  }
  std::string text() const {
    if (!value_->is_string()) fail("is {}, expected a text", value_->type_name());
    return value_->get<std::string>();
  }

  VectorXd vector() const {
    VectorXd numbers(array());
    for (Index i = 0; i < numbers.size(); ++i)
      numbers(i) = (*this)[static_cast<std::size_t>(i)].number();
    return numbers;
  }
  std::vector<Index> integers() const {
    std::vector<Index> numbers(static_cast<std::size_t>(array()));
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = (*this)[i].integer();
    return numbers;
  }
  /// A matrix by rows of `columns` numbers.
  MatrixXd matrix(Index columns) const {
    const Index rows = array();
    for (Index i = 0; i < rows; ++i) {
      const Place row = (*this)[static_cast<std::size_t>(i)];
      const Index found = row.array();
      if (found != columns) row.fail("has {} entries, expected {}", found, columns);
    }
    MatrixXd numbers(rows, columns);
    for (Index i = 0; i < rows; ++i)
      numbers.row(i) = (*this)[static_cast<std::size_t>(i)].vector().transpose();
    return numbers;
  }

 private:
  const std::string* file_;
  const Json* value_;
  std::string path_;
};

// --- reading ---

/// Stops the parser before a hostile file fills stack or memory: an empty array takes three bytes of
/// the file and seventy of memory.
class Guard {
 public:
  Guard(const std::string& path, std::size_t bytes)
      : path_(path), most_objects_(1 + bytes / smallest_instance) {}

  bool operator()(int depth, Json::parse_event_t event, Json&) {
    const bool array = event == Json::parse_event_t::array_start;
    if (!array && event != Json::parse_event_t::object_start) return true;
    if (depth >= deepest) refuse("is nested deeper than {}, expected instances", deepest);
    const auto level = static_cast<std::size_t>(depth);
    if (array && ++arrays_[level] > largest_rows)
      refuse("has more than {} rows in a matrix", largest_rows);
    if (!array && ++objects_ > most_objects_) refuse("has more objects than instances could have");
    arrays_[level + 1] = 0;
    return true;
  }

 private:
  static constexpr std::size_t smallest_instance = 16;  ///< {"M":[],"q":[]}, in bytes

  template <class... Arguments>
  [[noreturn]] void refuse(fmt::format_string<Arguments...> what, Arguments&&... arguments) const {
    throw UnreadableInput(path_ + ": " + fmt::format(what, std::forward<Arguments>(arguments)...));
  }

  const std::string& path_;
  std::size_t objects_ = 0, most_objects_;
  std::array<Index, deepest + 1> arrays_{};  ///< So far at each depth, below the same parent.
};

Json parse(const std::string& path, const std::string& text) {
  try {
    return Json::parse(text, Guard(path, text.size()));
  } catch (const Json::exception& error) {
    throw UnreadableInput("{}: {}", path, error.what());
  }
}

FrictionBlocks read_friction(const Place& place) {
  place.require_object({"W", "vbar", "mu", "directions", "directions_per_contact", "normal_row",
                        "friction_row", "cone_row"});
  FrictionBlocks blocks;
  blocks.vbar = place["vbar"].vector();
  blocks.W = place["W"].matrix(blocks.vbar.size());
  blocks.mu = place["mu"].vector();
  blocks.directions_per_contact = place["directions_per_contact"].integer();
  if (blocks.directions_per_contact < 0 || blocks.directions_per_contact > largest_rows)
    place["directions_per_contact"].fail("is {}, expected 0 ... {}", blocks.directions_per_contact,
                                         largest_rows);
  const Place directions = place["directions"];
  if (const Index rows = directions.array(); rows != 2)
    directions.fail("has {} entries, expected 2", rows);
  // With no contact, or none of them rough, LCP and directions may both be empty.
  const Index columns = blocks.mu.size() * blocks.directions_per_contact;
  blocks.directions = directions.matrix(columns);
  blocks.normal_row = place["normal_row"].integers();
  blocks.friction_row = place["friction_row"].integers();
  blocks.cone_row = place["cone_row"].integers();
  return blocks;
}

Problem read_problem(const Place& place) {
  Problem problem;
  problem.q = place["q"].vector();
  const Index n = problem.q.size();
  const Place M = place["M"];
  if (const Index rows = M.array(); rows != n) M.fail("has {} entries, expected {} as q", rows, n);
  problem.M = M.matrix(n);
  set_plain_scales(problem);
  if (place.has("s_z")) problem.s_z = place["s_z"].vector();
  if (place.has("s_w")) problem.s_w = place["s_w"].vector();
  if (place.has("c")) problem.c = place["c"].vector();
  if (place.has("pivot_limit")) problem.pivot_limit = place["pivot_limit"].integer();
  if (place.has("friction")) problem.friction = read_friction(place["friction"]);
  return problem;
}

std::map<std::string, std::string> read_provenance(const Place& place) {
  std::map<std::string, std::string> texts;
  if (!place.has("provenance")) return texts;
  const Place provenance = place["provenance"];
  if (!provenance.value().is_object())
    provenance.fail("is {}, expected an object", provenance.value().type_name());
  for (const auto& [key, ignored] : provenance.value().items()) texts[key] = provenance[key].text();
  return texts;
}

/// `found` is the hash of what was read, `key` where one may stand.
void require_hash(const Place& place, const char* key, const std::string& found) {
  if (!place.has(key)) return;
  const std::string stored = place[key].text();
  if (stored != found)
    place[key].fail("is {}, but the content has {}", stored.substr(0, found.size()), found);
}

Instance read_instance(const Place& place, const std::string& unnamed) {
  place.require_object({"name", "M", "q", "s_z", "s_w", "c", "pivot_limit", "known_solution",
                        "active_contacts", "provenance", "friction", "sha256", "previous_alpha",
                        "previous_z", "previous_sha256"});
  const std::string name = place.has("name") ? place["name"].text() : unnamed;
  Instance instance;
  try {
    instance = make_instance(name, read_problem(place), read_provenance(place));
  } catch (const std::invalid_argument& error) {
    place.fail("{}", error.what());
  }
  require_hash(place, "sha256", instance.sha256);
  const Problem& problem = instance.problem;
  if (place.has("known_solution")) {
    instance.known_solution = place["known_solution"].vector();
    if (instance.known_solution->size() != problem.size())
      place["known_solution"].fail("has {} entries, expected {}", instance.known_solution->size(),
                                   problem.size());
  }
  if (place.has("active_contacts")) {
    const Index active = place["active_contacts"].integer();
    const Index contacts = problem.friction ? problem.friction->contacts() : 0;
    if (active < 0 || active > contacts)
      place["active_contacts"].fail("is {}, expected 0 ... {}", active, contacts);
    instance.active_contacts = active;
  }
  if (place.has("previous_alpha")) {
    Start& previous = instance.previous.emplace();
    previous.alpha = place["previous_alpha"].integers();
    if (place.has("previous_z")) previous.z = place["previous_z"].vector();
    try {
      check(previous, problem.size(), "previous solution");
    } catch (const std::invalid_argument& error) {
      place.fail("{}", error.what());
    }
    require_hash(place, "previous_sha256", hash_with_previous(instance));
  }
  return instance;
}

// --- writing ---

Json to_json(const MatrixXd& matrix) {
  Json rows = Json::array();
  for (Index i = 0; i < matrix.rows(); ++i) {
    const Eigen::RowVectorXd row = matrix.row(i);
    rows.push_back(std::vector<double>(row.begin(), row.end()));
  }
  return rows;
}

Json to_json(const VectorXd& vector) { return std::vector<double>(vector.begin(), vector.end()); }

Json to_json(Index number) { return number; }

Json to_json(const std::vector<Index>& numbers) { return numbers; }

Json to_json(const FrictionBlocks& blocks) {
  Json json;
  each_field(blocks, [&](const char* name, const auto& field) { json[name] = to_json(field); });
  return json;
}

Json to_json(const Instance& instance) {
  const Problem& problem = instance.problem;
  Json json = {{"name", instance.name},        {"sha256", instance.sha256},
               {"provenance", Json::object()}, {"M", to_json(problem.M)},
               {"q", to_json(problem.q)},      {"s_z", to_json(problem.s_z)},
               {"s_w", to_json(problem.s_w)},  {"pivot_limit", problem.pivot_limit}};
  for (const auto& [key, text] : instance.provenance) json["provenance"][key] = text;
  if (problem.c.size() > 0) json["c"] = to_json(problem.c);
  if (instance.known_solution) json["known_solution"] = to_json(*instance.known_solution);
  if (instance.active_contacts) json["active_contacts"] = *instance.active_contacts;
  if (instance.previous) {
    json["previous_alpha"] = instance.previous->alpha;
    if (instance.previous->z.size() > 0) json["previous_z"] = to_json(instance.previous->z);
    json["previous_sha256"] = hash_with_previous(instance);
  }
  if (problem.friction) json["friction"] = to_json(*problem.friction);
  return json;
}

}  // namespace

std::vector<Instance> read_json(const std::string& path, const std::string& unnamed) {
  const Json json = parse(path, read_text(path, "a JSON file", largest_json));
  const Place root(path, json);
  if (!json.is_object() || !json.contains("instances")) return {read_instance(root, unnamed)};
  root.require_object({"instances"});
  const Place all = root["instances"];
  const Index count = all.array_of_at_most(std::numeric_limits<Index>::max());
  if (count == 0) all.fail("holds no instance, expected at least 1");
  std::vector<Instance> instances;
  std::set<std::string> names;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    const std::string otherwise = count == 1 ? unnamed : fmt::format("{}/{}", unnamed, i);
    instances.push_back(read_instance(all[i], otherwise));
    if (!names.insert(instances.back().name).second)
      all[i].fail("is called '{}' like another, expected different names", instances.back().name);
  }
  return instances;
}

void write_json(const std::string& path, const std::vector<Instance>& instances) {
  std::string text = "{\"instances\": [\n";
  for (const Instance& instance : instances) {
    try {
      text += to_json(instance).dump();
    } catch (const Json::exception& error) {
      throw UnwritableOutput(one_line(fmt::format("{}: {}", path, error.what())));
    }
    text += &instance == &instances.back() ? "\n" : ",\n";
    if (text.size() > largest_json)
      throw UnwritableOutput("{}: JSON cannot hold more than {} bytes; write .hdf5", path,
                             largest_json);
  }
  replace_file(path, text + "]}\n");
}

}  // namespace lcp
