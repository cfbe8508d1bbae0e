#include "campaign/job_folder/log.hpp"

#include <gmock/gmock.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include <sstream>

namespace eerie::job_folder {
namespace {

TEST(Log, AMessageIsOneLineWhateverItQuotes) {
  std::ostringstream out;
  spdlog::logger log("test", std::make_shared<spdlog::sinks::ostream_sink_st>(out));
  log.set_formatter(log_formatter());
  log.info("scene {}: bad", "x\n2026-01-01T00:00:00.000 info all jobs are done\x1b[2J\r\xff");
  log.warn("second");
  const std::string text = out.str();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2);
  EXPECT_THAT(text, testing::HasSubstr("info scene x\\n2026-01-01T00:00:00.000 info all jobs are "
                                       "done\\x1b[2J\\r\ufffd: bad\n"));
  EXPECT_THAT(text, testing::EndsWith(" warning second\n"));
}

}  // namespace
}  // namespace eerie::job_folder
