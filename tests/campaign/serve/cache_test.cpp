#include "campaign/serve/cache.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <latch>
#include <stdexcept>
#include <thread>
#include <vector>

namespace eerie::serve {
namespace {

TEST(Cache, MakesAReplyOnceHoweverManyAskAtATime) {
  Cache cache;
  constexpr int askers = 16;
  std::atomic<int> made = 0;
  std::latch all_asked(askers);
  std::vector<std::thread> threads;
  for (int k = 0; k < askers; ++k)
    threads.emplace_back([&] {
      all_asked.arrive_and_wait();
      const Reply reply = cache.reply(1, "map", [&] {
        ++made;
        return Reply{.body = "cells"};
      });
      EXPECT_EQ(reply.body, "cells");
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(made, 1);
}

TEST(Cache, MakesItAnewForAnotherGenerationAndAnotherKey) {
  Cache cache;
  int made = 0;
  const auto make = [&] { return Reply{.body = std::to_string(++made)}; };
  EXPECT_EQ(cache.reply(1, "a", make).body, "1");
  EXPECT_EQ(cache.reply(1, "a", make).body, "1");
  EXPECT_EQ(cache.reply(1, "b", make).body, "2");
  EXPECT_EQ(cache.reply(2, "a", make).body, "3");
}

TEST(Cache, KeepsNoFault) {
  Cache cache;
  const auto fails = []() -> Reply { throw std::runtime_error("busy"); };
  EXPECT_THROW(cache.reply(1, "a", fails), std::runtime_error);
  EXPECT_EQ(cache.reply(1, "a", [] { return Reply{.body = "well"}; }).body, "well");
}

TEST(Cache, DoesNotGrowWithoutEnd) {
  Cache cache;
  int made = 0;
  for (int k = 0; k < 2000; ++k) cache.reply(1, std::to_string(k), [&] { return ++made, Reply{}; });
  cache.reply(1, "0", [&] { return ++made, Reply{}; });
  EXPECT_EQ(made, 2001) << "the oldest replies are forgotten";
}

}  // namespace
}  // namespace eerie::serve
