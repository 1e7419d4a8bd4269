#include "problems/io/text/matrix_market.h"

#include <gtest/gtest.h>

#include "problems/io/errors.h"
#include "tests/problems/cases.h"
#include "tests/problems/io/files.h"
#include "tests/problems/io/same.h"

namespace lcp {
namespace {

class MatrixMarket : public testing::Test {
 protected:
  Instance read() { return read_matrix_market(M, "x"); }
  std::string complaint() {
    const std::string message = files::message_of<UnreadableInput>([&] { read(); });
    return message.starts_with(folder.path() + "/") ? message.substr(folder.path().size() + 1)
                                                    : message;
  }
  std::string refusal(const Problem& problem) {
    const std::string message = files::message_of<UnwritableOutput>(
        [&] { write_matrix_market(M, make_instance("x", problem, {})); });
    EXPECT_TRUE(folder.empty());
    return message.starts_with(M) ? message.substr(M.size()) : message;
  }

  const files::TemporaryFolder folder;
  const std::string M = folder.file("x.M.mtx"), q = folder.file("x.q.mtx");
  const std::string q_of_two = "%%MatrixMarket matrix array real general\n2 1\n-1\n5\n";
};

TEST_F(MatrixMarket, GivesBackEveryBit) {
  Problem problem;
  problem.M = MatrixXd{{1.0 / 3, -2e-310, 0}, {0.1, 1.7e308, 5e-324}, {1e22, -0.0, -7.0 / 9}};
  problem.q = VectorXd{{-1e-300, 123456.789, 2.0 / 7}};
  set_plain_scales(problem);
  const Instance written = make_instance("x", problem, {});
  write_matrix_market(M, written);
  Instance read_back = read();
  EXPECT_EQ(read_back.provenance.at("file"), M);
  read_back.provenance.clear();
  expect_same(written, read_back);
}

TEST_F(MatrixMarket, GivesBackSymmetricAndZeroMatricesInFull) {
  for (const MatrixXd& matrix : {MatrixXd{{2, -1}, {-1, 3}}, MatrixXd{{0, -1}, {1, 0}},
                                 MatrixXd{{0, 0}, {0, 0}}, MatrixXd{{1, 0}, {0, 4}}}) {
    Problem problem;
    problem.M = matrix;
    problem.q = VectorXd{{-1, 0}};
    set_plain_scales(problem);
    write_matrix_market(M, make_instance("x", problem, {}));
    expect_same_bits(matrix, read().problem.M, "M");
  }
}

TEST_F(MatrixMarket, ReadsEveryStorageInFull) {
  files::put(q, q_of_two);
  const auto expect_read = [&](const std::string& text, const MatrixXd& expected) {
    files::put(M, "%%MatrixMarket matrix " + text);
    expect_same_bits(expected, read().problem.M, text.c_str());
  };
  expect_read("coordinate real symmetric\n% note\n2 2 3\n1 1 1\n2 1 5\n2 2 3\n",
              MatrixXd{{1, 5}, {5, 3}});
  expect_read("coordinate integer skew-symmetric\n2 2 1\n2 1 5\n", MatrixXd{{0, -5}, {5, 0}});
  expect_read("array real symmetric\n2 2\n1\n2\n3\n", MatrixXd{{1, 2}, {2, 3}});
  expect_read("array real general\n2 2\n1\n2\n3\n4\n", MatrixXd{{1, 3}, {2, 4}});
  expect_read("array real skew-symmetric\n2 2\n5\n", MatrixXd{{0, -5}, {5, 0}});
  expect_read(
      "coordinate real general\n%" + std::string(2000, 'x') + "2 2 1\n2 2 2\n1 1 1\n1 1 2\n",
      MatrixXd{{3, 0}, {0, 0}});  // a long comment; entries stored twice are added
}

TEST_F(MatrixMarket, RefusesWhatItCannotHoldWithTheReason) {
  EXPECT_EQ(refusal(cases::with_contacts()),
            ": Matrix Market cannot hold 'x': the instance has friction blocks; write .hdf5");
  Problem problem = cases::plain();
  problem.c = VectorXd::Ones(3);
  EXPECT_NE(refusal(problem).find("has a covering vector of its own"), std::string::npos);
  problem = cases::plain();
  problem.pivot_limit = 7;
  EXPECT_NE(refusal(problem).find("has a pivot limit of its own"), std::string::npos);
  problem = cases::plain();
  problem.s_w(2) *= 2;
  EXPECT_NE(refusal(problem).find("has scales of its own"), std::string::npos);
  problem = Problem();
  set_plain_scales(problem);
  EXPECT_NE(refusal(problem).find("is empty"), std::string::npos);
}

TEST_F(MatrixMarket, ReportsMissingAndEmptyFiles) {
  EXPECT_EQ(complaint(), "x.M.mtx: no such file, expected a Matrix Market file");
  files::put(M, "");
  EXPECT_EQ(complaint(), "x.M.mtx: empty or unreadable, expected a Matrix Market file");
  files::put(M, "%%MatrixMarket matrix array real general\n1 1\n1\n");
  EXPECT_EQ(complaint(), "x.q.mtx: no such file, expected a Matrix Market file");
}

TEST_F(MatrixMarket, ReportsMalformedContent) {
  files::put(q, q_of_two);
  const auto complaint_about = [&](const std::string& text) {
    files::put(M, text);
    return complaint();
  };
  const std::string header = "%%MatrixMarket matrix coordinate real general\n";
  EXPECT_EQ(complaint_about(header + "2 2 3\n1 1 1\n2 1 5\n"),
            "x.M.mtx: holds 2 entries, expected 3");
  EXPECT_EQ(complaint_about("%%MatrixMarket matrix array real symmetric\n2 2\n1\n2\n"),
            "x.M.mtx: holds 2 entries, expected 3");
  for (const std::string entry :
       {"1 1 one", "1 1", "0 0 1", "1.5 1 1", "3 1 1", "1 3 1", "1 1 1 1"})
    EXPECT_EQ(complaint_about(header + "2 2 1\n" + entry + "\n"),
              "x.M.mtx: line '" + entry + "', expected row 1 ... 2, column 1 ... 2 and value");
  EXPECT_EQ(complaint_about("%%MatrixMarket matrix coordinate pattern general\n2 2 1\n1 1\n"),
            "x.M.mtx: line '1 1', expected row 1 ... 2, column 1 ... 2 and value");
  EXPECT_EQ(complaint_about("%%MatrixMarket matrix array real general\n2 2\n1 2\n3 4\n"),
            "x.M.mtx: line '1 2', expected one value");
  for (const std::string first : {"hello", "%%MatrixMarket vector array real general",
                                  "%%MatrixMarket matrix array complex general"})
    EXPECT_EQ(complaint_about(first + "\n2 2 1\n1 1 1\n"),
              "x.M.mtx: line '" + first +
                  "', expected '%%MatrixMarket matrix coordinate|array real|integer "
                  "general|symmetric|skew-symmetric'");
  EXPECT_EQ(complaint_about(header),
            "x.M.mtx: line '', expected 1 ... 16384 rows and columns and entries");
  EXPECT_EQ(complaint_about(header + std::string(1029, 'x') + "\n"),
            "x.M.mtx: line '" + std::string(60, 'x') +
                "', expected 1 ... 16384 rows and columns and entries");
  const std::string skew = "%%MatrixMarket matrix coordinate real skew-symmetric\n";
  EXPECT_EQ(complaint_about(skew + "2 2 1\n1 1 1\n"),
            "x.M.mtx: line '1 1 1', expected nothing on the diagonal of a skew-symmetric matrix");
  EXPECT_EQ(complaint_about(skew + "2 3 1\n2 1 1\n"),
            "x.M.mtx: line '2 3 1', expected as many rows as columns where it is symmetric");
  EXPECT_EQ(complaint_about(header + "2 3 1\n1 1 1\n"),
            "x.M.mtx: M is 2 x 3, expected a square matrix");
  EXPECT_EQ(complaint_about(header + "3 3 1\n1 1 1\n"), "x.q.mtx: q is 2 x 1, expected 3 x 1");
  EXPECT_EQ(complaint_about(header + "2 2 1\n1 2 nan\n"),
            "x.M.mtx: x: M(0, 1) is nan, expected a finite number");
}

TEST_F(MatrixMarket, AllocatesNothingForSizesBeyondTheFile) {
  files::put(M, "%%MatrixMarket matrix coordinate real general\n99999999 99999999 1\n1 1 1\n");
  EXPECT_EQ(
      complaint(),
      "x.M.mtx: line '99999999 99999999 1', expected 1 ... 16384 rows and columns and entries");
  files::put(M, "%%MatrixMarket matrix coordinate real general\n9 9 2000000000\n1 1 1\n");
  EXPECT_EQ(complaint(), "x.M.mtx: declares 2000000000 entries in a file of 67 bytes");
  files::put(M, "%%MatrixMarket matrix array real general\n16000 16000\n1\n");
  EXPECT_EQ(complaint(), "x.M.mtx: declares 256000000 entries in a file of 55 bytes");
}

}  // namespace
}  // namespace lcp
