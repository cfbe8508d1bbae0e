#include <arpa/inet.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <pwd.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdlib>
#include <random>
#include <sstream>

#include "solver/base/file.hpp"
#include "tests/e2e/real_slurm.hpp"
#include "tests/support/program.hpp"

namespace eerie::test {
namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

/// Daemons live in /usr/sbin, which only root has in PATH.
std::string daemon(const std::string& name) {
  for (const char* folder : {"/usr/sbin", "/usr/local/sbin", "/usr/bin"})
    if (fs::exists(fs::path(folder) / name)) return fs::path(folder) / name;
  return "";
}

std::vector<int> free_ports(std::size_t count) {
  std::vector<int> sockets, ports;
  while (ports.size() < count) {
    sockets.push_back(::socket(AF_INET, SOCK_STREAM, 0));
    sockaddr_in address{};
    address.sin_family = AF_INET;
    socklen_t length = sizeof address;
    auto* plain = reinterpret_cast<sockaddr*>(&address);
    EXPECT_EQ(::bind(sockets.back(), plain, length), 0);
    EXPECT_EQ(::getsockname(sockets.back(), plain, &length), 0);
    ports.push_back(ntohs(address.sin_port));
  }
  for (const int socket : sockets) ::close(socket);
  return ports;
}

std::string configuration(const fs::path& folder) {
  const std::vector<int> ports = free_ports(3);
  return fmt::format(
      R"(ClusterName=t
SlurmctldHost=localhost
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
CredType=cred/munge
AuthInfo=socket={d}/run/munge.socket
SlurmctldPort={port}
SlurmctldPidFile={d}/run/slurmctld.pid
SlurmctldLogFile={d}/log/slurmctld.log
SlurmdPidFile={d}/run/slurmd.%n.pid
SlurmdLogFile={d}/log/slurmd.%n.log
SlurmdSpoolDir={d}/spool.%n
StateSaveLocation={d}/state
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=batch_sched_delay=0,sched_interval=1,bf_interval=1,sched_min_interval=0
SlurmdParameters=config_overrides
ReturnToService=2
SlurmdTimeout=5
KillWait=5
NodeName=n1 NodeHostname=localhost NodeAddr=127.0.0.1 Port={port1} CPUs=1 State=UNKNOWN
NodeName=n2 NodeHostname=localhost NodeAddr=127.0.0.1 Port={port2} CPUs=1 State=UNKNOWN
PartitionName=debug Nodes=n1,n2 Default=YES State=UP
)",
      fmt::arg("user", ::getpwuid(::geteuid())->pw_name), fmt::arg("d", folder.string()),
      fmt::arg("port", ports[0]), fmt::arg("port1", ports[1]), fmt::arg("port2", ports[2]));
}

void install_key(const fs::path& path) {
  std::random_device random;
  std::string key;
  while (key.size() < 1024) key += static_cast<char>(random());
  install_text(path, key);
  fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
}

/// Of a pid file; 0 where there is none.
pid_t pid_in(const fs::path& file) {
  return fs::exists(file) ? static_cast<pid_t>(std::atoi(read_file(file).c_str())) : 0;
}

/// Waits for processes that were told to end; ends them where they do not.
void end_processes(const std::vector<pid_t>& pids) {
  for (const pid_t pid : pids) {
    if (pid <= 1) continue;
    const auto gone = [pid] { return ::kill(pid, 0) != 0; };
    if (!eventually(gone, 10s)) ::kill(pid, SIGKILL);
  }
}

}  // namespace

std::string RealSlurm::missing() {
  for (const char* name : {"munged", "slurmctld", "slurmd"})
    if (daemon(name).empty())
      return std::string(name) + " is not installed (packages munge and slurm-wlm)";
  return "";
}

RealSlurm::RealSlurm() {
  const fs::path& d = folder_.path();
  fs::permissions(d, fs::perms::group_exec | fs::perms::others_exec, fs::perm_options::add);
  for (const char* part : {"run", "log", "state"}) fs::create_directories(d / part);
  install_key(d / "munge.key");
  install_text(d / "slurm.conf", configuration(d));
  ::setenv("SLURM_CONF", (d / "slurm.conf").c_str(), 1);
  const auto file = [&](const char* option, const char* name) {
    return fmt::format("--{}={}", option, (d / name).string());
  };
  const std::string conf = (d / "slurm.conf").string();
  call({daemon("munged"), file("key-file", "munge.key"), file("socket", "run/munge.socket"),
        file("pid-file", "run/munged.pid"), file("log-file", "log/munged.log"),
        file("seed-file", "run/munge.seed"), "--force"});
  call({daemon("slurmctld"), "-c", "-f", conf});
  for (const char* node : {"n1", "n2"}) call({daemon("slurmd"), "-c", "-f", conf, "-N", node});
}

RealSlurm::~RealSlurm() {
  commands_.run({"scancel", "--me"}, 10s);
  // Else a slurmd that ends leaves the shepherds of its jobs behind.
  eventually([this] { return queue().empty(); }, 15s);
  const fs::path run = folder_.path() / "run";
  const std::vector<pid_t> daemons = {pid_in(run / "slurmctld.pid"), pid_in(run / "slurmd.n1.pid"),
                                      pid_in(run / "slurmd.n2.pid")};
  // All at once: one after another they wait for each other.
  if (!commands_.run({"scontrol", "shutdown"}, 10s).ok())
    for (const pid_t pid : daemons)
      if (pid > 1) ::kill(pid, SIGTERM);
  end_processes(daemons);
  if (const pid_t munged = pid_in(run / "munged.pid"); munged > 1) {
    ::kill(munged, SIGTERM);
    end_processes({munged});
  }
  ::unsetenv("SLURM_CONF");
}

slurm::CommandEnd RealSlurm::call(const std::vector<std::string>& words) {
  slurm::CommandEnd end = commands_.run(words, 30s);
  EXPECT_TRUE(end.ok()) << words[0] << ": " << end.complaint() << "\n" << logs();
  return end;
}

std::string RealSlurm::logs() const {
  std::string text;
  for (const auto& entry : fs::directory_iterator(folder_.path() / "log")) {
    const std::string log = read_file(entry.path());
    text += entry.path().filename().string() + ":\n" +
            log.substr(log.size() - std::min<std::size_t>(log.size(), 2000)) + "\n";
  }
  return text;
}

bool RealSlurm::ready() {
  const bool idle = eventually(
      [this] {
        const slurm::CommandEnd end = commands_.run({"sinfo", "-h", "-N", "-o", "%N %T"}, 10s);
        return end.out == "n1 idle\nn2 idle\n";
      },
      20s);
  EXPECT_TRUE(idle) << logs();
  return idle;
}

void RealSlurm::fail(const std::string& node) {
  call({"scontrol", "update", "nodename=" + node, "state=down", "reason=test"});
}

void RealSlurm::resume(const std::string& node) {
  // It may have come back by itself, which is no error of ours.
  commands_.run({"scontrol", "update", "nodename=" + node, "state=resume"}, 30s);
}

int RealSlurm::start_requeued() {
  int waited = 0;
  std::istringstream lines(call({"squeue", "-h", "-r", "-o", "%i %r"}).out);
  for (std::string id, reason; lines >> id >> reason;)
    if (reason == "BeginTime" &&
        commands_.run({"scontrol", "update", "jobid=" + id, "StartTime=now"}, 30s).ok())
      ++waited;
  return waited;
}

std::string RealSlurm::queue(const std::string& node) {
  std::vector<std::string> words = {"squeue", "-h", "-r", "-o", slurm::queue_format};
  if (!node.empty()) words.push_back("--nodelist=" + node);
  return commands_.run(words, 10s).out;
}

}  // namespace eerie::test
