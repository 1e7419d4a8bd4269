#include "problems/instance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <set>

#include "tests/problems/cases.h"

namespace lcp {
namespace {

// The digests were computed by Python's hashlib from the bytes that the header describes.
TEST(ContentHash, IsTheSha256OfTheDocumentedBytes) {
  EXPECT_EQ(content_hash(cases::plain_with_all_options()),
            "b38cbd21628225027dab6d4c9fa48d7b61a5aa020480cb34c3b9efd1339c2ba8");
  EXPECT_EQ(content_hash(cases::with_contacts()),
            "03f4336e077fc5a2f5a206ccfbd1ecdc2834968e28ef8a77878b0fa0a2aef903");
}

TEST(ContentHash, DiffersWithEveryField) {
  const std::vector<std::function<void(Problem&)>> changes = {
      [](Problem&) {},
      [](Problem& p) { p.M(6, 5) = std::nextafter(p.M(6, 5), 1); },
      [](Problem& p) { p.q(0) = -p.q(0); },
      [](Problem& p) { p.s_z(1) *= 2; },
      [](Problem& p) { p.s_w(1) *= 2; },
      [](Problem& p) { p.c = VectorXd::Ones(7); },
      [](Problem& p) { p.pivot_limit = 5; },
      [](Problem& p) { p.friction.reset(); },
      [](Problem& p) { p.friction->W(5, 0) += 1; },
      [](Problem& p) { p.friction->vbar(5) += 1; },
      [](Problem& p) { p.friction->mu(0) += 1; },
      [](Problem& p) { p.friction->directions(1, 7) += 1; },
      [](Problem& p) { p.friction->directions_per_contact = 2; },
      [](Problem& p) {
        p.friction->normal_row = {1, 0};
      },
      [](Problem& p) { p.friction->friction_row[0] = 3; },
      [](Problem& p) { p.friction->cone_row[0] = 5; },
  };
  std::set<std::string> hashes;
  for (const auto& change : changes) {
    Problem problem = cases::with_contacts();
    change(problem);
    hashes.insert(content_hash(problem));
  }
  EXPECT_EQ(hashes.size(), changes.size());
}

TEST(ContentHash, CountsNegativeZeroAsZero) {
  Problem problem = cases::plain();
  const std::string hash = content_hash(problem);
  ASSERT_EQ(problem.M(0, 2), 0);
  problem.M(0, 2) = -0.0;
  EXPECT_EQ(content_hash(problem), hash);
}

TEST(MakeInstance, LeavesNameAndProvenanceOutOfTheHash) {
  const Instance one = make_instance("one", cases::plain(), {});
  const Instance two = make_instance("two", cases::plain(), {{"source", "a book"}});
  EXPECT_EQ(one.sha256, content_hash(cases::plain()));
  EXPECT_EQ(one.sha256, two.sha256);
}

TEST(HashWithPrevious, IsThatOfTheContentWhereThereIsNoneAndDiffersWithEveryFieldOfIt) {
  Instance instance = make_instance("a", cases::with_contacts(), {});
  std::set<std::string> hashes = {hash_with_previous(instance)};
  EXPECT_EQ(*hashes.begin(), content_hash(cases::with_contacts()));
  instance.previous = Start{};
  hashes.insert(hash_with_previous(instance));
  instance.previous = cases::previous_of_contacts();
  hashes.insert(hash_with_previous(instance));
  instance.previous->alpha.pop_back();
  hashes.insert(hash_with_previous(instance));
  instance.previous->z(3) = 1;
  hashes.insert(hash_with_previous(instance));
  instance.sha256 = std::string(64, '0');
  hashes.insert(hash_with_previous(instance));
  EXPECT_EQ(hashes.size(), 6u);
}

TEST(CheckStart, WantsAscendingRowsAndAPointOfTheRightSize) {
  check(Start{.alpha = {0, 2}, .z = VectorXd::Zero(3)}, 3, "here");
  check(Start{}, 3, "here");
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Start& wrong : {Start{.alpha = {3}}, Start{.alpha = {-1}}, Start{.alpha = {1, 1}},
                             Start{.alpha = {2, 0}}, Start{.alpha = {}, .z = VectorXd::Zero(2)},
                             Start{.alpha = {}, .z = VectorXd::Constant(3, nan)}})
    EXPECT_THROW(check(wrong, 3, "here"), std::invalid_argument);
}

TEST(MakeInstance, GivesPlainScalesToAProblemWithoutAny) {
  Problem bare;
  bare.M = MatrixXd{{2, 0}, {0, -8}};
  bare.q = VectorXd{{-4, 1}};
  const Instance instance = make_instance("bare", bare, {});
  EXPECT_EQ(instance.problem.s_w, VectorXd::Constant(2, 4));
  EXPECT_EQ(instance.problem.s_z, VectorXd::Constant(2, 0.5));
  bare.s_z = VectorXd::Ones(2);
  EXPECT_THROW(make_instance("half", bare, {}), std::invalid_argument) << "s_w is missing";
}

TEST(MakeInstance, RefusesNumbersThatAreNotFinite) {
  Problem problem = cases::plain();
  problem.q(1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(make_instance("broken", problem, {}), std::invalid_argument);
}

}  // namespace
}  // namespace lcp
