// What FCLIB's own library makes of our files, and we of its files. Without the library these tests
// are skipped and say so.

#include <gtest/gtest.h>

#ifdef LCPBENCH_HAS_FCLIB

#include <array>
#include <cstdlib>
#include <memory>

#include "problems/contact/friction_lcp.h"
#include "problems/io/hdf5/corpus.h"
#include "problems/io/load.h"
#include "tests/problems/contact/contact_cases.h"
#include "tests/problems/io/files.h"
#include "tests/problems/io/same.h"

extern "C" {
#include <fclib.h>
}

namespace lcp {
namespace {

TEST(FclibLibrary, ReadsTheContactsThatWeWriteToTheBit) {
  const files::TemporaryFolder folder;
  const std::string path = folder.file("x.hdf5");
  cases::Uniform uniform(20);
  const ContactProblem contacts = cases::random_contacts({0.3, 0.7, 0}, 100, uniform);
  save_instances(path, {make_instance("a/1", friction_lcp(contacts), {{"scene", "none"}})});

  const auto release = [](fclib_local* problem) {
    fclib_delete_local(problem);  // of what it points to, but not of itself
    std::free(problem);
  };
  const std::unique_ptr<fclib_local, decltype(release)> read(fclib_read_local(path.c_str()),
                                                             release);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->spacedim, 3);
  EXPECT_EQ(read->V, nullptr);
  const fclib_matrix& W = *read->W;
  ASSERT_EQ(W.m, 9);
  ASSERT_EQ(W.n, 9);
  ASSERT_EQ(W.nz, -2);
  MatrixXd matrix = MatrixXd::Zero(9, 9);
  for (int i = 0; i < W.m; ++i)
    for (int k = W.p[i]; k < W.p[i + 1]; ++k) matrix(i, W.i[k]) = W.x[k];
  expect_same_bits(contacts.W, matrix, "W");
  expect_same_bits(contacts.vbar, Eigen::Map<VectorXd>(read->q, 9), "q");
  expect_same_bits(VectorXd{{0.3, 0.7, 0}}, Eigen::Map<VectorXd>(read->mu, 3), "mu");
}

/// A problem of two contacts in the plane, in one of FCLIB's storages.
void write_with_fclib(const std::string& path, int nz, std::vector<int> p, std::vector<int> i,
                      std::vector<double> x) {
  std::array<double, 4> q{-1, 2, -3, 4};
  std::array<double, 2> mu{0.5, 0.25};
  fclib_matrix W{};
  W.nzmax = static_cast<int>(x.size());
  W.m = W.n = 4;
  W.nz = nz;
  W.p = p.data();
  W.i = i.data();
  W.x = x.data();
  std::string title = "two contacts";
  fclib_info info{};
  info.title = title.data();
  fclib_local problem{};
  problem.W = &W;
  problem.q = q.data();
  problem.mu = mu.data();
  problem.spacedim = 2;
  problem.info = &info;
  ASSERT_EQ(fclib_write_local(&problem, path.c_str()), 1);
  std::array<double, 4> u{}, r{1, 0, 1, 0};
  fclib_solution solution{};
  solution.u = u.data();
  solution.r = r.data();
  ASSERT_EQ(fclib_write_solution(&solution, path.c_str()), 1);
}

TEST(FclibLibrary, WritesWhatWeRead) {
  const files::TemporaryFolder folder;
  write_with_fclib(folder.file("rows.hdf5"), -2, {0, 2, 3, 5, 6}, {0, 2, 1, 0, 2, 3},
                   {4, 1, 5, 1, 4, 6});
  write_with_fclib(folder.file("columns.hdf5"), -1, {0, 2, 3, 5, 6}, {0, 2, 1, 0, 2, 3},
                   {4, 1, 5, 1, 4, 6});
  write_with_fclib(folder.file("triplets.hdf5"), 6, {0, 2, 1, 0, 2, 3}, {0, 0, 1, 2, 2, 3},
                   {4, 1, 5, 1, 4, 6});
  std::string hash;
  for (const std::string name : {"rows", "columns", "triplets"}) {
    const Instance instance = load_instances(folder.file(name + ".hdf5")).front();
    EXPECT_EQ(instance.name, name);
    EXPECT_EQ(instance.provenance.at("title"), "two contacts");
    EXPECT_EQ(instance.provenance.at("dimension"), "2");
    EXPECT_FALSE(instance.known_solution);  // FCLIB's is that of another cone
    const FrictionBlocks& blocks = *instance.problem.friction;
    EXPECT_EQ(blocks.W(0, 3), 1) << name;
    EXPECT_EQ(blocks.W(4, 4), 6) << name;
    EXPECT_EQ(blocks.vbar, (VectorXd{{-1, 2, 0, -3, 4, 0}})) << name;
    EXPECT_EQ(blocks.mu, (VectorXd{{0.5, 0.25}})) << name;
    if (hash.empty()) hash = instance.sha256;
    EXPECT_EQ(instance.sha256, hash) << name;
  }
}

}  // namespace
}  // namespace lcp

#else

TEST(FclibLibrary, ReadsTheContactsThatWeWriteToTheBit) {
  GTEST_SKIP() << "built without FCLIB: no fclib.h or libfclib (Debian: libfclib-dev)";
}
TEST(FclibLibrary, WritesWhatWeRead) {
  GTEST_SKIP() << "built without FCLIB: no fclib.h or libfclib (Debian: libfclib-dev)";
}

#endif
