#include <gtest/gtest.h>

#include "solver/base/file.hpp"
#include "tests/fuzz/readers.hpp"
#include "tests/support/paths.hpp"

namespace eerie {
namespace {
namespace fs = std::filesystem;

/// What fuzzers start from and what they once found, without a fuzzer.
struct Corpus {
  const char* folder;
  void (*read)(std::string_view bytes);
};
constexpr Corpus corpora[] = {{"sweep", fuzz::read_as_sweep},
                              {"scene", fuzz::read_as_scene},
                              {"result", fuzz::read_as_result},
                              {"checkpoint", fuzz::read_as_checkpoint},
                              {"catalogue", fuzz::read_as_catalogue}};

TEST(FuzzCorpus, IsReadOrRefused) {
  for (const Corpus& corpus : corpora) {
    int files = 0;
    for (const auto& entry :
         fs::directory_iterator(test::source_folder() / "tests/fuzz/corpus" / corpus.folder)) {
      SCOPED_TRACE(entry.path().string());
      corpus.read(read_file(entry.path()));
      ++files;
    }
    EXPECT_GE(files, 3) << corpus.folder;
  }
}

}  // namespace
}  // namespace eerie
