#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "campaign/cli/options/options.hpp"
#include "campaign/manager/waiting/news.hpp"

namespace eerie::cli {

/// --notify PROGRAM: who is told how a campaign goes.
struct NoticeArguments {
  std::string program;
};
std::shared_ptr<NoticeArguments> add_notify(CLI::App& app);

/// The action, and then the news of its end: "ended", "failed" (some job, or all of it), or
/// "stopped". `database` lives as long as the action.
Action with_news_of_end(Action action, std::shared_ptr<NoticeArguments> arguments,
                        const std::filesystem::path& database);

/// Tells when a daemon has nothing left to do: "idle", or "failed" where jobs have failed since
/// the last time.
class IdleNews {
 public:
  IdleNews(const NoticeArguments& arguments, std::filesystem::path database)
      : arguments_(arguments), database_(std::move(database)) {}
  void look(const manager::CampaignView& view);

 private:
  NoticeArguments arguments_;
  std::filesystem::path database_;
  manager::Idleness idleness_;
};

}  // namespace eerie::cli
