// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/parallel/for_each.hpp"

#include "setae/core/errors.hpp"
#include "setae/parallel/cancellation.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

namespace setae::parallel::for_each_test {
namespace {

TEST(ForEachIndex, VisitsEveryIndexOnceForAnyNumberOfThreads) {
    for (const int threads : {1, 2, 7}) {
        std::vector<int> visits(1000, 0);
        for_each_index(visits.size(), Threads{threads}, [&](std::size_t i) { ++visits[i]; });
        EXPECT_EQ(visits, std::vector<int>(1000, 1)) << threads;
    }
}

TEST(ForEachIndex, RethrowsTheFailureOfTheLowestIndexAfterRunningAll) {
    std::vector<int> visits(100, 0);
    try {
        for_each_index(visits.size(), Threads{3}, [&](std::size_t i) {
            visits[i] = 1;
            if (i == 20 || i == 70) throw std::runtime_error(std::to_string(i));
        });
        FAIL() << "no exception";
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "20");
    }
    EXPECT_EQ(visits, std::vector<int>(100, 1));
}

TEST(ForEachIndex, RunsNestedAndFromSeveralThreads) {
    std::vector<std::vector<int>> visits(8, std::vector<int>(50, 0));
    const auto outer = [&](std::size_t i) { for_each_index(50, Threads{3}, [&](std::size_t j) { ++visits[i][j]; }); };
    {
        const std::jthread other([&] { for_each_index(4, Threads{2}, outer); });
        for_each_index(4, Threads{3}, [&](std::size_t i) { outer(i + 4); });
    }
    EXPECT_EQ(visits, std::vector(8, std::vector<int>(50, 1)));
}

TEST(ForEachIndex, RunsInAForkedChildWithoutItsThreads) {
    for_each_index(10, Threads{2}, [](std::size_t) {});
    const pid_t child = fork();
    if (child == 0) {
        std::atomic<int> visits{0};
        for_each_index(10, Threads{2}, [&](std::size_t) { ++visits; });
        _exit(visits == 10 ? 0 : 1);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0);
}

TEST(Cancellation, StartsNoFurtherIndexInNestedLoops) {
    std::atomic<bool> cancelled{false};
    std::atomic<int> begun{0};
    const auto inner = [&](std::size_t) {
        for_each_index(100, Threads{2}, [&](std::size_t) {
            if (++begun >= 5) cancelled = true;
        });
    };
    const CancellationScope scope(cancelled);
    EXPECT_THROW(for_each_index(100, Threads{3}, inner), Cancelled);
    EXPECT_LT(begun, 5 + 2 * 3);  // those under way at the time of the request
}

TEST(Cancellation, EndsWithItsScope) {
    const std::atomic<bool> cancelled{true};
    { const CancellationScope scope(cancelled); }
    int visits = 0;
    for_each_index(3, Threads{1}, [&](std::size_t) { ++visits; });
    EXPECT_EQ(visits, 3);
}

}  // namespace
}  // namespace setae::parallel::for_each_test
