#include "campaign/job_folder/log.hpp"

#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/rotating_file_sink.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include "campaign/text/plain_text.hpp"
#include "db/store/place.hpp"
#include "solver/base/error.hpp"

namespace eerie::job_folder {

namespace {

/// A message on one line.
class PlainMessage : public spdlog::custom_flag_formatter {
 public:
  void format(const spdlog::details::log_msg& message, const std::tm&,
              spdlog::memory_buf_t& line) override {
    const std::string plain = text::plain_text({message.payload.data(), message.payload.size()});
    line.append(plain.data(), plain.data() + plain.size());
  }
  std::unique_ptr<custom_flag_formatter> clone() const override {
    return std::make_unique<PlainMessage>();
  }
};

}  // namespace

std::unique_ptr<spdlog::formatter> log_formatter() {
  auto formatter = std::make_unique<spdlog::pattern_formatter>(spdlog::pattern_time_type::utc);
  formatter->add_flag<PlainMessage>('*').set_pattern("%Y-%m-%dT%H:%M:%S.%eZ %l %*");
  return formatter;
}

void open_log(const JobDirectory& directory) {
  require_file(directory.log());
  try {
    auto log = spdlog::basic_logger_mt("eerie", directory.log().string());
    log->set_formatter(log_formatter());
    log->flush_on(spdlog::level::info);
    spdlog::set_default_logger(std::move(log));
  } catch (const spdlog::spdlog_ex& error) {
    throw EnvironmentError(error.what());
  }
}

void open_campaign_log(const std::filesystem::path& database, spdlog::level::level_enum level) {
  constexpr std::size_t bytes = 10'000'000, files = 3;
  const std::string path = db::resolved(database).string() + ".log";
  require_file(path);
  try {
    std::vector<spdlog::sink_ptr> sinks = {
        std::make_shared<spdlog::sinks::rotating_file_sink_mt>(path, bytes, files)};
    sinks.push_back(std::make_shared<spdlog::sinks::stderr_sink_mt>());
    sinks.back()->set_level(level);
    auto log = std::make_shared<spdlog::logger>("manager", sinks.begin(), sinks.end());
    log->set_formatter(log_formatter());
    log->flush_on(spdlog::level::info);
    // A full disk must not fill standard error as well.
    log->set_error_handler([](const std::string&) {});
    spdlog::set_default_logger(std::move(log));
  } catch (const spdlog::spdlog_ex& error) {
    throw EnvironmentError(error.what());
  }
}

}  // namespace eerie::job_folder
