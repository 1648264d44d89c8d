// Loops on several threads: the same chunks, the same failure, nobody waits for ever.
#include "craze/base/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace craze {
namespace {

using Chunks = std::vector<std::pair<std::size_t, std::size_t>>;

// The chunks of a loop, by their beginnings; {0, 0} where one has not come.
Chunks chunks_of(const Threads& threads, std::size_t n, std::size_t grain) {
  Chunks chunks((n + grain - 1) / grain);
  parallel_for(threads, n, grain, [&](std::size_t begin, std::size_t end) {
    chunks[begin / grain].first += begin;
    chunks[begin / grain].second += end;
  });
  return chunks;
}

// 0 + 1 + … + (n - 1), a slot for each chunk.
std::size_t sum_below(const Threads& threads, std::size_t n, std::size_t grain) {
  std::vector<std::size_t> sums((n + grain - 1) / grain);
  parallel_for(threads, n, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) sums[begin / grain] += i;
  });
  return std::accumulate(sums.begin(), sums.end(), std::size_t{0});
}

TEST(Parallel, ChunksCoverTheRangeOnceAndDoNotDependOnTheThreads) {
  for (const int count : {1, 2, 3, 8}) {
    const Threads threads(count);
    for (const std::size_t n : {0, 1, 5, 64, 1000}) {
      for (const std::size_t grain : {1, 7, 64, 5000}) {
        Chunks expected;
        for (std::size_t i = 0; i < n; i += grain) expected.emplace_back(i, std::min(n, i + grain));
        EXPECT_EQ(chunks_of(threads, n, grain), expected) << count << " " << n << " " << grain;
      }
    }
  }
}

TEST(Parallel, OneThreadTakesTheChunksInOrderAndStartsNothing) {
  const Threads one(1);
  EXPECT_EQ(one.executor(), nullptr);
  std::vector<std::size_t> order;
  parallel_for(one, 100, 10, [&](std::size_t begin, std::size_t) { order.push_back(begin); });
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 10, 20, 30, 40, 50, 60, 70, 80, 90}));
}

TEST(Parallel, CountsAreBetweenOneAndTheMost) {
  EXPECT_EQ(Threads(-3).count(), 1);
  EXPECT_EQ(Threads(3).count(), 3);
  EXPECT_EQ(Threads(1'000'000).count(), Threads::max_count);
  EXPECT_EQ(Threads().count(), Threads(0).count());
  EXPECT_GE(Threads().count(), 1);
}

TEST(Parallel, TwoThreadsWorkAtTheSameTime) {
  if (std::thread::hardware_concurrency() < 2) GTEST_SKIP() << "one core";
  const Threads threads(2);
  std::atomic<int> here{0};
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  parallel_for(threads, 2, 1, [&](std::size_t, std::size_t) {
    ++here;
    while (here < 2 && std::chrono::steady_clock::now() < end) std::this_thread::yield();
  });
  EXPECT_LT(std::chrono::steady_clock::now(), end);
}

TEST(Parallel, TheFirstFailureComesOutOnAnyNumberOfThreads) {
  for (const int count : {1, 2, 3}) {
    const Threads threads(count);
    for (int round = 0; round < 200; ++round) {
      std::vector<char> ran(64);
      try {
        parallel_for(threads, ran.size(), 1, [&](std::size_t i, std::size_t) {
          ran[i] = 1;
          if (i >= 20 && i % 3 == 0) throw std::runtime_error(std::to_string(i));
        });
        FAIL() << "nothing came out";
      } catch (const std::runtime_error& error) {
        ASSERT_STREQ(error.what(), "21");
      }
      for (int i = 0; i <= 21; ++i) ASSERT_TRUE(ran[i]) << i;
    }
    EXPECT_EQ(sum_below(threads, 100, 7), 4950u);  // the handle still serves
  }
}

TEST(Parallel, LoopsInsideLoopsEnd) {
  const Threads threads(3), others(2);
  std::vector<std::size_t> sums(40);
  parallel_for(threads, sums.size(), 1, [&](std::size_t i, std::size_t) {
    std::vector<std::size_t> inner(5);
    parallel_for(threads, inner.size(), 1, [&](std::size_t j, std::size_t) {
      inner[j] = sum_below(j % 2 == 0 ? threads : others, 10 * (i + 1), 4);
    });
    sums[i] = std::accumulate(inner.begin(), inner.end(), std::size_t{0});
  });
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const std::size_t n = 10 * (i + 1);
    EXPECT_EQ(sums[i], 5 * n * (n - 1) / 2);
  }
}

TEST(Parallel, AFailureInsideALoopInsideALoopComesOut) {
  const Threads threads(2);
  EXPECT_THROW(parallel_for(threads, 8, 1,
                            [&](std::size_t, std::size_t) {
                              parallel_for(threads, 8, 1, [](std::size_t i, std::size_t) {
                                if (i == 5) throw std::runtime_error("inner");
                              });
                            }),
               std::runtime_error);
}

TEST(Parallel, TwoUsersOfOneHandleDoNotWaitForEachOther) {
  const Threads threads(3);
  const auto use = [&](std::size_t n) {
    for (int round = 0; round < 500; ++round) {
      EXPECT_EQ(sum_below(threads, n, 3), n * (n - 1) / 2);
    }
  };
  std::thread other(use, 50);
  use(31);
  other.join();
}

TEST(Parallel, AUserGetsThroughWhileAnothersLoopStands) {
  const Threads threads(2);
  std::atomic<bool> stands{false}, through{false};
  std::thread other([&] {
    parallel_for(threads, 2, 1, [&](std::size_t, std::size_t) {
      stands = true;
      while (!through) std::this_thread::yield();
    });
  });
  while (!stands) std::this_thread::yield();
  EXPECT_EQ(sum_below(threads, 100, 1), 4950u);
  through = true;
  other.join();
}

TEST(Parallel, ManyShortLoopsRun) {
  const Threads threads(4);
  for (std::size_t n = 0; n < 1000; ++n) {
    ASSERT_EQ(sum_below(threads, n, 16), n * (n - (n > 0 ? 1 : 0)) / 2);
  }
}

TEST(Parallel, LoopsAfterARestFindTheirThreadsAgain) {
  const Threads threads(3);
  for (int round = 0; round < 20; ++round) {
    EXPECT_EQ(sum_below(threads, 1000, 10), 499'500u);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));  // long enough to fall asleep
  }
}

TEST(Parallel, ACopyOutlivesItsOriginal) {
  Threads original(2);
  EXPECT_EQ(sum_below(original, 100, 1), 4950u);
  const Threads copy = original;
  EXPECT_EQ(copy.executor(), original.executor());
  original = 1;
  EXPECT_EQ(copy.count(), 2);
  EXPECT_EQ(sum_below(copy, 100, 1), 4950u);
}

TEST(Parallel, HandlesComeAndGo) {
  for (int round = 0; round < 200; ++round) {
    const Threads unused(3);
    const Threads threads(3);
    EXPECT_NE(threads.executor(), unused.executor());
    EXPECT_EQ(sum_below(threads, 10, 1), 45u);
  }
}

}  // namespace
}  // namespace craze
