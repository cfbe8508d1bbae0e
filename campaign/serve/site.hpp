#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "campaign/serve/cache.hpp"
#include "campaign/serve/events.hpp"
#include "campaign/serve/reply.hpp"

namespace eerie::serve {

/// The content of all addresses: the page, its files, and JSON of a database. Every request opens
/// its own connection, which cannot write.
class Site {
 public:
  Site(std::filesystem::path database, bool read_only, Events& events);

  /// Never throws. Errors become a reply {"error": ...}: 400 for what the address says, 404, and
  /// 503 where the database cannot be read.
  Reply answer(const std::string& path, const Parameters& parameters);

 private:
  Reply api(const std::string& name, const Parameters& parameters);
  Reply of_job(const std::string& address, const Parameters& parameters);
  Reply page_file(const std::string& name) const;

  std::filesystem::path database_;
  bool read_only_;
  Events& events_;
  Cache cache_;
};

}  // namespace eerie::serve
