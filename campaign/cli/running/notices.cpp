#include "campaign/cli/running/notices.hpp"

#include <fmt/format.h>

#include "campaign/process/hook.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;

namespace {

void tell(const NoticeArguments& arguments, const std::string& event, const fs::path& database,
          process::Hook::Facts facts) {
  facts.insert(facts.begin(),
               {{"EERIE_EVENT", event},
                {"EERIE_DATABASE", database.empty() ? "" : fs::absolute(database).string()}});
  const std::string problem = process::Hook(arguments.program).tell(event, facts);
  if (!problem.empty()) complain("eerie: --notify could not be told: " + problem);
}

std::string event_of(const Answer& answer) {
  return answer.exit_code == 0                   ? "ended"
         : answer.exit_code == stopped_by_signal ? "stopped"
                                                 : "failed";
}

process::Hook::Facts facts_of(const Answer& answer) {
  process::Hook::Facts facts;
  if (!answer.data.is_object()) return facts;
  if (answer.data.contains("sweep"))
    facts.emplace_back("EERIE_SWEEP", answer.data.at("sweep").get<std::string>());
  if (!answer.data.contains("jobs")) return facts;
  const nlohmann::json& jobs = answer.data.at("jobs");
  for (const auto& [name, key] :
       {std::pair("EERIE_JOBS", "total"), std::pair("EERIE_DONE", "done"),
        std::pair("EERIE_FAILED", "failed"), std::pair("EERIE_LEFT", "left")})
    if (jobs.is_object() && jobs.contains(key)) facts.emplace_back(name, jobs.at(key).dump());
  return facts;
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
      tell(*arguments, event_of(answer), database, facts_of(answer));
      return answer;
    } catch (const std::exception& error) {
      tell(*arguments, "failed", database, {{"EERIE_MESSAGE", error.what()}});
      throw;
    }
  };
}

IdleNews::IdleNews(const NoticeArguments& arguments, fs::path database)
    : arguments_(arguments), database_(std::move(database)) {}

void IdleNews::look(const manager::CampaignView& view) {
  const auto moment = idleness_.look(view);
  if (!moment) return;
  tell(arguments_, *moment == manager::Idleness::Moment::idle ? "idle" : "failed", database_,
       {{"EERIE_JOBS", fmt::format("{}", view.total)},
        {"EERIE_DONE", fmt::format("{}", view.done)},
        {"EERIE_FAILED", fmt::format("{}", view.failed)},
        {"EERIE_LEFT", fmt::format("{}", view.paused)}});
}

}  // namespace eerie::cli
