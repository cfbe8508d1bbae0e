#pragma once

#include "campaign/auto_fidelity/auto_run.hpp"
#include "campaign/cli/output/progress_line.hpp"
#include "campaign/studies/study_run.hpp"

namespace eerie::cli {

/// Shows a campaign at work: a progress line, and what begins unless it is to be quiet.
class CampaignWatch : public studies::StudyObserver, public auto_fidelity::AutoObserver {
 public:
  CampaignWatch(std::string name, bool quiet) : name_(std::move(name)), quiet_(quiet) {}

  void measured(std::span<const manager::Split> splits) override;
  void at_work(const manager::CampaignView& view) override { line_.show(view); }
  void begins(std::size_t runs, std::size_t known, std::size_t left) override;
  void begins(const auto_fidelity::AutoRound& round,
              const auto_fidelity::AutoFidelity& campaign) override;
  void finish() { line_.finish(); }

 private:
  std::string name_;
  bool quiet_;
  ProgressLine line_;
};

}  // namespace eerie::cli
