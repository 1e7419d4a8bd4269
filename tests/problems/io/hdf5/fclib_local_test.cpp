#include "problems/io/hdf5/fclib_local.h"

#include <gtest/gtest.h>

#include "problems/contact/friction_lcp.h"
#include "problems/io/errors.h"
#include "problems/io/hdf5/corpus.h"
#include "tests/problems/contact/contact_cases.h"
#include "tests/problems/io/files.h"
#include "tests/problems/io/same.h"

namespace lcp {
namespace {

using Integers = std::vector<int>;

/// The groups of an FCLIB file, written number by number.
class FclibFile : public testing::Test {
 protected:
  struct Matrix {
    int nz;
    Integers p, i;
    VectorXd x;
  };

  void write(int dimension, int size, const Matrix& W, const VectorXd& q, const VectorXd& mu) {
    H5::H5File file(path, H5F_ACC_TRUNC);
    H5::Group problem = file.createGroup("fclib_local");
    hdf5::write(problem, "spacedim", Integers{dimension});
    H5::Group matrix = problem.createGroup("W");
    hdf5::write(matrix, "m", Integers{size});
    hdf5::write(matrix, "n", Integers{size});
    hdf5::write(matrix, "nz", Integers{W.nz});
    hdf5::write(matrix, "nzmax", Integers{static_cast<int>(W.x.size())});
    hdf5::write(matrix, "p", W.p);
    hdf5::write(matrix, "i", W.i);
    hdf5::write(matrix, "x", W.x);
    H5::Group vectors = problem.createGroup("vectors");
    hdf5::write(vectors, "q", q);
    hdf5::write(vectors, "mu", mu);
  }

  /// One contact in space with W = ((4, 0, 0), (0, 5, 1e-9), (0, 0, 6)).
  void write_one_contact(const Matrix& W) { write(3, 3, W, VectorXd{{-1, 2, 3}}, VectorXd{{0.5}}); }

  std::string complaint() {
    const std::string message = files::message_of<UnreadableInput>([&] { read_corpus(path); });
    return message.starts_with(path + ": ") ? message.substr(path.size() + 2) : message;
  }

  void change(const std::function<void(H5::H5File&)>& change) {
    H5::H5File file(path, H5F_ACC_RDWR);
    change(file);
  }

  const files::TemporaryFolder folder;
  const std::string path = folder.file("x.hdf5");
  const Matrix rows{-2, {0, 1, 3, 4}, {0, 1, 2, 2}, VectorXd{{4, 5, 1e-9, 6}}};
  const Matrix columns{-1, {0, 1, 2, 4}, {0, 1, 1, 2}, VectorXd{{4, 5, 1e-9, 6}}};
  const Matrix triplets{4, {2, 2, 0, 1}, {1, 2, 0, 1}, VectorXd{{1e-9, 6, 4, 5}}};
};

TEST_F(FclibFile, GivesTheSameLcpFromEveryStorage) {
  ContactProblem expected;
  expected.contacts = cases::floor_contacts({0.5});
  expected.W = MatrixXd{{4, 0, 0}, {0, 5, 1e-9}, {0, 0, 6}};
  expected.vbar = VectorXd{{-1, 2, 3}};
  expected.asymmetry_allowed = 1;
  const std::string hash = content_hash(friction_lcp(expected));
  for (const auto& [W, storage] : {std::pair{rows, "compressed rows"},
                                   {columns, "compressed columns"},
                                   {triplets, "triplets"}}) {
    write_one_contact(W);
    const std::vector<Instance> read = read_corpus(path, "", {}, "stem");
    ASSERT_EQ(read.size(), 1u);
    EXPECT_EQ(read.front().name, "stem");
    EXPECT_EQ(read.front().sha256, hash) << storage;
    EXPECT_EQ(read.front().provenance.at("storage"), storage);
    EXPECT_EQ(read.front().provenance.at("asymmetry of W"), "1.67e-10");
  }
}

TEST_F(FclibFile, AddsTripletsOfOnePlaceAndIgnoresRoomBehindThem) {
  write_one_contact({4, {0, 1, 2, 0}, {0, 1, 2, 0}, VectorXd{{3, 5, 6, 1, 99, 99}}});
  EXPECT_EQ(read_corpus(path).front().problem.friction->W,
            (MatrixXd{{4, 0, 0}, {0, 5, 0}, {0, 0, 6}}));
}

TEST_F(FclibFile, PutsContactsOfThePlaneIntoSpace) {
  // Two contacts: (normal, tangent) each; W couples the normals.
  write(2, 4, {-2, {0, 2, 3, 5, 6}, {0, 2, 1, 0, 2, 3}, VectorXd{{4, 1, 5, 1, 4, 6}}},
        VectorXd{{-1, 2, -3, 4}}, VectorXd{{0.5, 0.25}});
  const Instance instance = read_corpus(path).front();
  const FrictionBlocks& blocks = *instance.problem.friction;
  EXPECT_EQ(instance.problem.size(), 2 * (1 + 2 + 1));
  EXPECT_EQ(blocks.vbar, (VectorXd{{-1, 2, 0, -3, 4, 0}}));
  MatrixXd W = MatrixXd::Zero(6, 6);
  W(0, 0) = W(3, 3) = 4;
  W(0, 3) = W(3, 0) = 1;
  W(1, 1) = 5;
  W(4, 4) = 6;
  EXPECT_EQ(blocks.W, W);
  EXPECT_EQ(blocks.directions_per_contact, 2);
}

TEST_F(FclibFile, RefusesWhatIsNoLocalProblemOfContacts) {
  write_one_contact(rows);
  change([](H5::H5File& file) { file.createGroup("/fclib_local/V"); });
  EXPECT_EQ(complaint(), "/fclib_local/V: is an equality block, expected contacts only");
  change([](H5::H5File& file) { file.createGroup("/fclib_global"); });
  EXPECT_EQ(complaint(), "/fclib_global: is a global problem, expected a local one (fclib_local)");
}

TEST_F(FclibFile, RefusesMatricesThatPointNowhereOrAreNotSymmetric) {
  write_one_contact({4, {2, 3, 0, 1}, {1, 2, 0, 1}, VectorXd{{1e-9, 6, 4, 5}}});
  EXPECT_EQ(complaint(), "/fclib_local/W/p: entry 1 is 3, expected 0 ... 2");
  write_one_contact({4, {2, 2, 0, 1}, {1, -1, 0, 1}, VectorXd{{1e-9, 6, 4, 5}}});
  EXPECT_EQ(complaint(), "/fclib_local/W/i: entry 1 is -1, expected 0 ... 2");
  write_one_contact({4, {2, 2, 0, 1}, {1, 2, 0, 1}, VectorXd{{1, 6, 4, 5}}});
  EXPECT_EQ(complaint(),
            "/fclib_local: contact problem: W(2, 1) is 0 but W(1, 2) is 1, expected a symmetric W");
  write(4, 3, rows, VectorXd{{-1, 2, 3}}, VectorXd{{0.5}});
  EXPECT_EQ(complaint(), "/fclib_local/spacedim: is 4, expected 2 ... 3");
}

TEST_F(FclibFile, RefusesMoreContactsThanAnLcpMayHaveRows) {
  write(3, 3 * 4000, {0, {}, {}, VectorXd()}, VectorXd::Zero(3 * 4000), VectorXd::Ones(4000));
  EXPECT_EQ(complaint(),
            "/fclib_local: 4000 contacts with 8 directions make an LCP of 40000 rows, expected at "
            "most 16384");
}

}  // namespace
}  // namespace lcp
