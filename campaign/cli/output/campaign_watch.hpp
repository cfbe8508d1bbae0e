#pragma once

#include "campaign/auto_fidelity/auto_run.hpp"
#include "campaign/cli/output/output.hpp"
#include "campaign/cli/output/progress_line.hpp"
#include "campaign/cli/output/status_line.hpp"
#include "campaign/studies/study_run.hpp"

namespace eerie::cli {

/// Shows a campaign at work: what begins, and the progress.
class CampaignWatch : public studies::StudyObserver, public auto_fidelity::AutoObserver {
 public:
  CampaignWatch(std::string name, Output& out)
      : name_(std::move(name)), out_(out), line_(out.format) {}
  ~CampaignWatch() override { line_.finish(); }

  void waits(const std::string& reason) override;
  void measured(std::span<const manager::Split> splits) override;
  void at_work(const manager::CampaignView& view) override;
  void begins(std::size_t runs, std::size_t known, std::size_t left) override;
  void begins(const auto_fidelity::AutoRound& round,
              const auto_fidelity::AutoFidelity& campaign) override;

 private:
  std::string name_;
  Output& out_;
  StatusLine line_;
};

/// Sets the exit code of a campaign by what is left of it, and complains where that is not 0. `how`
/// says from where the same command continues.
void conclude(Answer& answer, const manager::Tally& tally, const std::filesystem::path& database,
              const std::string& how = "");

}  // namespace eerie::cli
