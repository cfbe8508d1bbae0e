#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "campaign/cli/commands.hpp"
#include "campaign/cli/outcome_text.hpp"
#include "solver/base/error.hpp"

namespace eerie::cli {

int analyse(const AnalyseArguments& a) {
  const Snapshot snapshot = read_snapshot(a.snapshot);
  const Analysis analysis = eerie::analyse(snapshot);
  if (a.json) {
    nlohmann::json report = to_json(analysis);
    report["time_s"] = snapshot.state.time;
    report["scene"] = to_json(snapshot.scene);
    fmt::print("{}\n", report.dump(1));
  } else {
    fmt::print("{} at {:.6g} s\n{}", a.snapshot.string(), snapshot.state.time,
               outcome_text(analysis));
  }
  return static_cast<int>(ExitCode::done);
}

}  // namespace eerie::cli
