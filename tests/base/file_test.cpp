#include "solver/base/file.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include "solver/base/error.hpp"
#include "solver/base/files/folders.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/file_size_limit.hpp"

namespace eerie {
namespace {
using testing::HasSubstr;
namespace fs = std::filesystem;

class AFile : public testing::Test {
 protected:
  /// Everything in the folder that is no temporary file would be one too many.
  std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()));
  }
  static void write(const fs::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
  }
  test::TemporaryFolder folder;
};

TEST_F(AFile, ThroughALinkReplacesTheFileBehindItAndKeepsTheLink) {
  fs::create_directory(folder / "far");
  write(folder / "far/target", "old");
  fs::create_symlink("far/target", folder / "second");
  fs::create_symlink(folder / "second", folder / "first");
  install_text(folder / "first", "new");
  EXPECT_EQ(read_file(folder / "far/target"), "new");
  EXPECT_EQ(fs::read_symlink(folder / "first"), folder / "second");
  EXPECT_EQ(fs::read_symlink(folder / "second"), "far/target");
  EXPECT_EQ(files(), 3u);
}

TEST_F(AFile, ThroughALinkToNothingIsMadeWhereTheLinkPoints) {
  fs::create_symlink("target", folder / "link");
  install_text(folder / "link", "new");
  EXPECT_EQ(read_file(folder / "target"), "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
}

TEST_F(AFile, ThroughLinksInACircleIsRefused) {
  fs::create_symlink("a", folder / "b");
  fs::create_symlink("b", folder / "a");
  EXPECT_THROW(install_text(folder / "a", "new"), EnvironmentError);
  EXPECT_EQ(files(), 2u);
}

TEST_F(AFile, KeepsItsPermissionsWhenItIsReplaced) {
  write(folder / "secret", "old");
  fs::permissions(folder / "secret", fs::perms::owner_read | fs::perms::owner_write);
  install_text(folder / "secret", "new");
  EXPECT_EQ(fs::status(folder / "secret").permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(AFile, ThatIsANamedPipeIsWrittenIntoAndStays) {
  const fs::path pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::string seen;
  std::thread reader([&] { seen = read_file(pipe); });
  install_text(pipe, std::string(200'000, 'x'));
  reader.join();
  EXPECT_EQ(seen, std::string(200'000, 'x'));
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_EQ(files(), 1u);
}

TEST_F(AFile, ThatIsADeviceIsWrittenIntoAndStays) {
  const fs::path device = folder / "null";
  if (::mknod(device.c_str(), S_IFCHR | 0666, makedev(1, 3)) != 0)
    GTEST_SKIP() << "only root may make devices";
  if (const int opened = ::open(device.c_str(), O_WRONLY | O_CLOEXEC); opened < 0)
    GTEST_SKIP() << "this disk lets nobody use devices";
  else
    ::close(opened);
  install_text(device, "gone");
  EXPECT_TRUE(fs::is_character_file(device));
  EXPECT_EQ(files(), 1u);
}

TEST_F(AFile, ThatIsAnOpenDescriptorIsWrittenWhereItStands) {
  const fs::path log = folder / "log";
  const int descriptor = ::open(log.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  ASSERT_EQ(::write(descriptor, "first ", 6), 6);
  install_text("/dev/fd/" + std::to_string(descriptor), "second");
  ASSERT_EQ(::write(descriptor, " third", 6), 6);
  ::close(descriptor);
  EXPECT_EQ(read_file(log), "first second third");
}

TEST_F(AFile, ThatCannotBeMadeIsNamedAsItWasAskedFor) {
  try {
    install_text(folder / "missing/result.csv", "1\n");
    FAIL() << "made a file in a folder that is not there";
  } catch (const EnvironmentError& error) {
    EXPECT_THAT(error.what(), HasSubstr((folder / "missing/result.csv").string() + ": No such"));
  }
}

TEST_F(AFile, ThatIsAddedToKeepsWhatItHas) {
  write(folder / "log", "one\n");
  append_text(folder / "log", "two\n");
  flush_file(folder / "log");
  EXPECT_EQ(read_file(folder / "log"), "one\ntwo\n");
  EXPECT_THROW(append_text(folder / "missing", "two\n"), EnvironmentError);
  EXPECT_THROW(flush_file(folder / "missing"), EnvironmentError);
  EXPECT_EQ(files(), 1u);
}

TEST_F(AFile, ThatFindsNoRoomForAnAdditionIsAsItWas) {
  write(folder / "log", "one\n");
  const std::string much(20000, 'x');
  {
    const test::FileSizeLimit limit(10000);
    EXPECT_THROW(append_text(folder / "log", much), EnvironmentError);
  }
  EXPECT_EQ(read_file(folder / "log"), "one\n");
}

TEST_F(AFile, ThatIsShownReplacesTheOneBefore) {
  write(folder / "progress", "old");
  show_text(folder / "progress", "new");
  EXPECT_EQ(read_file(folder / "progress"), "new");
  {
    const test::FileSizeLimit limit(100);
    EXPECT_THROW(show_text(folder / "progress", std::string(20000, 'x')), EnvironmentError);
  }
  EXPECT_EQ(read_file(folder / "progress"), "new");
  EXPECT_EQ(files(), 1u);
}

TEST_F(AFile, ThatIsAFolderIsRefused) {
  fs::create_directory(folder / "f");
  EXPECT_THROW(install_text(folder / "f", "new"), EnvironmentError);
  EXPECT_TRUE(fs::is_directory(folder / "f"));
}

TEST_F(AFile, MakesFoldersWithThoseAboveAndTellsWhereItCannot) {
  make_folders(folder / "a/b/c/");
  EXPECT_TRUE(fs::is_directory(folder / "a/b/c"));
  make_folders(folder / "a/b/c");
  write(folder / "file", "");
  EXPECT_THROW(make_folders(folder / "file/below"), EnvironmentError);
}

}  // namespace
}  // namespace eerie
