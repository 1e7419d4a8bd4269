#include "harness/measure/wire.h"

#include <nlohmann/json.hpp>

#include "harness/record.h"

namespace lcp {

namespace {

using nlohmann::json;

std::vector<double> numbers(const VectorXd& x) { return {x.begin(), x.end()}; }

VectorXd vector(const json& array) {
  const auto values = array.get<std::vector<double>>();
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size()));
}

}  // namespace

std::string encode(const Result& result) {
  json object = {{"claim", to_string(result.claim)},
                 {"message", result.message},
                 {"z", numbers(result.z)},
                 {"w", numbers(result.w)},
                 {"z0", result.z0},
                 {"covering", numbers(result.covering)},
                 {"certificate", numbers(result.certificate)},
                 {"work", result.work}};
  if (result.basis) object["basis"] = *result.basis;
  std::string bytes;
  json::to_cbor(object, bytes);
  return bytes;
}

Result decode(const std::string& bytes) {
  const json object = json::from_cbor(bytes);
  Result result;
  result.claim = from_string<Claim>(object.at("claim"));
  object.at("message").get_to(result.message);
  result.z = vector(object.at("z"));
  result.w = vector(object.at("w"));
  object.at("z0").get_to(result.z0);
  result.covering = vector(object.at("covering"));
  result.certificate = vector(object.at("certificate"));
  object.at("work").get_to(result.work);
  if (object.contains("basis")) result.basis = object.at("basis").get<std::vector<Index>>();
  return result;
}

}  // namespace lcp
