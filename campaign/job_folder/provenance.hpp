#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace eerie::job_folder {

/// Where a result comes from: program, build and machine.
struct Provenance {
  std::string version;         ///< of eerie, "0.1.0"
  std::string solver_version;  ///< solver/base/version.hpp
  std::string commit;          ///< git commit of the build; "+" behind it: with uncommitted changes
  std::string compiler;        ///< "g++ 12.2.0"
  std::string flags;           ///< that decide the numbers
  std::string host;
};

Provenance provenance();
nlohmann::json to_json(const Provenance& provenance);

std::string host_name();

}  // namespace eerie::job_folder
