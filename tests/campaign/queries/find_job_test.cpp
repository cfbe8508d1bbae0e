#include "campaign/queries/find_job.hpp"

#include <gtest/gtest.h>

#include "solver/base/error.hpp"

namespace eerie::queries {
namespace {

TEST(JobChoice, AsksWhichJobsAreMeantAndRefusesWhatIsNoHash) {
  JobChoice nothing;
  EXPECT_THROW(selection_of(nothing, "pause"), InputError);
  nothing.all = true;
  EXPECT_TRUE(selection_of(nothing, "pause").is_everything());
  for (const char* word : {"abc", "xyzw", "ABCD", "../../../etc", "' OR 1=1"}) {
    JobChoice one;
    one.jobs = {word};
    EXPECT_THROW(selection_of(one, "pause"), InputError) << word;
  }
}

}  // namespace
}  // namespace eerie::queries
