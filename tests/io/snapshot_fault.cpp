#include <gmock/gmock.h>

#include <fstream>

#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "solver/base/random.hpp"
#include "solver/io/seal.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/file_size_limit.hpp"
#include "tests/support/paths.hpp"

namespace eerie::io {
namespace {

using test::differences;
using test::random_snapshot;
using testing::HasSubstr;
using testing::IsEmpty;

void put(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
}

std::string with_flipped_bit(std::string bytes, std::size_t bit) {
  bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << (bit % 8)));
  return bytes;
}

/// A sound file, and what reading a spoilt copy of it does.
class SnapshotFile : public testing::Test {
 protected:
  SnapshotFile() {
    write_snapshot(path_, snapshot_);
    bytes_ = read_file(path_);
  }

  enum class Outcome { refused, same, wrong };
  Outcome read_back(const std::string& bytes) {
    put(path_, bytes);
    try {
      const Snapshot read = read_snapshot(path_);
      return differences(read, snapshot_).empty() ? Outcome::same : Outcome::wrong;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("spoilt.hdf5 is not a usable snapshot: "));
      return Outcome::refused;
    }
  }

  test::TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "spoilt.hdf5";
  Snapshot snapshot_ = random_snapshot(150);
  std::string bytes_;
};

TEST_F(SnapshotFile, UnspoiltIsRead) { EXPECT_EQ(read_back(bytes_), Outcome::same); }

TEST_F(SnapshotFile, TruncatedAnywhereIsRefused) {
  Random random(1, 1);
  std::vector<std::size_t> lengths = {0, 1, 7, 8, 9, 47, 48, 512, bytes_.size() - 1};
  for (int i = 0; i < 400; ++i)
    lengths.push_back(
        static_cast<std::size_t>(random.uniform() * static_cast<double>(bytes_.size())));
  for (const std::size_t length : lengths)
    EXPECT_EQ(read_back(bytes_.substr(0, length)), Outcome::refused) << length;
}

TEST_F(SnapshotFile, CutInItsSealIsRefused) {
  const std::size_t seal_length = seal("").size();
  for (std::size_t cut = 1; cut <= seal_length + 1; ++cut)
    EXPECT_EQ(read_back(bytes_.substr(0, bytes_.size() - cut)), Outcome::refused) << cut;
}

TEST_F(SnapshotFile, FlippedBitIsRefusedWhereverItIs) {
  std::size_t tried = 0;
  // A stride without a common factor with 8: every bit of a byte has its turn.
  for (std::size_t bit = 0; bit < 8 * bytes_.size(); bit += 401, ++tried)
    ASSERT_EQ(read_back(with_flipped_bit(bytes_, bit)), Outcome::refused) << "bit " << bit;
  for (std::size_t bit = 8 * (bytes_.size() - seal("").size()); bit < 8 * bytes_.size(); ++bit)
    ASSERT_EQ(read_back(with_flipped_bit(bytes_, bit)), Outcome::refused) << "seal, bit " << bit;
  EXPECT_GT(tried, 2000u);
}

TEST_F(SnapshotFile, DamageIsCalledDamage) {
  for (const std::string& spoilt :
       {with_flipped_bit(bytes_, 4 * bytes_.size()),
        with_flipped_bit(bytes_, 8 * bytes_.size() - 9), bytes_.substr(0, bytes_.size() - 1)}) {
    put(path_, spoilt);
    try {
      read_snapshot(path_);
      ADD_FAILURE() << "was read";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("it is damaged"));
    }
  }
}

/// Written by a program that knew neither seal nor solver version.
class UnsealedFile : public SnapshotFile {
 protected:
  UnsealedFile() {
    const std::filesystem::path file =
        test::source_folder() / "tests/fuzz/corpus/checkpoint/without_seal.hdf5";
    snapshot_ = read_snapshot(file);
    bytes_ = read_file(file);
  }
};

TEST_F(UnsealedFile, IsReadAndCountsAsOfTheFirstSolverVersion) {
  EXPECT_EQ(snapshot_.state.step, 321);
  EXPECT_EQ(snapshot_.state.size(), 12u);
  EXPECT_TRUE(snapshot_.rates && snapshot_.restart);
  EXPECT_EQ(snapshot_.solver_version, "0.1.0");
}

TEST_F(UnsealedFile, FlippedBitIsRefusedOrChangesNothing) {
  int refused = 0, tried = 0;
  for (std::size_t bit = 0; bit < 8 * bytes_.size(); bit += 401, ++tried) {
    const Outcome outcome = read_back(with_flipped_bit(bytes_, bit));
    ASSERT_NE(outcome, Outcome::wrong) << "bit " << bit;
    refused += outcome == Outcome::refused;
  }
  // What only other readers use (links, unread copies) may be spoilt unnoticed; not the rest.
  EXPECT_GT(refused, tried / 5);
}

TEST_F(SnapshotFile, ZeroedSectorIsRefused) {
  for (std::size_t begin = 0; begin < bytes_.size(); begin += 512) {
    std::string spoilt = bytes_;
    for (std::size_t i = begin; i < std::min(begin + 512, bytes_.size()); ++i) spoilt[i] = 0;
    if (spoilt == bytes_) continue;  // nothing but zeros before
    ASSERT_EQ(read_back(spoilt), Outcome::refused) << "sector at " << begin;
  }
}

TEST_F(SnapshotFile, ForeignFilesAreRefused) {
  EXPECT_EQ(read_back(""), Outcome::refused);
  EXPECT_EQ(read_back("x,y,z\n1,2,3\n"), Outcome::refused);
  EXPECT_EQ(read_back(std::string(100000, '\0')), Outcome::refused);
  EXPECT_EQ(read_back(bytes_.substr(0, 8) + std::string(100000, 'x')), Outcome::refused);
}

TEST_F(SnapshotFile, RefusalPrintsNothing) {
  testing::internal::CaptureStderr();
  read_back(bytes_.substr(0, bytes_.size() / 2));
  EXPECT_THAT(testing::internal::GetCapturedStderr(), IsEmpty());
}

TEST_F(SnapshotFile, FullDiskIsAnErrorOfTheEnvironmentAndKeepsTheOldFile) {
  const Snapshot larger = random_snapshot(3000);
  {
    const test::FileSizeLimit limit(20000);
    EXPECT_THROW(write_snapshot(path_, larger), EnvironmentError);
  }
  EXPECT_THAT(differences(read_snapshot(path_), snapshot_), IsEmpty());
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.path()), {}), 1);
}

TEST_F(SnapshotFile, MissingFolderIsAnErrorOfTheEnvironment) {
  EXPECT_THROW(write_snapshot(folder_ / "no" / "such.hdf5", snapshot_), EnvironmentError);
}

}  // namespace
}  // namespace eerie::io
