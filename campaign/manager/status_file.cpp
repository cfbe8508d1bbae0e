#include "campaign/manager/status_file.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "campaign/job_folder/job_directory.hpp"
#include "campaign/text/json_file.hpp"
#include "campaign/text/json_text.hpp"
#include "db/store/place.hpp"

namespace eerie::manager {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {
fs::path status_path(const fs::path& database) {
  return db::resolved(database).string() + ".status.json";
}
}  // namespace

StatusFile::StatusFile(const fs::path& database) : path_(status_path(database)) {}

StatusFile::~StatusFile() {
  std::error_code ignored;
  fs::remove(path_, ignored);
}

void StatusFile::show(const CampaignView& view) {
  const auto now = std::chrono::steady_clock::now();
  if (now < next_) return;
  next_ = now + std::chrono::seconds(2);
  const std::string text = text::json_text({{"running", view.running},
                                            {"particle_steps_per_s", view.particle_steps_per_s},
                                            {"eta_s", view.eta_s},
                                            {"stopping", view.stopping},
                                            {"waiting_for", view.waiting_for}});
  if (text == written_) return;
  // Renamed, so that a reader sees it whole; not flushed, for it is worthless after a power cut.
  const fs::path temporary = path_.string() + ".tmp";
  std::ofstream(temporary) << text;
  std::error_code ignored;
  fs::rename(temporary, path_, ignored);
  written_ = text;
}

std::optional<CampaignView> read_status_file(const fs::path& database) {
  const auto document = job_folder::read_json(status_path(database));
  if (!document || !document->is_object()) return std::nullopt;
  CampaignView view;
  try {
    text::read_whole(document->at("running"), view.running);
    document->at("particle_steps_per_s").get_to(view.particle_steps_per_s);
    document->at("eta_s").get_to(view.eta_s);
    document->at("stopping").get_to(view.stopping);
    document->at("waiting_for").get_to(view.waiting_for);
  } catch (const json::exception&) {
    return std::nullopt;
  }
  return view;
}

}  // namespace eerie::manager
