// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/whole_file.hpp"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace setae::bytes::whole_file_test {
namespace {

namespace fs = std::filesystem;

TEST(Leftovers, OfDeadWritersGoAndAllElseStays) {
    const auto folder = fs::temp_directory_path() / ("setae_leftovers_" + std::to_string(getpid()));
    fs::create_directories(folder);
    const pid_t dead = fork();
    if (dead == 0) _exit(0);
    ASSERT_EQ(waitpid(dead, nullptr, 0), dead);
    const auto touch = [&](const std::string& name) { std::ofstream(folder / name) << "x"; };
    const auto of_dead = "study.json." + std::to_string(dead) + ".0.part",
               of_us = "study.json." + std::to_string(getpid()) + ".0.part";
    for (const auto& name : {of_dead, of_us, std::string("notes.part"), std::string("study.json")}) touch(name);
    remove_leftovers(folder.string());
    EXPECT_FALSE(fs::exists(folder / of_dead));
    EXPECT_TRUE(fs::exists(folder / of_us));
    EXPECT_TRUE(fs::exists(folder / "notes.part"));
    EXPECT_TRUE(fs::exists(folder / "study.json"));
    remove_leftovers((folder / "none").string());  // no folder, nothing to do
    fs::remove_all(folder);
}

}  // namespace
}  // namespace setae::bytes::whole_file_test
