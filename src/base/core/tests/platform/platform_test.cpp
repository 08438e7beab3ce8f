// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include "setae/platform/files.hpp"
#include "setae/platform/libraries.hpp"
#include "setae/platform/memory.hpp"
#include "setae/platform/processes.hpp"
#include "setae/platform/terminal.hpp"

namespace setae::platform::platform_test {
namespace {

namespace fs = std::filesystem;

class Folder : public testing::Test {
protected:
    Folder() {
        std::error_code failure;
        path_ = new_folder((fs::temp_directory_path() / "setae_platform_").string(), failure);
        EXPECT_FALSE(failure);
    }
    ~Folder() override { fs::remove_all(path_); }

    [[nodiscard]] std::string written(const std::string& name, const std::string& text) const {
        std::ofstream(path_ / name) << text;
        return (path_ / name).string();
    }

    fs::path path_;
};

using Files = Folder;
using Processes = Folder;

TEST_F(Files, AreReadAtAnyOffset) {
    const ReadableFile file(written("a", "0123456789"));
    std::string text(4, ' ');
    ASSERT_FALSE(file.failure());
    EXPECT_EQ(file.facts()->size, 10u);
    EXPECT_TRUE(file.read(3, 4, text.data()));
    EXPECT_EQ(text, "3456");
    EXPECT_FALSE(file.read(8, 4, text.data())) << "two bytes are left";
}

TEST_F(Files, HaveAChangeTime) {
    const auto file = written("a", "x");
    const auto first = facts_of(file);
    EXPECT_EQ(facts_of(file), first);
    fs::last_write_time(file, fs::last_write_time(file) - std::chrono::milliseconds(1500));
    const auto second = facts_of(file);
    EXPECT_NE(second, first);
    EXPECT_EQ(first->changed - second->changed, 1'500'000'000);
}

TEST_F(Files, WithOneInodeAreIdentical) {
    const auto file = written("a", "x");
    fs::create_hard_link(file, path_ / "b");
    fs::create_symlink(file, path_ / "c");
    EXPECT_EQ(facts_of(file)->identity, facts_of((path_ / "b").string())->identity);
    EXPECT_EQ(facts_of(file)->identity, facts_of((path_ / "c").string())->identity);
    EXPECT_NE(facts_of(file)->identity, facts_of(written("d", "x"))->identity);
    EXPECT_EQ(facts_of(path_.string())->kind, FileKind::folder);
    EXPECT_EQ(facts_of("/dev/null")->kind, FileKind::device);
    EXPECT_FALSE(facts_of((path_ / "none").string()));
}

TEST_F(Files, WhenMissingGiveTheReason) {
    EXPECT_EQ(ReadableFile((path_ / "none").string()).failure(), std::errc::no_such_file_or_directory);
    std::error_code failure;
    EXPECT_EQ(new_folder((path_ / "none" / "a").string(), failure), "");
    EXPECT_EQ(failure, std::errc::no_such_file_or_directory);
    EXPECT_LT(lock_folder((path_ / "none").string()), 0);
}

TEST_F(Files, AreExecutableOnlyWithPermission) {
    const auto script = written("script", "#!/bin/sh\n");
    EXPECT_FALSE(is_executable(script));
    fs::permissions(script, fs::perms::owner_all);
    EXPECT_TRUE(is_executable(script));
}

TEST_F(Processes, RunInTheGivenFolderWithTheGivenEnvironment) {
    const auto words = (path_ / "words").string();
    const auto end = run({.words = {"sh", "-c", "echo $COLOUR; pwd; echo wrong >&2; exit 3"},
                          .environment = {"COLOUR=blue", "PATH=/usr/bin:/bin"},
                          .folder = path_.string(),
                          .output = words});
    EXPECT_EQ(end.exit_code, 3);
    EXPECT_FALSE(end.well());
    std::ifstream file(words);
    std::string colour, folder, wrong;
    std::getline(file, colour);
    std::getline(file, folder);
    std::getline(file, wrong);
    EXPECT_EQ(colour, "blue");
    EXPECT_EQ(fs::path(folder), fs::canonical(path_));
    EXPECT_EQ(wrong, "wrong");
}

TEST_F(Processes, WhenNotStartedGiveTheReason) {
    const auto end = run({.words = {"no-such-program"}, .environment = {}, .folder = ".", .output = "/dev/null"});
    EXPECT_EQ(end.start, std::errc::no_such_file_or_directory);
}

TEST_F(Processes, OfTheShellReturnOutputOrNothing) {
    EXPECT_EQ(output_of("echo yes"), "yes\n");
    EXPECT_EQ(output_of("echo no; exit 1"), std::nullopt);
}

TEST_F(Processes, InAChildDoNotChangeTheParent) {
    int here = 0;
    EXPECT_TRUE(run_in_child([&] { here = 1; }, 10)->well());
    EXPECT_EQ(here, 0);
    EXPECT_TRUE(run_in_child([] { throw std::runtime_error("lost"); }, 10)->well());
    EXPECT_EQ(run_in_child([] { std::_Exit(4); }, 10)->exit_code, 4);
    const auto killed = run_in_child([] { std::abort(); }, 10);
    EXPECT_NE(killed->signal.find("signal 6"), std::string::npos) << killed->signal;
    const auto endless = run_in_child([] { std::this_thread::sleep_for(std::chrono::minutes(1)); }, 1);
    EXPECT_TRUE(endless->out_of_time);
}

TEST_F(Processes, OfAForkFindTheMutexFree) {
    static std::mutex own;
    static std::mutex& mutex = free_in_every_child(own);
    std::atomic<bool> over{false};
    std::thread other([&] {
        while (!over) {
            const std::lock_guard lock(mutex);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    });
    for (int child = 0; child < 20; ++child)
        EXPECT_TRUE(run_in_child([] { const std::lock_guard lock(mutex); }, 10)->well());
    over = true;
    other.join();
}

TEST_F(Processes, AreGoneOnlyAfterTheyEnd) {
    EXPECT_FALSE(is_gone(this_process()));
    EXPECT_TRUE(is_gone(999'999'999));
}

TEST(Memory, OfTheMachineIsPositive) {
    EXPECT_GT(memory_of_machine(), std::uint64_t{1} << 26);
    std::string text(1 << 22, 'a');
    prefer_large_pages(text.data(), text.size());
    EXPECT_EQ(text.back(), 'a');
}

TEST(Libraries, AreLoadedOrGiveTheReason) {
    EXPECT_EQ(loaded_library("libnone.so.0"), nullptr);
    EXPECT_NE(loading_error().find("libnone"), std::string::npos);
    auto* const own = loaded_library(nullptr);
    EXPECT_NE(function_of(own, "malloc"), nullptr);
    EXPECT_EQ(function_of(own, "no_such_function"), nullptr);
}

TEST(Terminal, HasNoColumnsForOtherOutput) {
    for (const auto stream : {Stream::output, Stream::errors}) {
        if (!is_terminal(stream)) {
            EXPECT_EQ(columns_of(stream), 0u);
        }
    }
}

}  // namespace
}  // namespace setae::platform::platform_test
