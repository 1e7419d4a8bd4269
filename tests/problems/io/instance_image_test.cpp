#include "problems/io/instance_image.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "tests/problems/cases.h"
#include "tests/problems/io/same.h"

namespace lcp {
namespace {

std::vector<Instance> all_kinds() {
  Instance contacts =
      make_instance("frames/1", cases::with_contacts(), {{"scene", "two\nlines"}, {"empty", ""}});
  contacts.active_contacts = 1;
  contacts.previous = cases::previous_of_contacts();
  Instance options = make_instance("options", cases::plain_with_all_options(), {});
  options.known_solution = VectorXd{{-0.0, 2e-300}};
  options.previous = Start{};  // of an empty basis, without a point
  return {contacts, options};
}

TEST(InstanceImage, GivesBackEveryBit) {
  const std::vector<Instance> written = all_kinds(), read = from_image(to_image(written));
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t i = 0; i < written.size(); ++i) expect_same(written[i], read[i]);
}

TEST(InstanceImage, IsRefusedWhereverItIsCut) {
  const std::string image = to_image(all_kinds());
  for (std::size_t size = 0; size < image.size(); ++size)
    EXPECT_THROW(from_image(image.substr(0, size)), std::invalid_argument) << size;
}

TEST(InstanceImage, ChecksTheProblem) {
  std::vector<Instance> instances = all_kinds();
  instances[0].problem.q(0) = std::numeric_limits<double>::infinity();
  EXPECT_THROW(from_image(to_image(instances)), std::invalid_argument);
}

TEST(InstanceImage, ChecksThePreviousSolution) {
  std::vector<Instance> instances = all_kinds();
  instances[0].previous->alpha = {7};
  EXPECT_THROW(from_image(to_image(instances)), std::invalid_argument);
}

}  // namespace
}  // namespace lcp
