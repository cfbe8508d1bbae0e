#include "campaign/cli/running/notices.hpp"

#include "campaign/process/hook.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;
using manager::News;

namespace {

void tell(const NoticeArguments& arguments, const fs::path& database, const News& news) {
  const std::string problem = manager::tell(arguments.program, database, news);
  if (!problem.empty()) complain("eerie: --notify could not be told: " + problem);
}

News news_of(const Answer& answer) {
  News news;
  news.event = answer.exit_code == 0                   ? "ended"
               : answer.exit_code == stopped_by_signal ? "stopped"
                                                       : "failed";
  if (!answer.data.is_object()) return news;
  news.sweep = answer.data.value("sweep", "");
  if (answer.data.contains("jobs")) news.jobs = manager::tally_of(answer.data.at("jobs"));
  return news;
}

}  // namespace

std::shared_ptr<NoticeArguments> add_notify(CLI::App& app) {
  auto a = std::make_shared<NoticeArguments>();
  app.add_option("--notify", a->program,
                 "program to run when the campaign ends, idles, fails or is stopped; the event is "
                 "its argument, facts are in its environment (EERIE_...)");
  return a;
}

Action with_news_of_end(Action action, std::shared_ptr<NoticeArguments> arguments,
                        const fs::path& database) {
  return [action = std::move(action), arguments = std::move(arguments), &database](Output& out) {
    const process::Hook there_is_one(arguments->program);
    try {
      Answer answer = action(out);
      tell(*arguments, database, news_of(answer));
      return answer;
    } catch (const std::exception& error) {
      tell(*arguments, database, {.event = "failed", .message = error.what()});
      throw;
    }
  };
}

void IdleNews::look(const manager::CampaignView& view) {
  if (const auto moment = idleness_.look(view))
    tell(arguments_, database_, manager::news_of(*moment, view));
}

}  // namespace eerie::cli
