#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace eerie::job_folder {

/// The program, build and machine behind a result.
struct Provenance {
  std::string version;         ///< of eerie, "1.0.0-rc1"
  std::string solver_version;  ///< solver/base/version.hpp
  std::string commit;          ///< git commit of the build, with "+" for uncommitted changes
  std::string compiler;        ///< "g++ 12.2.0"
  std::string flags;           ///< compiler flags that affect the numbers
  std::string host;
};

Provenance provenance();
nlohmann::json to_json(const Provenance& provenance);

std::string host_name();

}  // namespace eerie::job_folder
