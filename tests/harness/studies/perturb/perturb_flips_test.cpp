#include "harness/studies/perturb/perturb_flips.h"

#include <gtest/gtest.h>

#include <sstream>

#include "harness/studies/perturb/perturb_pages.h"
#include "problems/registry.h"
#include "tests/harness/made_up_records.h"
#include "tests/harness/present/scenes/xml.h"
#include "tests/harness/temporary_directory.h"

namespace lcp {
namespace {

TEST(WilsonInterval, IsThatOfTheTextbooks) {
  EXPECT_NEAR(wilson_interval(5, 10).low, 0.2366, 1e-4);
  EXPECT_NEAR(wilson_interval(5, 10).high, 0.7634, 1e-4);
  EXPECT_EQ(wilson_interval(0, 10).low, 0);
  EXPECT_NEAR(wilson_interval(0, 10).high, 0.2775, 1e-4);
  EXPECT_NEAR(wilson_interval(10, 10).low, 0.7225, 1e-4);
  EXPECT_EQ(wilson_interval(0, 0).low, 0);
  EXPECT_EQ(wilson_interval(0, 0).high, 1);
}

/// LCP(I, q) with q = (-1, -1); and one with the same name in another corpus.
Instance identity(const std::string& name) {
  Problem problem;
  problem.M = MatrixXd::Identity(2, 2);
  problem.q = VectorXd::Constant(2, -1);
  return make_instance(name, problem, {});
}

PerturbOptions noise(Index trials) {
  PerturbOptions options;
  options.kinds = {DisturbanceKind::noise};
  options.trials = trials;
  return options;
}

/// What a run writes of `instance`.
Record record_of(const Instance& instance, const std::string& solver, Verdict verdict,
                 const std::vector<double>& z = {}, Index pivots = 10) {
  Record record = made_up(instance.name, solver, verdict,
                          verdict == Verdict::solved ? Claim::solved : Claim::ray, 0);
  record.sha256 = instance.sha256;
  record.work.pivots = pivots;
  if (!z.empty()) record.z = Eigen::Map<const VectorXd>(z.data(), static_cast<Index>(z.size()));
  return record;
}

/// Undisturbed and disturbed versions of an instance.
std::vector<Instance> versions(const Instance& instance, const PerturbOptions& options) {
  return expansion(options).make(instance);
}

const FlipRow& row(const Flips& flips, const std::string& corpus, const std::string& solver,
                   const std::string& kind) {
  for (const FlipRow& each : flips.rows)
    if (each.corpus == corpus && each.solver == solver && each.kind == kind) return each;
  throw std::invalid_argument("no row " + corpus + " " + solver + " " + kind);
}

TEST(Flips, AreLostAndGainedAndOtherChangesAreApart) {
  const Instance a = identity("a/0"), b = identity("b/0");
  const std::vector<Instance> of_a = versions(a, noise(3)), of_b = versions(b, noise(3));
  ASSERT_EQ(of_a.size(), 4u);
  std::vector<Record> records = {
      record_of(of_a[0], "s", Verdict::solved, {1, 1}),
      record_of(of_a[1], "s", Verdict::ray),
      record_of(of_a[2], "s", Verdict::solved, {1, 1}),
      record_of(of_a[3], "s", Verdict::timeout),
      record_of(of_b[0], "s", Verdict::ray),
      record_of(of_b[1], "s", Verdict::solved, {1, 1}),
      record_of(of_b[2], "s", Verdict::wrong),
      record_of(of_b[3], "s", Verdict::ray),
  };
  const Flips flips = count_flips({a, b}, records, noise(3), 1e-6);
  const FlipRow& in_a = row(flips, "a", "s", "noise");
  EXPECT_EQ(in_a.trials, 3);
  EXPECT_EQ(in_a.solved, 1);
  EXPECT_EQ(in_a.lost, 2);
  EXPECT_EQ(in_a.gained, 0);
  EXPECT_EQ(in_a.instances_flipped, 1);
  const FlipRow& in_b = row(flips, "b", "s", "noise");
  EXPECT_EQ(in_b.gained, 1);
  EXPECT_EQ(in_b.other_changes, 1);
  const FlipRow& pooled = row(flips, "all corpora", "s", "noise");
  EXPECT_EQ(pooled.trials, 6);
  EXPECT_EQ(pooled.flips(), 3);
  EXPECT_EQ(pooled.baseline_solved, 3);
  const FlipRow& baseline = row(flips, "all corpora", "s", "baseline");
  EXPECT_EQ(baseline.trials, 2);
  EXPECT_EQ(baseline.solved, 1);
}

TEST(Flips, TellSolutionsApartAndWhetherTheyMoveAlike) {
  Problem problem;  // w = z1 + z2 - 1 twice: any z >= 0 with z1 + z2 = 1
  problem.M = MatrixXd::Ones(2, 2);
  problem.q = VectorXd::Constant(2, -1);
  const Instance instance = make_instance("a/0", problem, {});
  const std::vector<Instance> all = versions(instance, noise(4));
  const std::vector<Record> records = {
      record_of(all[0], "s", Verdict::solved, {1, 0}, 4),
      record_of(all[1], "s", Verdict::solved, {1, 1e-9}, 6),
      record_of(all[2], "s", Verdict::solved, {0, 1}, 8),
      record_of(all[3], "s", Verdict::solved, {0.5, 0.5}, 4),
      record_of(all[4], "s", Verdict::solved, {0, 1.1}, 4),
  };
  const Flips flips = count_flips({instance}, records, noise(4), 1e-6);
  const FlipRow& noisy = row(flips, "a", "s", "noise");
  EXPECT_EQ(noisy.compared, 1);
  EXPECT_EQ(noisy.several, 1);
  EXPECT_EQ(noisy.most_distinct, 4);
  EXPECT_EQ(noisy.other_z, 3);
  EXPECT_EQ(noisy.other_z_same_w, 2);
  EXPECT_EQ(noisy.other_z_same_motion, 2);
  EXPECT_DOUBLE_EQ(noisy.pivot_ratio.value(), 2);
  EXPECT_EQ(row(count_flips({instance}, records, noise(4), 1), "a", "s", "noise").several, 1)
      << "1.1 is further than 1 from 0";
  EXPECT_EQ(row(count_flips({instance}, records, noise(4), 2), "a", "s", "noise").several, 0);
}

TEST(Flips, AnswersArePutBackIntoTheOriginalsRows) {
  Problem problem;
  problem.M = MatrixXd::Identity(3, 3);
  problem.q = Eigen::Vector3d(-1, -2, -3);
  const Instance instance = make_instance("a/0", problem, {});
  PerturbOptions options;
  options.kinds = {DisturbanceKind::permutation, DisturbanceKind::units, DisturbanceKind::scale_q};
  std::vector<Record> records;
  for (const Instance& each : versions(instance, options)) {
    const VectorXd z = (-each.problem.q).cwiseQuotient(each.problem.M.diagonal());
    records.push_back(record_of(each, "s", Verdict::solved, {z.begin(), z.end()}));
  }
  const Flips flips = count_flips({instance}, records, options, 1e-12);
  for (const char* kind : {"permutation", "units", "scale-q"}) {
    EXPECT_EQ(row(flips, "a", "s", kind).compared, 1) << kind;
    EXPECT_EQ(row(flips, "a", "s", kind).most_distinct, 1) << kind;
  }
}

TEST(Flips, LeaveOutTrivialInstancesAndRefusals) {
  const Instance a = identity("a/0"), b = identity("a/1");
  const std::vector<Instance> of_a = versions(a, noise(1)), of_b = versions(b, noise(1));
  std::vector<Record> records = {
      record_of(of_a[0], "s", Verdict::solved, {1, 1}), record_of(of_a[1], "s", Verdict::ray),
      record_of(of_b[0], "s", Verdict::unsupported), record_of(of_b[1], "s", Verdict::unsupported)};
  records[0].trivial = true;
  const FlipRow noisy = row(count_flips({a, b}, records, noise(1), 1e-6), "a", "s", "noise");
  EXPECT_EQ(noisy.trials, 0);
  EXPECT_EQ(noisy.trivial, 1);
  EXPECT_EQ(noisy.unsupported, 1);
}

TEST(Flips, CountAnInterruptedRunAndLeaveOutRowsOfOtherDraws) {
  const Instance a = identity("a/0");
  PerturbOptions other = noise(2);
  other.seed = 2;
  const std::vector<Instance> of_a = versions(a, noise(2)), of_other = versions(a, other);
  ASSERT_NE(of_a[1].sha256, of_other[1].sha256);
  const std::vector<Record> records = {record_of(of_a[0], "s", Verdict::solved, {1, 1}),
                                       record_of(of_other[1], "s", Verdict::ray),
                                       record_of(of_a[2], "s", Verdict::ray)};
  const FlipRow noisy = row(count_flips({a}, records, noise(2), 1e-6), "a", "s", "noise");
  EXPECT_EQ(noisy.trials, 1);
  EXPECT_EQ(noisy.lost, 1);
}

Flips small_flips() {
  const Instance a = identity("a,x/0");
  PerturbOptions options = noise(2);
  options.kinds.push_back(DisturbanceKind::rotation);
  const std::vector<Instance> all = versions(a, options);
  return count_flips(
      {a},
      {record_of(all[0], "s", Verdict::solved, {1, 1}), record_of(all[1], "s", Verdict::ray),
       record_of(all[2], "s", Verdict::solved, {1, 1})},
      options, 1e-6);
}

TEST(FlipRendering, SaysTheSameInEveryFormat) {
  const Flips flips = small_flips();
  const nlohmann::json json = described(flips).json;
  ASSERT_EQ(json.at("rows").size(), 3u);
  EXPECT_EQ(json.at("rows")[1].at("flips"), 1);
  EXPECT_EQ(json.at("rows")[1].at("flip_rate"), 0.5);
  EXPECT_TRUE(json.at("rows")[0].at("flip_rate").is_null());
  EXPECT_EQ(json.at("not_applicable")[0].at("reason"), "no contact has friction");
  EXPECT_EQ(json.at("options").get<PerturbOptions>(), flips.options);

  std::istringstream csv(described(flips).csv);
  std::string head, baseline, noisy;
  std::getline(csv, head);
  std::getline(csv, baseline);
  std::getline(csv, noisy);
  EXPECT_EQ(noisy.rfind("\"a,x\",s,cold,noise,1,1,2,1,2,1,0,", 0), 0u) << noisy;
  // The corpus has a comma of its own.
  EXPECT_EQ(std::count(head.begin(), head.end(), ',') + 1,
            std::count(noisy.begin(), noisy.end(), ','));

  const std::string text = described(flips).text;
  EXPECT_NE(text.find("rotation unsupported for 1 instance: no contact has friction"),
            std::string::npos)
      << text;
}

TEST(FlipChart, IsDrawn) {
  const TemporaryDirectory directory;
  draw_figure(directory.file("flips.svg"), flips_figure(small_flips()));
  const std::string svg = read_text(directory.file("flips.svg"));
  EXPECT_EQ(complaint_about_xml(svg), "");
  EXPECT_NE(svg.find("last-bit noise"), std::string::npos);
  EXPECT_THROW(flips_figure(Flips{}), std::invalid_argument);
  EXPECT_TRUE(described(Flips{}).figure.panels.empty());
}

}  // namespace
}  // namespace lcp
