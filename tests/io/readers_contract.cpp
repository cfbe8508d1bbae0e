#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <sstream>

#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/paths.hpp"

namespace eerie::io {
namespace {

struct Answer {
  int status = 0;
  std::string text;
};

Answer run(const std::string& command) {
  Answer answer;
  std::FILE* pipe = ::popen(command.c_str(), "r");
  if (!pipe) return {-1, "popen failed"};
  std::array<char, 4096> buffer;
  for (std::size_t n; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    answer.text.append(buffer.data(), n);
  answer.status = ::pclose(pipe);
  return answer;
}

/// Debian's Python: the readers are its packages, and another python3 on the PATH lacks them.
constexpr const char* python = "/usr/bin/python3";

/// What a reader prints about a snapshot of 300 particles; skips where it is not installed.
class Readers : public testing::Test {
 protected:
  void open_with(const char* script, const char* module, const char* package) {
    if (run(fmt::format("{} -c 'import {}' 2>&1", python, module)).status != 0)
      GTEST_SKIP() << package << " is not installed for " << python;
    write_snapshot(path_, snapshot_);
    const Answer answer = run(fmt::format("{} {}/tests/io/{} {} 2>&1", python,
                                          test::source_folder().string(), script, path_.string()));
    ASSERT_EQ(answer.status, 0) << answer.text;
    lines_.str(answer.text);
  }

  /// The rest of the lines: id and `columns` numbers, compared with the snapshot.
  void expect_particles(std::size_t columns, double relative_error) {
    std::vector<std::size_t> index_of(snapshot_.state.size());
    for (std::size_t i = 0; i < index_of.size(); ++i) index_of[snapshot_.state.id[i]] = i;
    const particles::State& s = snapshot_.state;
    for (std::size_t id = 0; id < s.size(); ++id) {
      const std::size_t i = index_of[id];
      const std::array<double, 6> wanted{s.x[i].x, s.x[i].y, s.x[i].z, s.rho[i], s.mass, s.h};
      std::size_t read_id = s.size();
      ASSERT_TRUE(lines_ >> read_id);
      ASSERT_EQ(read_id, id);
      for (std::size_t k = 0; k < columns; ++k) {
        double value = 0;
        ASSERT_TRUE(lines_ >> value);
        const double scale = k < 3 ? 123.456 : wanted[k];
        ASSERT_NEAR(value, wanted[k], relative_error * scale) << "id " << id << " column " << k;
      }
    }
  }

  test::TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "snapshot.hdf5";
  Snapshot snapshot_ = test::random_snapshot(300);
  std::istringstream lines_;
  std::string reader_;
  std::size_t particles_ = 0;
  double number_ = 0;  ///< the third word of the first line
};

TEST_F(Readers, YtSeesPositionsDensitiesMassesAndTime) {
  open_with("read_with_yt.py", "yt", "python3-yt");
  if (IsSkipped() || HasFatalFailure()) return;
  ASSERT_TRUE(lines_ >> reader_ >> particles_ >> number_);
  EXPECT_EQ(reader_, "SwiftDataset");
  EXPECT_EQ(particles_, snapshot_.state.size());  // yt drops particles outside of the box
  EXPECT_DOUBLE_EQ(number_, snapshot_.state.time);
  expect_particles(6, 1e-12);
}

TEST_F(Readers, H5pySeesExactPositionsDensitiesMassesAndTime) {
  open_with("read_with_h5py.py", "h5py", "python3-h5py");
  if (IsSkipped() || HasFatalFailure()) return;
  ASSERT_TRUE(lines_ >> reader_ >> particles_ >> number_);
  EXPECT_EQ(particles_, snapshot_.state.size());
  EXPECT_EQ(number_, snapshot_.state.time);
  expect_particles(6, 0);
}

TEST_F(Readers, VtkSeesExactPositionsAndDensities) {
  open_with("read_with_vtk.py", "vtkmodules.vtkIOHDF", "python3-vtk9");
  if (IsSkipped() || HasFatalFailure()) return;
  ASSERT_TRUE(lines_ >> reader_ >> particles_ >> number_);
  EXPECT_EQ(particles_, snapshot_.state.size());
  EXPECT_EQ(number_, static_cast<double>(snapshot_.state.size()));  // a vertex per particle
  expect_particles(4, 0);
}

}  // namespace
}  // namespace eerie::io
