#include "campaign/cli/output/campaign_watch.hpp"

#include "campaign/cli/output/complain.hpp"
#include "solver/base/text/shell_word.hpp"

namespace eerie::cli {
namespace {

std::string text(const manager::Split& split) {
  return count_of(split.jobs, "job") + " x " +
         count_of(static_cast<std::size_t>(split.threads), "thread");
}

}  // namespace

void CampaignWatch::waits(const std::string& reason) { complain(reason); }

void CampaignWatch::measured(std::span<const manager::Split> splits) {
  std::string speeds;
  for (const manager::Split& split : splits)
    speeds += fmt::format("{} {:.3g} M particle-steps/s",
                          &split == &splits.front() ? "" : "; " + text(split),
                          split.particle_steps_per_s / 1e6);
  out_.say("{}:{} (measured; --workers and --threads-per-job decide otherwise)\n",
           text(splits.front()), speeds);
}

void CampaignWatch::at_work(const manager::CampaignView& view) {
  line_.show([&](std::size_t width, bool on_terminal) {
    return progress_fitting(view, width, on_terminal);
  });
}

void CampaignWatch::begins(std::size_t runs, std::size_t known, std::size_t left) {
  out_.say("{}: {} runs within the budget, {}{} to run\n", name_, runs,
           known > 0 ? fmt::format("{} known, ", known) : "", left);
}

void CampaignWatch::begins(const auto_fidelity::AutoRound& round,
                           const auto_fidelity::AutoFidelity& campaign) {
  std::string wanted;
  for (std::size_t r = 0; r < round.wanted.size(); ++r)
    if (round.wanted[r] > 0)
      wanted += fmt::format("{}{} {}", wanted.empty() ? "" : ", ", round.wanted[r],
                            campaign.rungs()[r].name);
  out_.say("round {}: {} of {} impacts in doubt; wanted: {}; {} to run; {:.2f} core-hours so far\n",
           round.number, auto_fidelity::doubtful(campaign), campaign.cells().size(), wanted,
           round.left, auto_fidelity::spent_core_hours(campaign));
}

void conclude(Answer& answer, const manager::Tally& t, const std::filesystem::path& database,
              const std::string& how) {
  answer.exit_code = static_cast<int>(t.failed > 0 ? ExitCode::job_failed : ExitCode::done);
  if (t.left > t.paused) {
    answer.complain("stopped; the same command goes on{}", how);
    answer.exit_code = stopped_by_signal;
  } else if (t.paused > 0) {
    answer.complain("{} jobs are paused; `eerie resume --all --db {}` lets them go on", t.paused,
                    shell_word(database.string()));
  }
}

}  // namespace eerie::cli
