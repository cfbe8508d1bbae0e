// The dashboard among those who mean it ill: ten thousand requests, none of which may crash it,
// write anything, or make it keep what it took.

#include <gtest/gtest.h>
#include <httplib.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <fstream>
#include <random>
#include <thread>

#include "campaign/manager/inbox.hpp"
#include "campaign/serve/dashboard.hpp"
#include "solver/base/file.hpp"
#include "tests/support/impact_database.hpp"
#include "tests/support/sanitizer.hpp"

namespace eerie::serve {
namespace {
namespace fs = std::filesystem;
using namespace std::chrono_literals;

/// A connection that says what it likes, and how slowly it likes.
class Raw {
 public:
  explicit Raw(int port) : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const timeval patience{30, 0};
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    connected_ = ::connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
  }
  ~Raw() { ::close(socket_); }
  Raw(const Raw&) = delete;
  Raw& operator=(const Raw&) = delete;

  bool connected() const { return connected_; }
  bool say(const std::string& text) const {
    return ::send(socket_, text.data(), text.size(), MSG_NOSIGNAL) ==
           static_cast<ssize_t>(text.size());
  }
  /// All that comes until the other side ends the connection.
  std::string all() const {
    std::string got;
    std::array<char, 4096> buffer{};
    for (ssize_t n = 1; n > 0;)
      if ((n = ::recv(socket_, buffer.data(), buffer.size(), 0)) > 0)
        got.append(buffer.data(), static_cast<std::size_t>(n));
    return got;
  }
  /// Whether something came that was not read, or the connection ended.
  bool has_news() const {
    char byte = 0;
    return ::recv(socket_, &byte, 1, MSG_PEEK | MSG_DONTWAIT) >= 0;
  }
  /// The status of the answer; 0: it was cut off without one.
  int status() const {
    std::string got;
    std::array<char, 4096> buffer{};
    for (ssize_t n = 1; n > 0 && got.size() < 13;)
      if ((n = ::recv(socket_, buffer.data(), buffer.size(), 0)) > 0)
        got.append(buffer.data(), static_cast<std::size_t>(n));
    return got.starts_with("HTTP/1.1 ") ? std::atoi(got.c_str() + 9) : 0;
  }

 private:
  int socket_;
  bool connected_;
};

long resident_kB() {
  std::ifstream in("/proc/self/statm");
  long pages = 0;
  in >> pages >> pages;
  return pages * (::sysconf(_SC_PAGESIZE) / 1024);
}

std::size_t open_files() {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator("/proc/self/fd"), fs::directory_iterator()));
}

class Hostile : public testing::Test {
 protected:
  Hostile() {
    db::Connection connection(database, db::Access::write);
    std::vector<std::pair<nlohmann::json, double>> impacts;
    for (int seed = 1; seed <= 4; ++seed)
      impacts.emplace_back(test::survey_scene(1, 40, 20, 15, seed), 0.25);
    test::add_impacts(connection, impacts);
    hash = db::jobs(connection, {}).front().hash;
    install_text(folder / "secret.txt", "secret");
  }
  std::string head(const std::string& method, const std::string& path) const {
    return method + " " + path + " HTTP/1.1\r\nHost: 127.0.0.1\r\n";
  }
  std::string action(const std::string& headers, const std::string& body) const {
    return head("POST", "/api/requests") + "Content-Type: application/json\r\n" + headers +
           "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body;
  }

  test::TemporaryFolder folder;
  fs::path database = folder / "a.sqlite";
  std::string hash;
};

/// Requests, one for each number; what a right answer to them is not: 200.
std::string attack(std::mt19937& random, int kind, const std::string& hash) {
  const std::string host = "Host: 127.0.0.1\r\n", end = "\r\n\r\n",
                    pause = R"({"kind":"pause","all":true})";
  const auto get = [&](const std::string& path) {
    return "GET " + path + " HTTP/1.1\r\n" + host + "\r\n";
  };
  const auto post = [&](const std::string& headers) {
    return "POST /api/requests HTTP/1.1\r\n" + headers +
           "Content-Length: " + std::to_string(pause.size()) + end + pause;
  };
  const std::string json = "Content-Type: application/json\r\n",
                    own = "Origin: http://127.0.0.1\r\n";
  std::string guess;
  for (int k = 0; k < 32; ++k) guess += "0123456789abcdef"[random() % 16];
  std::string noise(1 + random() % 300, ' ');
  for (char& c : noise) c = static_cast<char>(random() % 256);
  switch (kind) {
    case 0:
      return get("/page/../../secret.txt");
    case 1:
      return get("/page/%2e%2e%2f%2e%2e%2fsecret.txt");
    case 2:
      return get("/../../../../etc/passwd");
    case 3:
      return get("/api/job/" + hash + "/particles?snapshot=..%2f..%2fsecret.txt");
    case 4:
      return get("/api/job/..%2f..%2fsecret/log");
    case 5:
      return "GET /api/campaign HTTP/1.1\r\nHost: evil.example\r\n\r\n";
    case 6:
      return "GET /api/campaign HTTP/1.1\r\n\r\n";
    case 7:
      return post(host + own + json + "X-Eerie-Token: " + guess + "\r\n");
    case 8:
      return post(host + own + json);
    case 9:
      return post(host + json + "Origin: http://evil.example\r\nX-Eerie-Token: " + guess + "\r\n");
    case 10:
      return post("Host: evil.example\r\nOrigin: http://evil.example\r\n" + json);
    case 11:
      return "GET /" + std::string(9000, 'a') + " HTTP/1.1\r\n" + host + "\r\n";
    case 12:
      return "GET / HTTP/1.1\r\n" + host + "X: " + std::string(9000, 'b') + end;
    case 13: {
      std::string many = "GET / HTTP/1.1\r\n" + host;
      for (int k = 0; k < 2000; ++k)
        many += "X-" + std::to_string(k) + ": " + std::string(20, 'c') + "\r\n";
      return many + "\r\n";
    }
    case 14:
      return "POST /api/requests HTTP/1.1\r\n" + host + own + json + "Content-Length: 99999999999" +
             end + noise;
    case 15:
      return "POST /api/requests HTTP/1.1\r\n" + host + own + json + "Content-Length: -1" + end +
             noise;
    case 16:
      return "DELETE /api/requests HTTP/1.1\r\n" + host + "\r\n";
    case 17:
      return "OPTIONS /api/requests HTTP/1.1\r\n" + host +
             "Origin: http://evil.example\r\nAccess-Control-Request-Method: POST\r\n\r\n";
    case 18:
      return get("/api/jobs?where=job%3D1%3BDROP%20TABLE%20jobs&sort=%27");
    case 19:
      return get("/api/jobs?limit=99999999999999999999");
    case 20:
      return "PUT /page/main.js HTTP/1.1\r\n" + host + "Content-Length: 3\r\n\r\nabc";
    default:
      return noise + "\r\n\r\n";
  }
}
constexpr int kinds = 22;

TEST_F(Hostile, TenThousandRequestsNeitherCrashNorWriteNorStay) {
  Dashboard dashboard({.database = database, .port = 0});
  const std::string before = read_file(database);
  std::atomic<int> refused = 0, cut = 0;
  const auto attackers = [&](int rounds) {
    std::vector<std::thread> threads;
    for (unsigned thread = 0; thread < 8; ++thread)
      threads.emplace_back([&, thread] {
        std::mt19937 random(thread);
        for (int k = 0; k < rounds; ++k) {
          const int kind = k % kinds;
          Raw raw(dashboard.port());
          ASSERT_TRUE(raw.connected());
          raw.say(attack(random, kind, hash));
          const int status = raw.status();
          EXPECT_NE(status, 200) << "attack " << kind;
          EXPECT_NE(status, 202) << "attack " << kind;
          ++(status == 0 ? cut : refused);
        }
      });
    for (std::thread& thread : threads) thread.join();
  };
  attackers(2 * kinds);  // what the server keeps for good it has now
  const long resident = resident_kB();
  const std::size_t files = open_files();
  attackers(1250);
  EXPECT_GE(refused + cut, 10'000);
  if (!test::is_sanitized) {
    EXPECT_LT(resident_kB() - resident, 64 * 1024) << "kB";
  }
  EXPECT_LE(open_files(), files + 16);
  httplib::Client client("127.0.0.1", dashboard.port());
  const auto answer = client.Get("/api/campaign");
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 200);
  EXPECT_EQ(read_file(database), before);
  EXPECT_TRUE(manager::Inbox(database).is_empty());
}

TEST_F(Hostile, ADashboardThatIsEndedAsItBeginsEnds) {
  for (int k = 0; k < 200; ++k) Dashboard({.database = database, .port = 0});
}

TEST_F(Hostile, SlowClientsAreLeftAndOthersAnsweredMeanwhile) {
  Dashboard dashboard({.database = database, .port = 0});
  std::vector<std::unique_ptr<Raw>> slow;
  for (int k = 0; k < 60; ++k) {
    slow.push_back(std::make_unique<Raw>(dashboard.port()));
    slow.back()->say("GET / HTTP/1.1\r\nHost: 127");
  }
  httplib::Client client("127.0.0.1", dashboard.port());
  client.set_read_timeout(30);
  const auto answer = client.Get("/api/about");
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 200);
  for (const auto& one : slow) EXPECT_NE(one->status(), 200) << "a head takes ten seconds at most";
}

TEST_F(Hostile, AnAddressThatIsTooLongIsAnsweredSo) {
  Dashboard dashboard({.database = database, .port = 0});
  for (const std::string& path :
       {"/api/job/" + std::string(100'000, '7'), "/api/jobs?where=" + std::string(70'000, 'a')}) {
    Raw raw(dashboard.port());
    raw.say(head("GET", path) + "\r\n");
    const std::string answer = raw.all();
    EXPECT_TRUE(answer.starts_with("HTTP/1.1 414 ")) << answer.substr(0, 80);
    EXPECT_NE(answer.find("\r\nContent-Security-Policy: default-src 'none'"), std::string::npos);
    EXPECT_NE(answer.find("too long"), std::string::npos);
  }
}

TEST_F(Hostile, ABadHeadIsAnsweredOnceWithTheGuardHeadersAndThatIsAll) {
  Dashboard dashboard({.database = database, .port = 0});
  const std::string next = "GET /api/about HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n",
                    rest = "\r\nHost: 127.0.0.1\r\n\r\n";
  const std::vector<std::pair<std::string, std::string>> heads = {
      {"FOO /api/jobs HTTP/1.1" + rest, "400"},
      {"GET /api/jobs of all HTTP/1.1" + rest, "400"},
      {"GET /api/jobs HTTP/1.1\nHost: 127.0.0.1\n\n", "400"},
      {"GET / HTTP/1.1\r\nX: " + std::string(40'000, 'x') + rest, "431"},
      {"one line\r\nand one more\r\nand one more\r\n", "400"}};
  for (const auto& [text, status] : heads) {
    Raw raw(dashboard.port());
    raw.say(text + next + next);
    const std::string answer = raw.all();
    EXPECT_TRUE(answer.starts_with("HTTP/1.1 " + status)) << answer;
    EXPECT_EQ(answer.find("HTTP/1.1", 1), std::string::npos) << answer;
    EXPECT_NE(answer.find("\r\nContent-Security-Policy: "), std::string::npos);
    EXPECT_NE(answer.find("\r\nConnection: close\r\n"), std::string::npos);
  }
}

TEST_F(Hostile, AWholeHeadMayComeInPiecesAndSeveralInOnePiece) {
  Dashboard dashboard({.database = database, .port = 0});
  const std::string ask = "GET /api/about HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n";
  Raw raw(dashboard.port());
  raw.say(ask.substr(0, 10));
  std::this_thread::sleep_for(100ms);
  raw.say(ask.substr(10) + ask + "GET / HTTP/9\r\n");
  const std::string answers = raw.all();
  EXPECT_TRUE(answers.starts_with("HTTP/1.1 200")) << answers;
  EXPECT_NE(answers.find("HTTP/1.1 200", 1), std::string::npos) << answers;
  EXPECT_NE(answers.find("HTTP/1.1 400"), std::string::npos) << answers;
}

TEST_F(Hostile, OpenStreamsAndHalfSentHeadsHoldUpNobody) {
  Dashboard dashboard({.database = database, .port = 0});
  std::vector<std::unique_ptr<Raw>> streams, halves;
  int open = 0, refused = 0;
  for (int k = 0; k < 200; ++k) {
    streams.push_back(std::make_unique<Raw>(dashboard.port()));
    streams.back()->say(head("GET", "/api/events") + "\r\n");
  }
  for (const auto& one : streams) {
    const int status = one->status();
    ++(status == 200 ? open : refused);
    EXPECT_TRUE(status == 200 || status == 503) << status;
  }
  EXPECT_EQ(open, 64);
  EXPECT_EQ(refused, 136);
  for (int k = 0; k < 200; ++k) {
    halves.push_back(std::make_unique<Raw>(dashboard.port()));
    halves.back()->say("GET / HTTP/1.1\r\nHost: 127");
  }
  httplib::Client client("127.0.0.1", dashboard.port());
  client.set_read_timeout(30);
  const auto answer = client.Get("/api/about");
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 200);
  EXPECT_FALSE(halves.back()->has_news()) << "it was answered while they all waited";
  const auto one_more = client.Get("/api/events");
  ASSERT_TRUE(one_more);
  EXPECT_EQ(one_more->status, 503);
  EXPECT_EQ(one_more->get_header_value("Retry-After"), "5");
  const auto news = client.Get("/api/news");
  ASSERT_TRUE(news);
  EXPECT_NE(news->body.find("\"again_s\":5"), std::string::npos) << "what the page does instead";
}

TEST_F(Hostile, EveryAnswerCarriesTheGuardHeaders) {
  Dashboard dashboard({.database = database, .port = 0});
  httplib::Client client("127.0.0.1", dashboard.port());
  for (const char* path :
       {"/", "/api/about", "/api/nothing", "/api/jobs?nope=1", "/api/events?x=1"}) {
    const auto answer = client.Get(path);
    ASSERT_TRUE(answer) << path;
    EXPECT_EQ(answer->get_header_value_count("Content-Security-Policy"), 1u) << path;
    EXPECT_EQ(answer->get_header_value("X-Content-Type-Options"), "nosniff") << path;
  }
}

TEST_F(Hostile, ATokenIsNeededAndTheRightOneIsEnough) {
  Dashboard dashboard({.database = database, .port = 0});
  const std::string origin = "http://127.0.0.1:" + std::to_string(dashboard.port());
  httplib::Client client("127.0.0.1", dashboard.port());
  const auto ask = [&](const std::string& token) {
    const auto answer = client.Post("/api/requests", {{"Origin", origin}, {"X-Eerie-Token", token}},
                                    R"({"kind": "pause", "all": true})", "application/json");
    return answer ? answer->status : 0;
  };
  EXPECT_EQ(ask("wrong"), 403);
  EXPECT_TRUE(manager::Inbox(database).is_empty());
  EXPECT_EQ(ask(dashboard.token()), 202) << "nobody works on it: the request waits";
  EXPECT_FALSE(manager::Inbox(database).is_empty());
}

TEST_F(Hostile, APageSaysThatNoScriptButItsOwnMayRun) {
  Dashboard dashboard({.database = database, .port = 0, .read_only = true});
  EXPECT_EQ(dashboard.token(), "");
  httplib::Client client("127.0.0.1", dashboard.port());
  const auto answer = client.Get("/map");
  ASSERT_TRUE(answer);
  const std::string policy = answer->get_header_value("Content-Security-Policy");
  EXPECT_NE(policy.find("script-src 'self'"), std::string::npos);
  EXPECT_EQ(policy.find("unsafe"), std::string::npos);
  EXPECT_FALSE(answer->has_header("Access-Control-Allow-Origin"));
  EXPECT_EQ(answer->body.find("<script>"), std::string::npos);
}

TEST_F(Hostile, NobodyMakesTheServerPackItsRepliesForSeconds) {
  Dashboard dashboard({.database = database, .port = 0, .read_only = true});
  httplib::Client client("127.0.0.1", dashboard.port());
  const auto answer = client.Get("/page/three.module.js", {{"Accept-Encoding", "gzip, br"}});
  ASSERT_TRUE(answer);
  EXPECT_FALSE(answer->has_header("Content-Encoding"));
  EXPECT_GT(answer->body.size(), 1'000'000u);
}

}  // namespace
}  // namespace eerie::serve
