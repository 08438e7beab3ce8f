// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/rehearsal.hpp"

#include <unistd.h>

#include <gtest/gtest.h>

#include <csignal>
#include <stdexcept>
#include <thread>
#include <vector>

#include "setae/core/errors.hpp"

namespace setae::bytes::rehearsal_test {
namespace {

std::string refusal(const std::function<void()>& use) {
    try {
        rehearse("a.h5", "HDF5", use);
    } catch (const FormatError& error) {
        return error.what();
    }
    return "";
}

TEST(Rehearsal, IsolatesACrashFromTheProgram) {
    EXPECT_NE(refusal([] { std::raise(SIGSEGV); }).find("a.h5: HDF5: the library failed while reading it (signal 11"),
              std::string::npos);
    EXPECT_NE(refusal([] { std::raise(SIGABRT); }).find("signal 6"), std::string::npos);
    EXPECT_NE(refusal([] { ::_exit(1); }).find("ended the process that reads it (exit code 1)"), std::string::npos);
    EXPECT_NE(refusal([] { std::raise(SIGALRM); }).find("did not finish within"), std::string::npos);
}

TEST(Rehearsal, HasNoSideEffects) {
    int done = 0;
    EXPECT_EQ(refusal([&] { ++done; }), "");
    EXPECT_EQ(refusal([] { throw std::runtime_error("said by the caller again"); }), "");
    EXPECT_EQ(done, 0);
}

TEST(Rehearsal, RunsOnManyThreads) {
    std::vector<std::jthread> threads;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([] {
            for (int i = 0; i < 20; ++i) {
                EXPECT_EQ(refusal([] { std::vector<int>(1000).resize(100000); }), "");
                EXPECT_NE(refusal([] { std::raise(SIGSEGV); }), "");
            }
        });
}

}  // namespace
}  // namespace setae::bytes::rehearsal_test
