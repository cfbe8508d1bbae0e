#include "campaign/cli/output/campaign_watch.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace eerie::cli {
namespace {

std::string text(const manager::Split& split) {
  return fmt::format("{} job{} x {} thread{}", split.jobs, split.jobs == 1 ? "" : "s",
                     split.threads, split.threads == 1 ? "" : "s");
}

}  // namespace

void CampaignWatch::measured(std::span<const manager::Split> splits) {
  if (quiet_) return;
  fmt::print("{}:", text(splits.front()));
  for (const manager::Split& split : splits)
    fmt::print("{} {:.3g} M particle-steps/s",
               &split == &splits.front() ? "" : fmt::format("; {}", text(split)),
               split.particle_steps_per_s / 1e6);
  fmt::print(" (measured; --workers and --threads-per-job decide otherwise)\n");
  std::fflush(stdout);
}

void CampaignWatch::begins(std::size_t runs, std::size_t known, std::size_t left) {
  if (quiet_) return;
  fmt::print("{}: {} runs within the budget, {}{} to run\n", name_, runs,
             known > 0 ? fmt::format("{} known, ", known) : "", left);
  std::fflush(stdout);
}

void CampaignWatch::begins(const auto_fidelity::AutoRound& round,
                           const auto_fidelity::AutoFidelity& campaign) {
  if (quiet_) return;
  fmt::print(
      "round {}: {} of {} impacts in doubt; {} sketches and {} surveys wanted, {} to run; {:.2f} "
      "core-hours so far\n",
      round.number, auto_fidelity::doubtful(campaign), campaign.cells().size(), round.sketches,
      round.surveys, round.left, auto_fidelity::spent_core_hours(campaign));
  std::fflush(stdout);
}

}  // namespace eerie::cli
