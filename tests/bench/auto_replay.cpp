// What `run --fidelity auto` would have cost and said, from results that a database has already:
// its rounds are replayed in an empty database, to which each run that it asks for is copied. Draws
// the map beside OUT.csv, where there is one only.
// Usage: eerie_auto_replay SWEEP DATABASE OUT.csv [CONFIDENCE]

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "campaign/auto_fidelity/auto_fidelity.hpp"
#include "campaign/auto_fidelity/auto_map.hpp"
#include "campaign/sweeps/fidelity.hpp"
#include "campaign/sweeps/job.hpp"
#include "campaign/text/json_file.hpp"
#include "db/jobs/jobs.hpp"
#include "db/views/query.hpp"
#include "solver/base/file.hpp"

namespace eerie {
namespace {
using namespace auto_fidelity;
using namespace sweeps;
using namespace diagrams;
namespace fs = std::filesystem;

/// Copies the result of a scene, where `from` has one.
bool copy(const db::Connection& from, const std::map<std::string, db::ResultRow>& known,
          db::Connection& to, const Scene& scene) {
  const db::NewJob job = new_job(scene);
  const db::AddedSweep added = db::add_sweep(to, job.hash, "{}", std::vector{job});
  const auto found = known.find(job.hash);
  if (added.added == 0 || found == known.end()) return false;
  const std::int64_t id = db::jobs(to, {added.sweep}).front().id;
  db::AttemptEnd end;
  end.reason = db::ExitReason::finished;
  end.core_seconds = db::core_seconds(from, found->second.job);
  db::begin_attempts(to, std::vector{db::Start{id, "replay", "", "replay"}});
  db::finish(to, id, end, found->second.result, db::remnants(from, found->second.job));
  return true;
}

int replay(int argc, char** argv) {
  AutoOptions options;
  if (argc > 4) options.confidence = std::stod(argv[4]);
  AutoFidelity campaign(ladder(text::load_json(argv[1]), {}, argv[1]), options);
  const db::Connection from(argv[2], db::Access::read);
  std::map<std::string, db::ResultRow> known;
  for (db::ResultRow& row : db::results(from, {})) known.emplace(row.hash, std::move(row));
  const fs::path scratch = fs::temp_directory_path() / fmt::format("replay-{}.sqlite", ::getpid());
  {
    db::Connection to(scratch, db::Access::write);
    std::size_t missing = 0;
    for (bool going = true; going;) {
      campaign.update(to);
      going = false, missing = 0;
      for (const Wanted& run : campaign.next()) {
        const bool copied = copy(from, known, to, run.scene);
        going = going || copied;
        missing += !copied;
      }
    }
    install_text(argv[3], auto_csv(campaign));
    const std::vector<PhaseDiagram> maps = phase_diagrams(campaign);
    if (maps.size() == 1)
      draw_phase_diagram(fs::path(argv[3]).replace_extension(".svg"), maps.front());
    double spent = 0;
    for (std::size_t r = 0; r < campaign.rungs().size(); ++r) {
      const double seconds = campaign.core_seconds()[r];
      fmt::print("{}: {:.0f} core-s\n", campaign.rungs()[r].name, seconds);
      spent += seconds;
    }
    std::size_t doubts = 0;
    for (const AutoCell& cell : campaign.cells()) doubts += campaign.in_doubt(cell);
    fmt::print("all: {:.0f} core-s; {} of {} impacts in doubt; {} runs asked for are not there\n",
               spent, doubts, campaign.cells().size(), missing);
    for (std::size_t r = 0; r + 1 < campaign.rungs().size(); ++r)
      for (const std::string& name : campaign.classes(r))
        fmt::print("{}: {} is {:+.3f} +- {:.3f} in b/a from {}\n", name,
                   campaign.rungs()[r + 1].name, campaign.transfer(r, name).shift,
                   campaign.transfer(r, name).scatter, campaign.rungs()[r].name);
  }
  for (const char* end : {"", "-wal", "-shm"}) fs::remove(scratch.string() + end);
  return 0;
}

}  // namespace
}  // namespace eerie

int main(int argc, char** argv) {
  if (argc < 4) {
    fmt::print(stderr, "usage: eerie_auto_replay SWEEP DATABASE OUT.csv [CONFIDENCE]\n");
    return 2;
  }
  return eerie::replay(argc, argv);
}
