#include "harness/record.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "harness/observed_quantile.h"

namespace lcp {

namespace {

using nlohmann::json;

/// Work as JSON: each count under the name of its field.
struct Count {
  const char* name;
  Index Work::*field;
  bool in_older_rows = true;  ///< Rows written before there was such a count say nothing of it: 0.
};
constexpr Count work_counts[] = {{"pivots", &Work::pivots},
                                 {"path", &Work::path},
                                 {"nodes", &Work::nodes},
                                 {"generated", &Work::generated},
                                 {"largest_queue", &Work::largest_queue},
                                 {"replayed", &Work::replayed},
                                 {"factorisations", &Work::factorisations},
                                 {"sweeps", &Work::sweeps},
                                 {"start_pivots", &Work::start_pivots},
                                 {"restarts", &Work::restarts},
                                 {"frictionless_pivots", &Work::frictionless_pivots, false}};

struct Figure {
  const char* name;
  double Accuracy::*field;
};
constexpr Figure accuracy_figures[] = {{"residual", &Accuracy::residual},
                                       {"residual_unscaled", &Accuracy::residual_unscaled},
                                       {"zero_residual", &Accuracy::zero_residual},
                                       {"paper_error", &Accuracy::paper_error},
                                       {"min_z", &Accuracy::min_z},
                                       {"min_w", &Accuracy::min_w},
                                       {"max_zw", &Accuracy::max_zw},
                                       {"backward_error", &Accuracy::backward_error}};

json number_to_json(double number) {
  if (std::isfinite(number)) return number;
  return std::isnan(number) ? "nan" : number > 0 ? "inf" : "-inf";
}

double number_from_json(const json& value) {
  if (value == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (value == "inf") return std::numeric_limits<double>::infinity();
  if (value == "-inf") return -std::numeric_limits<double>::infinity();
  return value.get<double>();
}

/// Reads one field by `convert`; its absence or a wrong type is told under the field's name.
template <class Convert>
auto read_field(const json& object, const char* name, Convert convert) {
  try {
    return convert(object.at(name));
  } catch (const json::exception& error) {
    throw std::invalid_argument(fmt::format("field '{}': {}", name, error.what()));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("field '{}': {}", name, error.what()));
  }
}

template <class T>
void get(const json& object, const char* name, T& value) {
  value = read_field(object, name, [](const json& field) { return field.get<T>(); });
}

Accuracy accuracy_from_json(const json& object) {
  Accuracy accuracy;
  for (const Figure& figure : accuracy_figures)
    accuracy.*figure.field = read_field(object, figure.name, number_from_json);
  return accuracy;
}

json accuracy_to_json(const Accuracy& accuracy) {
  json object;
  for (const Figure& figure : accuracy_figures)
    object[figure.name] = number_to_json(accuracy.*figure.field);
  return object;
}

}  // namespace

PairKey key_of(const Record& record) {
  return {record.instance, record.sha256, record.solver, record.start};
}

bool decided_by_runner(Verdict verdict) {
  return verdict == Verdict::timeout || verdict == Verdict::memory || verdict == Verdict::crash ||
         verdict == Verdict::not_run;
}

std::optional<std::int64_t> Record::median_ns() const { return observed_quantile(times_ns, 0.5); }

void to_json(json& object, const Work& work) {
  object = json::object();
  for (const Count& count : work_counts) object[count.name] = work.*count.field;
}

void from_json(const json& object, Work& work) {
  work = Work{};
  for (const Count& count : work_counts)
    if (count.in_older_rows || object.contains(count.name))
      get(object, count.name, work.*count.field);
}

void to_json(json& object, const Record& record) {
  object = {{"schema", Record::schema},
            {"instance", record.instance},
            {"place", record.place},
            {"corpus", record.corpus},
            {"sha256", record.sha256},
            {"n", record.n},
            {"contacts", record.contacts},
            {"solver", record.solver},
            {"row", record.row},
            {"version", record.version},
            {"options", record.options},
            {"start", record.start},
            {"message", record.message},
            {"verdict", to_string(record.verdict)},
            {"unclaimed", record.unclaimed},
            {"trivial", record.trivial},
            {"tolerance", number_to_json(record.tolerance)},
            {"work", record.work},
            {"times_ns", record.times_ns},
            {"exit", {{"signal", record.exit_signal}, {"stderr", record.stderr_end}}},
            {"jobs", record.jobs},
            {"environment", record.environment}};
  if (record.active_contacts) object["active_contacts"] = *record.active_contacts;
  if (!decided_by_runner(record.verdict)) object["claim"] = to_string(record.claim);
  if (record.accuracy) object["accuracy"] = accuracy_to_json(*record.accuracy);
  if (record.z) object["z"] = *record.z;
  if (record.median_ns()) object["median_ns"] = *record.median_ns();
}

void from_json(const json& object, Record& record) {
  int schema = 0;
  get(object, "schema", schema);
  if (schema != Record::schema)
    throw std::invalid_argument(
        fmt::format("field 'schema': {}, expected {}", schema, Record::schema));
  record = Record{};
  get(object, "instance", record.instance);
  if (object.contains("place")) get(object, "place", record.place);  // rows of older runs: 0
  get(object, "corpus", record.corpus);
  get(object, "sha256", record.sha256);
  get(object, "n", record.n);
  get(object, "contacts", record.contacts);
  get(object, "solver", record.solver);
  get(object, "row", record.row);
  get(object, "version", record.version);
  get(object, "options", record.options);
  get(object, "start", record.start);
  get(object, "message", record.message);
  get(object, "unclaimed", record.unclaimed);
  get(object, "trivial", record.trivial);
  get(object, "work", record.work);
  get(object, "times_ns", record.times_ns);
  get(object, "jobs", record.jobs);
  get(object, "environment", record.environment);
  record.verdict = read_field(object, "verdict", from_string<Verdict>);
  record.tolerance = read_field(object, "tolerance", number_from_json);
  if (!decided_by_runner(record.verdict))
    record.claim = read_field(object, "claim", from_string<Claim>);
  if (object.contains("active_contacts")) {
    record.active_contacts.emplace();
    get(object, "active_contacts", *record.active_contacts);
  }
  if (object.contains("accuracy"))
    record.accuracy = read_field(object, "accuracy", accuracy_from_json);
  if (object.contains("z")) {
    std::vector<double> numbers;
    get(object, "z", numbers);
    record.z = Eigen::Map<const VectorXd>(numbers.data(), static_cast<Index>(numbers.size()));
  }
  read_field(object, "exit", [&record](const json& ending) {
    get(ending, "signal", record.exit_signal);
    get(ending, "stderr", record.stderr_end);
  });
}

}  // namespace lcp
