#include "campaign/serve/access.hpp"

#include <gtest/gtest.h>

#include <set>

namespace eerie::serve {
namespace {

constexpr const char* token = "0123456789abcdef0123456789abcdef";
const AccessRules on_loopback{token, ""};

Caller page() {
  return {{"127.0.0.1:8765"}, "http://127.0.0.1:8765", "same-origin", "application/json", token};
}

TEST(OwnHost, IsALoopbackNameWithAnyPort) {
  for (const char* host :
       {"127.0.0.1", "127.0.0.1:8765", "localhost:9000", "LOCALHOST", "[::1]:80"})
    EXPECT_TRUE(is_own_host(on_loopback, host)) << host;
}

TEST(OwnHost, IsNoNameThatAForeignPageMayHave) {
  for (const char* host :
       {"", "evil.example", "evil.example:8765", "127.0.0.1.evil.example", "localhost.evil.example",
        "10.0.0.7:8765", "127.0.0.1:80:80", "127.0.0.1:port", "[::1", "127.0.0.1@evil.example",
        "127.0.0.1:8765/../", "[::1]evil.example"})
    EXPECT_FALSE(is_own_host(on_loopback, host)) << host;
}

TEST(OwnHost, IsTheAddressOfListenToo) {
  EXPECT_TRUE(is_own_host({token, "10.0.0.7"}, "10.0.0.7:8765"));
  EXPECT_FALSE(is_own_host({token, "10.0.0.7"}, "10.0.0.8:8765"));
  EXPECT_TRUE(is_own_host({token, "0.0.0.0"}, "10.0.0.8:8765")) << "an address is nobody's name";
  EXPECT_FALSE(is_own_host({token, "0.0.0.0"}, "evil.example"));
}

TEST(Reading, NeedsOneRightHostAndNoForeignPage) {
  EXPECT_FALSE(refused_to_read(on_loopback, page()));
  Caller caller = page();
  caller.hosts.clear();
  EXPECT_EQ(refused_to_read(on_loopback, caller).value().status, 421);
  caller.hosts = {"127.0.0.1", "evil.example"};
  EXPECT_EQ(refused_to_read(on_loopback, caller).value().status, 421) << "two of them";
  for (const char* site : {"cross-site", "same-site"}) {
    caller = page();
    caller.fetch_site = site;
    EXPECT_EQ(refused_to_read(on_loopback, caller).value().status, 403);
  }
}

TEST(Changing, NeedsOriginKindAndToken) {
  EXPECT_FALSE(refused_to_change(on_loopback, page()));
  const auto refused = [](auto&& change, const AccessRules& rules = on_loopback) {
    Caller caller = page();
    change(caller);
    const auto reply = refused_to_change(rules, caller);
    return reply ? reply->status : 0;
  };
  EXPECT_EQ(refused([](Caller& c) { c.origin = ""; }), 403) << "curl and forms of old browsers";
  EXPECT_EQ(refused([](Caller& c) { c.origin = "null"; }), 403);
  EXPECT_EQ(refused([](Caller& c) { c.origin = "http://evil.example"; }), 403);
  EXPECT_EQ(refused([](Caller& c) { c.origin = "http://127.0.0.1:1234"; }), 403) << "another port";
  EXPECT_EQ(refused([](Caller& c) { c.content_type = "text/plain"; }), 415) << "what a form sends";
  EXPECT_EQ(refused([](Caller& c) { c.token = ""; }), 403);
  EXPECT_EQ(refused([](Caller& c) { c.token = "0123456789abcdef0123456789abcdee"; }), 403);
  EXPECT_EQ(refused([](Caller& c) { c.hosts = {"evil.example"}; }), 421);
  EXPECT_EQ(refused([](Caller&) {}, {"", ""}), 403) << "read only";
  EXPECT_EQ(refused([](Caller& c) { c.token = ""; }, {"", ""}), 403) << "no token is no right one";
}

TEST(Token, IsNewEachTimeAndHas128Bits) {
  std::set<std::string> tokens;
  for (int k = 0; k < 100; ++k) tokens.insert(new_token());
  EXPECT_EQ(tokens.size(), 100u);
  EXPECT_EQ(tokens.begin()->size(), 32u);
}

}  // namespace
}  // namespace eerie::serve
