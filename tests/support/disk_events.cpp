// A tracer of the system calls that change files: ptrace, with a seccomp filter so that only these
// stop the program. Changes are noted as they begin, flushes as they end: a state that is built
// from the events never holds more on the disk than it could.

#include "tests/support/disk_events.hpp"

#ifdef __x86_64__

#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/user.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstddef>
#include <fstream>
#include <map>
#include <optional>
#include <stdexcept>

#include "solver/base/file.hpp"

namespace eerie::test {
namespace fs = std::filesystem;

namespace {

constexpr long traced_calls[] = {
    SYS_open,      SYS_openat,   SYS_creat,     SYS_write,     SYS_pwrite64,       SYS_writev,
    SYS_pwritev,   SYS_pwritev2, SYS_ftruncate, SYS_truncate,  SYS_fallocate,      SYS_fsync,
    SYS_fdatasync, SYS_rename,   SYS_renameat,  SYS_renameat2, SYS_unlink,         SYS_unlinkat,
    SYS_mkdir,     SYS_mkdirat,  SYS_rmdir,     SYS_sendfile,  SYS_copy_file_range};

/// Lets the calls above stop in the tracer and all others pass.
void install_filter() {
  std::vector<sock_filter> program = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr))};
  for (const long call : traced_calls) {
    program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<unsigned>(call), 0, 1));
    program.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_TRACE));
  }
  program.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
  const sock_fprog filter{static_cast<unsigned short>(program.size()), program.data()};
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 ||
      ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) != 0)
    ::_exit(125);
}

pid_t start_traced(const fs::path& folder, const std::string& script) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  if (::chdir(folder.c_str()) != 0 || ::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0)
    ::_exit(126);
  ::raise(SIGSTOP);
  install_filter();
  ::execl("/bin/sh", "sh", "-c", script.c_str(), static_cast<char*>(nullptr));
  ::_exit(127);
}

/// A traced thread at a system call.
class Call {
 public:
  explicit Call(pid_t thread) : thread_(thread) {
    ::ptrace(PTRACE_GETREGS, thread, nullptr, &registers_);
  }
  long number() const { return static_cast<long>(registers_.orig_rax); }
  long result() const { return static_cast<long>(registers_.rax); }
  std::uint64_t argument(int n) const {
    const auto& r = registers_;
    const unsigned long long all[] = {r.rdi, r.rsi, r.rdx, r.r10, r.r8, r.r9};
    return all[n];
  }
  std::string memory(std::uint64_t address, std::size_t size) const {
    std::string bytes(size, '\0');
    const iovec here{bytes.data(), size}, there{reinterpret_cast<void*>(address), size};
    const ssize_t got = ::process_vm_readv(thread_, &here, 1, &there, 1, 0);
    bytes.resize(got < 0 ? 0 : static_cast<std::size_t>(got));
    return bytes;
  }
  std::string text(std::uint64_t address) const {
    std::string all;
    while (all.size() < 4096) {
      const std::uint64_t page_left = 4096 - (address + all.size()) % 4096;
      const std::string part = memory(address + all.size(), page_left);
      const std::size_t end = part.find('\0');
      all += part.substr(0, end);
      if (part.empty() || end != std::string::npos) break;
    }
    return all;
  }
  fs::path of_process(const std::string& name) const {
    return "/proc/" + std::to_string(thread_) + "/" + name;
  }
  fs::path file_of(long descriptor) const {
    std::error_code ignored;
    return fs::read_symlink(of_process("fd/" + std::to_string(descriptor)), ignored);
  }
  /// `directory`: AT_FDCWD or the descriptor of a folder.
  fs::path path(long directory, std::uint64_t address) const {
    const fs::path given = text(address);
    std::error_code ignored;
    const fs::path base = static_cast<int>(directory) == AT_FDCWD
                              ? fs::read_symlink(of_process("cwd"), ignored)
                              : file_of(directory);
    return (base / given).lexically_normal();
  }

 private:
  pid_t thread_;
  user_regs_struct registers_{};
};

std::optional<struct stat> status_of(const fs::path& path) {
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0) return std::nullopt;
  return info;
}

class Recorder {
 public:
  explicit Recorder(const fs::path& folder) : folder_(fs::canonical(folder)) {}

  void begins(const Call& call);
  void ends(const Call& call);
  static bool matters_at_its_end(long number) {
    return number == SYS_open || number == SYS_openat || number == SYS_creat ||
           number == SYS_fsync || number == SYS_fdatasync || number == SYS_sendfile ||
           number == SYS_copy_file_range;
  }
  std::vector<DiskEvent> events;

 private:
  using Kind = DiskEvent::Kind;

  bool is_ours(const fs::path& path) const {
    return path.string().starts_with(folder_.string() + "/");
  }

  void note_path(Kind kind, const fs::path& path, const fs::path& target = {}) {
    if (is_ours(path)) events.push_back({.kind = kind, .path = path, .target = target});
  }
  void note_write(const Call& call, long descriptor, std::optional<std::int64_t> at,
                  std::string bytes);
  void note_vector(const Call& call, bool has_offset);
  void note_opened(const Call& call);
  void note_synced(const Call& call);
  void note_copied(const Call& call, long descriptor);
  void note_resized(const Call& call, long descriptor, std::int64_t size);

  fs::path folder_;
};

/// Where the next write() of a descriptor goes.
std::int64_t position(const Call& call, long descriptor, const struct stat& info) {
  std::ifstream in(call.of_process("fdinfo/" + std::to_string(descriptor)));
  std::string word;
  std::int64_t at = 0;
  long flags = 0;
  in >> word >> at >> word >> std::oct >> flags;
  return (flags & O_APPEND) != 0 ? info.st_size : at;
}

void Recorder::note_write(const Call& call, long descriptor, std::optional<std::int64_t> at,
                          std::string bytes) {
  const fs::path file = call.file_of(descriptor);
  if (!is_ours(file)) return;
  const auto info = status_of(call.of_process("fd/" + std::to_string(descriptor)));
  if (!info || !S_ISREG(info->st_mode)) return;
  if (file.filename() == "said") return events.push_back({.kind = Kind::say, .bytes = bytes});
  events.push_back({.kind = Kind::write,
                    .path = file,
                    .inode = info->st_ino,
                    .offset = at ? *at : position(call, descriptor, *info),
                    .bytes = std::move(bytes)});
}

void Recorder::note_vector(const Call& call, bool has_offset) {
  const std::string list = call.memory(call.argument(1), call.argument(2) * sizeof(iovec));
  std::string bytes;
  for (std::size_t at = 0; at + sizeof(iovec) <= list.size(); at += sizeof(iovec)) {
    iovec part;
    list.copy(reinterpret_cast<char*>(&part), sizeof part, at);
    bytes += call.memory(reinterpret_cast<std::uint64_t>(part.iov_base), part.iov_len);
  }
  note_write(call, static_cast<long>(call.argument(0)),
             has_offset ? std::optional(static_cast<std::int64_t>(call.argument(3))) : std::nullopt,
             std::move(bytes));
}

void Recorder::note_resized(const Call& call, long descriptor, std::int64_t size) {
  const auto info = status_of(call.of_process("fd/" + std::to_string(descriptor)));
  if (info && S_ISREG(info->st_mode) && is_ours(call.file_of(descriptor)))
    events.push_back({.kind = Kind::resize,
                      .path = call.file_of(descriptor),
                      .inode = info->st_ino,
                      .size = size});
}

/// The whole file anew: a call that copies inside the kernel shows us no bytes.
void Recorder::note_copied(const Call& call, long descriptor) {
  const fs::path file = call.of_process("fd/" + std::to_string(descriptor));
  const auto info = status_of(file);
  if (info && S_ISREG(info->st_mode) && is_ours(call.file_of(descriptor)))
    events.push_back({.kind = Kind::write,
                      .path = call.file_of(descriptor),
                      .inode = info->st_ino,
                      .bytes = read_file(call.file_of(descriptor))});
}

void Recorder::note_opened(const Call& call) {
  if (call.result() < 0) return;
  const bool at = call.number() == SYS_openat;
  const auto flags =
      call.number() == SYS_creat ? O_CREAT | O_TRUNC : static_cast<int>(call.argument(at ? 2 : 1));
  const auto info = status_of(call.of_process("fd/" + std::to_string(call.result())));
  const fs::path file = call.file_of(call.result());
  if ((flags & (O_CREAT | O_TRUNC)) == 0 || !info || !S_ISREG(info->st_mode) || !is_ours(file) ||
      file.filename() == "said")
    return;
  events.push_back({.kind = Kind::make_file,
                    .path = file,
                    .inode = info->st_ino,
                    .size = (flags & O_TRUNC) != 0 ? 0 : -1});
}

void Recorder::note_synced(const Call& call) {
  if (call.result() != 0) return;
  const auto descriptor = static_cast<long>(call.argument(0));
  const auto info = status_of(call.of_process("fd/" + std::to_string(descriptor)));
  const fs::path file = call.file_of(descriptor);
  if (!info || !(is_ours(file) || file == folder_)) return;
  events.push_back({.kind = S_ISDIR(info->st_mode) ? Kind::sync_folder : Kind::sync,
                    .path = file,
                    .inode = info->st_ino});
}

void Recorder::begins(const Call& call) {
  const auto a = [&](int n) { return call.argument(n); };
  const auto d = [&](int n) { return static_cast<long>(call.argument(n)); };
  std::error_code ignored;
  const auto rename = [&](const fs::path& from, const fs::path& to) {
    if (fs::exists(fs::symlink_status(from, ignored))) note_path(Kind::rename, from, to);
  };
  const auto remove = [&](const fs::path& path) {
    if (fs::exists(fs::symlink_status(path, ignored))) note_path(Kind::remove, path);
  };
  const auto make = [&](const fs::path& path) {
    if (!fs::exists(path, ignored)) note_path(Kind::make_folder, path);
  };
  switch (call.number()) {
    case SYS_write:
      return note_write(call, d(0), std::nullopt, call.memory(a(1), a(2)));
    case SYS_pwrite64:
      return note_write(call, d(0), d(3), call.memory(a(1), a(2)));
    case SYS_writev:
      return note_vector(call, false);
    case SYS_pwritev:
    case SYS_pwritev2:
      return note_vector(call, true);
    case SYS_ftruncate:
      return note_resized(call, d(0), d(1));
    case SYS_rename:
      return rename(call.path(AT_FDCWD, a(0)), call.path(AT_FDCWD, a(1)));
    case SYS_renameat:
    case SYS_renameat2:
      return rename(call.path(d(0), a(1)), call.path(d(2), a(3)));
    case SYS_unlink:
    case SYS_rmdir:
      return remove(call.path(AT_FDCWD, a(0)));
    case SYS_unlinkat:
      return remove(call.path(d(0), a(1)));
    case SYS_mkdir:
      return make(call.path(AT_FDCWD, a(0)));
    case SYS_mkdirat:
      return make(call.path(d(0), a(1)));
    case SYS_fallocate:
      if (!is_ours(call.file_of(d(0)))) return;
      throw std::runtime_error("fallocate() is not recorded yet");
    case SYS_truncate:
      if (!is_ours(call.path(AT_FDCWD, a(0)))) return;
      throw std::runtime_error("truncate() by name is not recorded yet");
    default:
      return;
  }
}

void Recorder::ends(const Call& call) {
  switch (call.number()) {
    case SYS_open:
    case SYS_openat:
    case SYS_creat:
      return note_opened(call);
    case SYS_fsync:
    case SYS_fdatasync:
      return note_synced(call);
    case SYS_sendfile:
      return note_copied(call, static_cast<long>(call.argument(0)));
    case SYS_copy_file_range:
      return note_copied(call, static_cast<long>(call.argument(2)));
    default:
      return;
  }
}

/// Follows all processes until the last has ended.
void follow(pid_t first, Recorder& recorder) {
  std::map<pid_t, bool> at_end;  // thread -> it stops next at the end of a call that matters
  for (int status = 0; true;) {
    const pid_t thread = ::waitpid(-1, &status, __WALL);
    if (thread < 0) return;
    if (!WIFSTOPPED(status)) continue;
    const int signal = WSTOPSIG(status), event = status >> 16;
    const bool is_new = !at_end.contains(thread) && thread != first;
    long deliver = 0;
    auto go_on = PTRACE_CONT;
    if (event == PTRACE_EVENT_SECCOMP) {
      const Call call(thread);
      recorder.begins(call);
      at_end[thread] = Recorder::matters_at_its_end(call.number());
      if (at_end[thread]) go_on = PTRACE_SYSCALL;
    } else if (signal == (SIGTRAP | 0x80)) {
      if (at_end[thread]) recorder.ends(Call(thread));
      at_end[thread] = false;
    } else if (event == 0 && !(is_new && signal == SIGSTOP)) {
      deliver = signal;
    }
    at_end.try_emplace(thread, false);
    ::ptrace(go_on, thread, nullptr, deliver);
  }
}

}  // namespace

std::vector<DiskEvent> recorded(const fs::path& folder, const std::string& script) {
  const pid_t child = start_traced(folder, script);
  int status = 0;
  constexpr long options = PTRACE_O_TRACESYSGOOD | PTRACE_O_TRACESECCOMP | PTRACE_O_TRACECLONE |
                           PTRACE_O_TRACEFORK | PTRACE_O_TRACEVFORK | PTRACE_O_TRACEEXEC |
                           PTRACE_O_EXITKILL;
  if (::waitpid(child, &status, 0) != child || !WIFSTOPPED(status) ||
      ::ptrace(PTRACE_SETOPTIONS, child, nullptr, options) != 0)
    throw NoTracing("this system lets no test trace processes");
  Recorder recorder(folder);
  ::ptrace(PTRACE_CONT, child, nullptr, 0);
  follow(child, recorder);
  return std::move(recorder.events);
}

}  // namespace eerie::test

#else

namespace eerie::test {

std::vector<DiskEvent> recorded(const std::filesystem::path&, const std::string&) {
  throw NoTracing("system calls are traced on x86-64 alone");
}

}  // namespace eerie::test

#endif
