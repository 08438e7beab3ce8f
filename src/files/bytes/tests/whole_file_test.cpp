// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/whole_file.hpp"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <set>
#include <thread>
#include <vector>

#include "setae/bytes/source.hpp"
#include "setae/bytes/temporary_folder.hpp"
#include "setae/core/errors.hpp"

namespace setae::bytes::whole_file_test {
namespace {

namespace fs = std::filesystem;

class WholeFileTest : public testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder); }
    void TearDown() override { fs::remove_all(folder); }
    [[nodiscard]] std::string path(const std::string& name) const { return (folder / name).string(); }
    void put(const std::string& name, const std::string& content) const {
        std::ofstream(folder / name, std::ios::binary) << content;
    }
    /// As programs save: a new file replaces the old one.
    void replace(const std::string& name, const std::string& content) const {
        put(name + ".new", content);
        fs::rename(folder / (name + ".new"), folder / name);
    }

    const fs::path folder = fs::temp_directory_path() / ("setae_whole_file_" + std::to_string(getpid()));
};

TEST_F(WholeFileTest, RemovesOnlyTemporaryFilesOfDeadProcesses) {
    const pid_t dead = fork();
    if (dead == 0) _exit(0);
    ASSERT_EQ(waitpid(dead, nullptr, 0), dead);
    const auto temporary = [](const std::string& name, pid_t writer) {
        return name + "." + std::to_string(writer) + "-0123456789abcdef.part";
    };
    const auto of_dead = temporary("study.json", dead);
    const std::set<std::string> of_others{temporary("study.json", getpid()), temporary("notes", dead),
                                          "study.json." + std::to_string(dead) + ".1.part", "study.json.part",
                                          "study.json"};
    put(of_dead, "x");
    for (const auto& name : of_others) put(name, "x");
    remove_leftovers(folder.string(), {"study.json"});
    EXPECT_FALSE(fs::exists(folder / of_dead));
    for (const auto& name : of_others) EXPECT_TRUE(fs::exists(folder / name)) << name;
    remove_leftovers(path("none"), {"study.json"});  // no folder, no action
}

TEST_F(WholeFileTest, IsReadToItsEndWhileBeingReplaced) {
    put("a", std::string(1000, 'a'));
    const auto source = file_source(path("a"));
    EXPECT_EQ(source.bytes(0, 10), std::string(10, 'a'));
    replace("a", std::string(1000, 'b'));
    EXPECT_EQ(source.bytes(500, 10), std::string(10, 'a'));
    EXPECT_EQ(read_file(path("a")), std::string(1000, 'b'));
}

TEST_F(WholeFileTest, AmongManyOpenFilesIsRefusedAfterReplacement) {
    std::vector<Source> others;
    for (int i = 0; i < 200; ++i) {
        put(std::to_string(i), "x");
        others.push_back(file_source(path(std::to_string(i))));
    }
    put("a", std::string(1000, 'a'));
    const auto source = file_source(path("a"));
    replace("a", std::string(1000, 'b'));
    EXPECT_THROW((void)source.bytes(0, 10), FileError);
}

TEST_F(WholeFileTest, IsRefusedWhileAnotherProgramWritesIt) {
    put("a", std::string(1000, 'a'));
    const auto source = file_source(path("a"));
    EXPECT_EQ(source.bytes(0, 10), std::string(10, 'a'));
    std::ofstream(folder / "a", std::ios::app) << "more";
    EXPECT_THROW((void)source.bytes(500, 10), FileError);
}

TEST_F(WholeFileTest, MayBeOneOfMoreFilesThanTheLimitOfOpenFiles) {
    constexpr int count = 3000;
    std::vector<Source> sources;
    for (int i = 0; i < count; ++i) {
        put(std::to_string(i), std::to_string(i));
        sources.push_back(file_source(path(std::to_string(i))));
    }
    for (int i = 0; i < count; ++i) EXPECT_EQ(sources[i].all(), std::to_string(i));
}

TEST_F(WholeFileTest, KeepsItsPermissions) {
    put("a", "old");
    fs::permissions(folder / "a", fs::perms::owner_read | fs::perms::owner_write);
    write_whole_file(path("a"), "new");
    EXPECT_EQ(read_back(path("a")), "new");
    EXPECT_EQ(fs::status(folder / "a").permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(WholeFileTest, CanHaveTheLongestName) {
    const std::string name(255, 'a');
    write_whole_file(path(name), "x");
    EXPECT_EQ(read_back(path(name)), "x");
}

TEST_F(WholeFileTest, HasAnUnpredictableTemporaryName) {
    std::set<std::string> names;
    for (int i = 0; i < 2; ++i)
        write_whole_file(path("a"), [&](const std::string& temporary) {
            EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(temporary))) << "it is made before it is written";
            const auto digits = temporary.substr(temporary.size() - std::string("0123456789abcdef.part").size(), 16);
            names.insert(digits);
        });
    EXPECT_EQ(names.size(), 2);
}

TEST_F(WholeFileTest, StateDiffersAfterEveryChange) {
    put("a", "1234");
    const auto state = file_state(path("a"));
    EXPECT_EQ(file_state(path("a")), state);
    const auto time = fs::last_write_time(folder / "a");
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    put("a", "5678");
    fs::last_write_time(folder / "a", time);  // as programs do that copy files
    EXPECT_NE(file_state(path("a")), state);
    EXPECT_EQ(file_state(path("none")), "");
}

TEST_F(WholeFileTest, TemporaryFolderIsUniqueAndRemovedWithItsContent) {
    fs::path gone;
    {
        const TemporaryFolder one("test"), other("test");
        EXPECT_NE(one.path(), other.path());
        gone = one.path();
        EXPECT_EQ(fs::status(gone).permissions(), fs::perms::owner_all);
        std::ofstream(one.file("x")) << "x";
        EXPECT_TRUE(fs::exists(gone / "x"));
    }
    EXPECT_FALSE(fs::exists(gone));
}

}  // namespace
}  // namespace setae::bytes::whole_file_test
