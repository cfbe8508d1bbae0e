#include "campaign/manager/inbox.hpp"

#include <fcntl.h>
#include <spdlog/spdlog.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <limits>
#include <thread>

#include "campaign/text/json_file.hpp"
#include "db/jobs/control.hpp"
#include "db/store/error.hpp"
#include "db/store/lock.hpp"
#include "db/store/place.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "solver/base/files/folders.hpp"
#include "solver/base/kill_point.hpp"

namespace eerie::manager {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr off_t most_bytes = 16 << 20;

/// The number with which a file's name begins: requests are carried out in its order. It counts
/// up, whatever the clock does.
std::optional<std::uint64_t> sequence_of(const fs::path& file) {
  constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max() / 2;
  const std::string name = file.filename();
  std::uint64_t number = 0;
  const auto [end, problem] = std::from_chars(name.data(), name.data() + name.size(), number);
  if (problem != std::errc() || number > most) return std::nullopt;
  return number;
}

std::uint64_t next_sequence(const fs::path& folder) {
  std::uint64_t newest = 0;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(folder, missing))
    newest = std::max(newest, sequence_of(entry.path()).value_or(0));
  return newest + 1;
}

/// Held while a request is given its number and put down, so that no two have one number. An
/// advisory lock that somebody keeps for long is done without.
class FolderLock {
 public:
  explicit FolderLock(const fs::path& folder)
      : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    for (int k = 0; k < 100 && descriptor_ >= 0; ++k) {
      if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }
  ~FolderLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

class OpenFile {
 public:
  explicit OpenFile(const fs::path& file)
      : descriptor_(::open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC)) {
    if (descriptor_ < 0) throw InputError(fmt::format("cannot be read: {}", std::strerror(errno)));
    ::fstat(descriptor_, &info_);
  }
  ~OpenFile() { ::close(descriptor_); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  const struct stat& info() const { return info_; }
  std::string content() const {
    std::string text(static_cast<std::size_t>(info_.st_size), '\0');
    const ssize_t length = ::pread(descriptor_, text.data(), text.size(), 0);
    if (length < 0) throw InputError(fmt::format("cannot be read: {}", std::strerror(errno)));
    text.resize(static_cast<std::size_t>(length));
    return text;
  }

 private:
  int descriptor_;
  struct stat info_ {};
};

/// Nobody else's word counts, though they may be able to write in the folder.
void require_authority(uid_t owner, const fs::path& database) {
  struct stat info {};
  const bool is_known = ::stat(database.c_str(), &info) == 0;
  if (owner == 0 || owner == ::geteuid() || (is_known && owner == info.st_uid)) return;
  throw InputError(fmt::format("it belongs to user {}, not to the database's owner", owner));
}

/// Its own name, or "NUMBER-ID.json".
bool is_named_after(const fs::path& file, const std::string& id) {
  const std::string stem = file.stem();
  if (stem == id) return true;
  const std::size_t digits = std::min(stem.find_first_not_of("0123456789"), stem.size());
  return digits > 0 && stem.substr(digits) == "-" + id;
}

Request read_request(const fs::path& file, const fs::path& database) {
  const OpenFile open(file);
  if (!S_ISREG(open.info().st_mode)) throw InputError("it is no file");
  require_authority(open.info().st_uid, database);
  if (open.info().st_size > most_bytes)
    throw InputError(fmt::format("{} bytes are more than the {} of any request",
                                 open.info().st_size, most_bytes));
  Request request = parse_request(text::parse_json(open.content(), "request"), "request");
  if (!is_named_after(file, request.id)) throw InputError("its id is not its name");
  return request;
}

/// A manager that has just begun may still be making the database.
std::optional<std::string> answer_in(const fs::path& database, const std::string& id) {
  try {
    return db::answer(db::Connection(database, db::Access::read_any), id);
  } catch (const db::Error&) {
    return std::nullopt;
  }
}

}  // namespace

Inbox::Inbox(const fs::path& database)
    : database_(db::resolved(database)), folder_(database_.string() + ".inbox") {}

void Inbox::put(const Request& request) const {
  make_folders(folder_);
  const FolderLock lock(folder_);
  install_text(folder_ / fmt::format("{:020d}-{}.json", next_sequence(folder_), request.id),
               to_json(request).dump() + "\n");
}

std::vector<fs::path> Inbox::waiting() const {
  std::vector<fs::path> found;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(folder_, missing)) {
    const std::string name = entry.path().filename();
    if (entry.path().extension() == ".json" && name.front() != '.' && !stuck_.contains(name))
      found.push_back(entry.path());
  }
  std::ranges::sort(found, {}, [](const fs::path& file) {
    constexpr auto last = std::numeric_limits<std::uint64_t>::max();
    return std::pair(sequence_of(file).value_or(last), file);
  });
  return found;
}

std::size_t Inbox::take(db::Connection& connection) const {
  std::size_t count = 0;
  for (const fs::path& file : waiting()) {
    if (const std::string why = refused(file, connection); !why.empty()) {
      set_aside(file, why);
      continue;
    }
    kill_point("inbox.before-remove");
    remove(file);
    ++count;
  }
  return count;
}

/// Carries one out, or says why not.
std::string Inbox::refused(const fs::path& file, db::Connection& connection) const {
  try {
    const Request request = read_request(file, database_);
    const json answer = apply(connection, request);
    // Also an answer that says no is kept, for whoever waits for it.
    db::once(connection, request.id, request.kind, [&](auto&) { return answer.dump(); });
    spdlog::info("event=request id={} kind={} answer={}", request.id, request.kind, answer.dump());
    return answer.contains("error") ? answer.at("error").get<std::string>() : "";
  } catch (const db::TemporaryError&) {
    throw;
  } catch (const db::GoneError&) {
    throw;
  } catch (const std::exception& error) {
    return error.what();
  }
}

void Inbox::remove(const fs::path& file) const {
  std::error_code problem;
  fs::remove(file, problem);
  if (!problem) return;
  // It is noted as carried out, and will not be again.
  stuck_.insert(file.filename());
  spdlog::warn("event=request-stays file={} reason=\"{}\"", file.string(), problem.message());
}

void Inbox::set_aside(const fs::path& file, const std::string& why) const {
  spdlog::warn("event=request-refused file={} reason=\"{}\"", file.string(), why);
  std::error_code problem;
  fs::rename(file, file.string() + ".refused", problem);
  if (problem) {
    stuck_.insert(file.filename());
    return;
  }
  try {
    install_text(file.string() + ".refused.reason", why + "\n");
  } catch (const EnvironmentError&) {  // the log has it too
  }
}

bool Inbox::is_empty() const { return waiting().empty(); }

std::optional<json> send(const fs::path& database, const Request& request,
                         std::chrono::milliseconds patience) {
  const auto deadline = std::chrono::steady_clock::now() + patience;
  const Inbox inbox(database);
  for (bool put = false;; put = true) {
    try {
      const db::Lock lock(database, std::chrono::milliseconds(0));
      db::Connection connection(database, db::Access::write);
      inbox.take(connection);  // also ours, where the one it was meant for has gone
      if (const auto text = db::answer(connection, request.id)) return json::parse(*text);
      return apply(connection, request);
    } catch (const db::LockedError&) {
      if (!put) inbox.put(request);
    }
    if (const auto text = answer_in(database, request.id)) return json::parse(*text);
    if (std::chrono::steady_clock::now() > deadline) return std::nullopt;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

}  // namespace eerie::manager
