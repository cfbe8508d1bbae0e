#pragma once

#include <filesystem>
#include <memory>
#include <string>

namespace eerie::serve {

struct DashboardOptions {
  std::filesystem::path database;
  int port = 8765;           ///< 0: any free port
  std::string address = {};  ///< address to listen on; empty: 127.0.0.1
  bool read_only = false;
};

/// The dashboard of a database. It serves in its own threads for as long as it lives.
class Dashboard {
 public:
  /// Throws EnvironmentError where the port is not available, and db::Error where the database is
  /// not.
  explicit Dashboard(const DashboardOptions& options);
  ~Dashboard();
  Dashboard(const Dashboard&) = delete;
  Dashboard& operator=(const Dashboard&) = delete;

  /// The address, with the token after #, which browsers do not send.
  std::string address() const;
  int port() const;
  const std::string& token() const;

 private:
  class Running;
  std::unique_ptr<Running> running_;
};

}  // namespace eerie::serve
