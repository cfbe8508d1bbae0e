#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/paths.hpp"

namespace eerie::io {
namespace {

using testing::HasSubstr;

std::string refusal_of(const std::filesystem::path& path) {
  try {
    read_snapshot(path);
    return "it was read";
  } catch (const InputError& error) {
    return error.what();
  }
}

long most_memory_kb() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

/// Files that h5py makes of a sound one.
class ForeignSnapshot : public testing::Test {
 protected:
  ForeignSnapshot() {
    write_snapshot(folder_ / "sound.hdf5", test::random_snapshot(150));
    const std::string command = "/usr/bin/python3 " +
                                (test::source_folder() / "tests/io/foreign_snapshots.py").string() +
                                " " + (folder_ / "sound.hdf5").string() + " " +
                                folder_.path().string() + " > " + (folder_ / "names").string();
    made_ = std::system(command.c_str()) == 0;
  }

  test::TemporaryFolder folder_;
  bool made_ = false;
};

TEST_F(ForeignSnapshot, ReachesNoOtherFileAndNoMemoryThatItCouldNotHold) {
  ASSERT_TRUE(made_);
  const std::map<std::string, std::string> reasons = {
      {"external_link", "link to elsewhere"},
      {"external_group", "link to elsewhere"},
      {"soft_link", "link to elsewhere"},
      {"external_storage", "from other files"},
      {"virtual_dataset", "from other files"},
      {"many_ids", "claims 1000000000000 rows"},
      {"overflowing_ids", "claims 4611686018427387904 rows"},
      {"compressed_ids", "expected 20000000"},
      {"large_chunks", "chunks larger than the file"}};
  std::istringstream names(read_file(folder_ / "names"));
  std::size_t count = 0;
  const long before = most_memory_kb();
  for (std::string name; names >> name; ++count)
    EXPECT_THAT(refusal_of(folder_ / (name + ".hdf5").c_str()), HasSubstr(reasons.at(name)))
        << name;
  EXPECT_EQ(count, reasons.size());
  EXPECT_LT(most_memory_kb() - before, 300'000);  // 20 million identities alone are 80 MB
}

TEST(SnapshotPath, IsARegularFileAndNothingThatOneWaitsFor) {
  const test::TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe.hdf5").c_str(), 0600), 0);
  EXPECT_THAT(refusal_of(folder / "pipe.hdf5"), HasSubstr("no regular file"));
  EXPECT_THAT(refusal_of("/dev/zero"), HasSubstr("no regular file"));
  EXPECT_THROW(snapshot_time(folder / "pipe.hdf5"), InputError);
  std::filesystem::create_symlink("pipe.hdf5", folder / "link.hdf5");
  EXPECT_THAT(refusal_of(folder / "link.hdf5"), HasSubstr("no regular file"));
  EXPECT_THROW(read_snapshot(folder.path()), EnvironmentError);
}

TEST(SnapshotPath, MayNotHoldMoreThanTheMachine) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "huge.hdf5") << "\x89HDF\r\n\x1a\n";
  std::filesystem::resize_file(folder / "huge.hdf5", std::uintmax_t{1} << 43);  // holes alone
  EXPECT_THAT(refusal_of(folder / "huge.hdf5"), HasSubstr("more than the memory"));
}

}  // namespace
}  // namespace eerie::io
