#include "harness/studies/perturb/perturb_render.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "harness/present/escaping.h"

namespace lcp {

namespace {

using OrderedJson = nlohmann::ordered_json;

/// A whole number of FlipRow under its name in CSV and JSON.
struct FlipCount {
  const char* key;
  Index FlipRow::*field;
};
constexpr FlipCount flip_counts[] = {{"instances", &FlipRow::instances},
                                     {"trials", &FlipRow::trials},
                                     {"solved", &FlipRow::solved},
                                     {"baseline_solved", &FlipRow::baseline_solved},
                                     {"lost", &FlipRow::lost},
                                     {"gained", &FlipRow::gained},
                                     {"other_changes", &FlipRow::other_changes},
                                     {"instances_flipped", &FlipRow::instances_flipped},
                                     {"compared", &FlipRow::compared},
                                     {"several", &FlipRow::several},
                                     {"most_distinct", &FlipRow::most_distinct},
                                     {"other_z", &FlipRow::other_z},
                                     {"other_z_same_w", &FlipRow::other_z_same_w},
                                     {"other_z_same_motion", &FlipRow::other_z_same_motion},
                                     {"trivial", &FlipRow::trivial},
                                     {"unsupported", &FlipRow::unsupported},
                                     {"not_run", &FlipRow::not_run}};

struct FlipNumber {
  const char* key;
  std::optional<double> (*value)(const FlipRow&);
};

template <class Value>
std::optional<double> when(bool known, Value value) {
  return known ? std::optional<double>(value) : std::nullopt;
}

bool has_rate(const FlipRow& row) { return row.kind != "baseline" && row.trials > 0; }

constexpr FlipNumber flip_numbers[] = {
    {"flip_rate",
     [](const FlipRow& row) {
       return when(has_rate(row), static_cast<double>(row.flips()) /
                                      static_cast<double>(std::max<Index>(row.trials, 1)));
     }},
    {"flip_rate_low", [](const FlipRow& row) { return when(has_rate(row), row.rate().low); }},
    {"flip_rate_high", [](const FlipRow& row) { return when(has_rate(row), row.rate().high); }},
    {"pivots", [](const FlipRow& row) { return row.pivots; }},
    {"pivot_ratio", [](const FlipRow& row) { return row.pivot_ratio; }},
    {"pivot_ratio_max", [](const FlipRow& row) { return row.pivot_ratio_max; }},
};

std::string json(const Flips& flips) {
  OrderedJson whole = {{"options", nlohmann::json(flips.options)},
                       {"same", flips.same},
                       {"tolerance", flips.tolerance},
                       {"rows", OrderedJson::array()},
                       {"not_applicable", OrderedJson::array()}};
  for (const FlipRow& row : flips.rows) {
    OrderedJson one = {{"corpus", row.corpus}, {"solver", row.solver}, {"label", row.label},
                       {"start", row.start},   {"kind", row.kind},     {"flips", row.flips()}};
    for (const FlipCount& count : flip_counts) one[count.key] = row.*count.field;
    for (const FlipNumber& number : flip_numbers) {
      const std::optional<double> value = number.value(row);
      one[number.key] = value ? OrderedJson(*value) : OrderedJson();
    }
    whole["rows"].push_back(one);
  }
  for (const NotApplicable& each : flips.not_applicable)
    whole["not_applicable"].push_back({{"corpus", each.corpus},
                                       {"kind", each.kind},
                                       {"reason", each.reason},
                                       {"instances", each.instances}});
  return whole.dump(1) + "\n";
}

std::string csv(const Flips& flips) {
  std::string out = "corpus,solver,start,kind,flips";
  for (const FlipCount& count : flip_counts) out += fmt::format(",{}", count.key);
  for (const FlipNumber& number : flip_numbers) out += fmt::format(",{}", number.key);
  out += "\n";
  for (const FlipRow& row : flips.rows) {
    out += fmt::format("{},{},{},{},{}", csv_quoted(row.corpus), csv_quoted(row.solver),
                       csv_quoted(row.start), row.kind, row.flips());
    for (const FlipCount& count : flip_counts) out += fmt::format(",{}", row.*count.field);
    for (const FlipNumber& number : flip_numbers) {
      const std::optional<double> value = number.value(row);
      out += value ? fmt::format(",{}", *value) : ",";
    }
    out += "\n";
  }
  return out;
}

std::string rate_cell(const FlipRow& row) {
  if (!has_rate(row)) return "";
  const Interval rate = row.rate();
  return fmt::format("{:.1f}-{:.1f}%", 100 * rate.low, 100 * rate.high);
}

std::string ratio_cell(const FlipRow& row) {
  if (!row.pivot_ratio || row.kind == "baseline") return "";
  return fmt::format("{:.2f} {:.2f}", *row.pivot_ratio, *row.pivot_ratio_max);
}

std::string text_line(const FlipRow& row) {
  const bool disturbed = row.kind != "baseline";
  const auto of_disturbed = [&](Index count) {
    return disturbed ? fmt::format("{}", count) : std::string();
  };
  std::string line = fmt::format("  {:<11}", row.kind);
  if (row.trials == 0) {
    const Index refused = row.unsupported;
    line += refused > 0       ? fmt::format(" unsupported by the solver ({} runs)", refused)
            : row.not_run > 0 ? fmt::format(" {} instances not run: too large", row.not_run)
            : row.trivial > 0 ? fmt::format(" trivial: z = 0 solves all {}", row.trivial)
                              : std::string(" does not apply");
    return line + "\n";
  }
  line += fmt::format(" {:>6} {:>6} {:>6} {:>12}", row.trials, row.solved,
                      of_disturbed(row.flips()), rate_cell(row));
  line += fmt::format(" {:>5} {:>6} {:>5} {:>7}", of_disturbed(row.lost), of_disturbed(row.gained),
                      of_disturbed(row.other_changes),
                      disturbed ? fmt::format("{}/{}", row.instances_flipped, row.instances) : "");
  const auto of_other_z = [&](Index count) {
    return disturbed && row.other_z > 0 ? fmt::format("{}/{}", count, row.other_z) : std::string();
  };
  line += fmt::format(" {:>7} {:>4} {:>8} {:>8}",
                      disturbed ? fmt::format("{}/{}", row.several, row.compared) : "",
                      of_disturbed(row.most_distinct), of_other_z(row.other_z_same_w),
                      of_other_z(row.other_z_same_motion));
  line += fmt::format(" {:>7} {:>11}", row.pivots ? fmt::format("{:.0f}", *row.pivots) : "",
                      ratio_cell(row));
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

constexpr const char* text_head =
    "               trials solved  flips 95% interval  lost gained other flipped     z's most   "
    "same w   same v  pivots      spread\n";

constexpr const char* text_foot =
    "  trials   disturbed runs (baseline: instances); trivial instances and unsupported runs are "
    "left out\n"
    "  solved   of the trials\n"
    "  flips    trials whose verdict is solved where the undisturbed one is not (gained), or the "
    "reverse (lost)\n"
    "  95%      Wilson interval of flips / trials, as if trials of one instance were independent\n"
    "  other    solved in neither, and another verdict\n"
    "  flipped  instances with a flip, of those tried\n"
    "  z's      instances with more than one solution, of those solved twice or more\n"
    "  most     solutions told apart on one instance\n"
    "  same w   of the solved runs whose z is not the undisturbed one's (the first solved run's), "
    "those whose w is\n"
    "  same v   and those that move the contacts alike: v+ = W f + vbar (w without contacts)\n"
    "  pivots   median over the solved runs\n"
    "  spread   most over least pivots on one instance: median, largest\n";

std::string text(const Flips& flips) {
  if (flips.rows.empty()) return "no rows\n";
  std::string out, corpus, entrant;
  for (const FlipRow& row : flips.rows) {
    if (row.corpus != corpus) {
      if (!corpus.empty()) out += "\n";
      corpus = row.corpus;
      entrant.clear();
      out += fmt::format("{}\n{}", corpus, text_head);
    }
    if (row.label != entrant) out += (entrant = row.label) + "\n";
    out += text_line(row);
  }
  out += "\n";
  out += text_foot;
  for (const NotApplicable& each : flips.not_applicable)
    out += fmt::format("{}: {} unsupported for {} instance{}: {}\n", each.corpus, each.kind,
                       each.instances, each.instances == 1 ? "" : "s", each.reason);
  const PerturbOptions& options = flips.options;
  out += fmt::format(
      "Solved means a natural residual of at most {}. Two z (w) are the same within {} of their "
      "scales.\nNoise: up to {} last bit{}. Rotation: {}. Seed {}.\n",
      flips.tolerance, flips.same, options.last_bits, options.last_bits == 1 ? "" : "s",
      options.angle ? fmt::format("up to {} degrees, another polygon", *options.angle)
                    : std::string("by multiples of the directions' spacing, the same polygon"),
      options.seed);
  return out;
}

}  // namespace

std::string render(const Flips& flips, FlipFormat format) {
  switch (format) {
    case FlipFormat::text:
      return text(flips);
    case FlipFormat::csv:
      return csv(flips);
    case FlipFormat::json:
      return json(flips);
  }
  throw std::logic_error("unknown format");
}

}  // namespace lcp
