#include "campaign/serve/request_head.hpp"

#include <gtest/gtest.h>

namespace eerie::serve {
namespace {
using State = RequestHead::State;

const std::string whole = "GET /api/jobs?limit=3 HTTP/1.1\r\nHost: 127.0.0.1\r\nX:\r\n\r\n";

/// The status with which a head is refused; 0: it is not.
int refused(const std::string& text) {
  RequestHead head;
  return head.look(text) == State::refused ? head.refusal().status : 0;
}
std::string with_line(const std::string& line) { return line + "\r\nHost: 127.0.0.1\r\n\r\n"; }
std::string with_field(const std::string& field) {
  return "GET / HTTP/1.1\r\n" + field + "\r\n\r\n";
}

TEST(RequestHead, IsCompleteWithItsBlankLineHoweverItComes) {
  RequestHead at_once, by_bytes;
  EXPECT_EQ(at_once.look(whole + "GET"), State::complete);
  for (std::size_t size = 1; size < whole.size(); ++size)
    ASSERT_EQ(by_bytes.look(whole.substr(0, size)), State::incomplete) << size;
  EXPECT_EQ(by_bytes.look(whole), State::complete);
}

TEST(RequestHead, IsRefusedForALineThatIsNoRequest) {
  for (const char* line :
       {"FOO /api/jobs HTTP/1.1", "get / HTTP/1.1", "GET /api/jobs with blanks HTTP/1.1",
        "GET / HTTP/2.0", "GET /", "GET", "", " GET / HTTP/1.1", "GET  / HTTP/1.1",
        "GET / HTTP/1.1 ", "GET http://127.0.0.1/ HTTP/1.1", "GET * HTTP/1.1", "GET /\t HTTP/1.1"})
    EXPECT_EQ(refused(with_line(line)), 400) << line;
  EXPECT_EQ(refused(with_line("DELETE /api/jobs HTTP/1.0")), 0);
}

TEST(RequestHead, IsRefusedForLinesThatTwoReadersUnderstandInTwoWays) {
  EXPECT_EQ(refused("GET / HTTP/1.1\n"), 400) << "a bare LF";
  EXPECT_EQ(refused("GET / HTTP/1.1\r\nHost: a\n"), 400);
  EXPECT_EQ(refused(with_field("Host: a\rX: b")), 400) << "a bare CR";
  EXPECT_EQ(refused(with_field(std::string("Host: a\0b", 9))), 400);
  for (const char* field : {"Host", ": a", " Host: a", "Host : a", "Ho st: a"})
    EXPECT_EQ(refused(with_field(field)), 400) << field;
  EXPECT_EQ(refused(with_field("Host:\ta")), 0);
}

TEST(RequestHead, IsRefusedWhereItIsTooLargeBeforeItsEnd) {
  EXPECT_EQ(refused("GET /api/job/" + std::string(100'000, '7')), 414);
  EXPECT_EQ(refused("GET / HTTP/1.1\r\nX: " + std::string(9000, 'x')), 431);
  std::string many = "GET / HTTP/1.1\r\n";
  for (int k = 0; k < 2000; ++k) many += "X: " + std::string(20, 'x') + "\r\n";
  EXPECT_EQ(refused(many), 431);
  const std::string longest = "GET /" + std::string(RequestHead::longest_line - 16, 'a');
  EXPECT_EQ(refused(longest + " HTTP/1.1\r\n"), 0);
  EXPECT_EQ(refused(longest + "a HTTP/1.1\r\n"), 414);
}

}  // namespace
}  // namespace eerie::serve
