#include "campaign/job_folder/provenance.hpp"

#include <unistd.h>

#include <array>
#include <nlohmann/json.hpp>

#include "generated_commit.hpp"
#include "solver/base/version.hpp"

namespace eerie::job_folder {

Provenance provenance() {
#if defined(__clang__)
  const std::string compiler = std::string("clang++ ") + __clang_version__;
#else
  const std::string compiler = std::string("g++ ") + __VERSION__;
#endif
  return {EERIE_VERSION, solver_version, EERIE_COMMIT, compiler, EERIE_FLAGS, host_name()};
}

nlohmann::json to_json(const Provenance& p) {
  return {{"version", p.version}, {"solver_version", p.solver_version},
          {"commit", p.commit},   {"compiler", p.compiler},
          {"flags", p.flags},     {"host", p.host}};
}

std::string host_name() {
  std::array<char, 256> name{};
  if (::gethostname(name.data(), name.size() - 1) != 0) return "unknown";
  return name.data();
}

}  // namespace eerie::job_folder
