#include "craze/job/plan/side_by_side.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "craze/error.h"

namespace craze {
namespace {

using Clock = std::chrono::steady_clock;

TEST(SideBySide, EachIsDoneOnceByOneThread) {
  Context context;
  context.threads = Threads(3);
  std::vector<int> done(7, 0);
  side_by_side(done.size(), context, [&](std::size_t i, const Context& own) {
    ++done[i];
    EXPECT_EQ(own.threads.count(), 1);
  });
  EXPECT_EQ(done, std::vector<int>(7, 1));
  side_by_side(1, context,
               [](std::size_t, const Context& own) { EXPECT_EQ(own.threads.count(), 3); });
}

// Work that would go on for long stops soon, whichever thread it is done by.
TEST(SideBySide, AllHearThatTheRunIsToStop) {
  const auto begin = Clock::now();
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<bool> asked_elsewhere{false};
  Context context;
  context.threads = Threads(3);
  context.cancelled = [&] {
    if (std::this_thread::get_id() != caller) asked_elsewhere = true;
    return Clock::now() - begin > std::chrono::milliseconds(50);
  };
  const auto work = [&](std::size_t, const Context& own) {
    while (Clock::now() - begin < std::chrono::seconds(20)) {
      own.check();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  };
  EXPECT_THROW(side_by_side(3, context, work), Cancelled);
  EXPECT_LT(Clock::now() - begin, std::chrono::seconds(5));
  EXPECT_FALSE(asked_elsewhere);
}

TEST(SideBySide, TheOthersHearOfItWhenTheCallerHasDoneItsOwn) {
  const auto begin = Clock::now();
  const std::thread::id caller = std::this_thread::get_id();
  Context context;
  context.threads = Threads(2);
  context.cancelled = [&] { return Clock::now() - begin > std::chrono::milliseconds(50); };
  std::atomic<bool> other_began{false};
  const auto work = [&](std::size_t, const Context& own) {
    if (std::this_thread::get_id() == caller) {
      while (!other_began && Clock::now() - begin < std::chrono::seconds(20)) {
        std::this_thread::yield();
      }
      return;
    }
    other_began = true;
    while (Clock::now() - begin < std::chrono::seconds(20)) {
      own.check();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  };
  EXPECT_THROW(side_by_side(2, context, work), Cancelled);
  EXPECT_LT(Clock::now() - begin, std::chrono::seconds(5));
}

TEST(SideBySide, TheFirstFailureComesOut) {
  Context context;
  context.threads = Threads(4);
  for (int round = 0; round < 50; ++round) {
    try {
      side_by_side(9, context, [](std::size_t i, const Context&) {
        if (i >= 3) throw Error(ErrorKind::input, std::to_string(i), "", "no");
      });
      FAIL();
    } catch (const Error& e) {
      EXPECT_EQ(e.what(), std::string("3: no"));
    }
  }
}

}  // namespace
}  // namespace craze
