// SPDX-License-Identifier: GPL-3.0-or-later
// A study killed or stopped at any moment goes on where it was and ends with the same bytes.
//
//   SETAE_KILLS   moments at which it is killed; default 3
//   SETAE_SEED    of the moments; default 1
//   SETAE_STUDY   a study of your own; default: a small data set of `setae lab make`
#include <gtest/gtest.h>

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "setae/bytes/digest.hpp"
#include "setae/bytes/whole_file.hpp"

namespace setae {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

std::string variable(const char* name, const std::string& otherwise) {
    const char* value = std::getenv(name);
    return value && *value ? value : otherwise;
}

/// The program with arguments, started; its words into a file.
pid_t started(std::vector<std::string> words, const std::string& log) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    words.insert(words.begin(), SETAE_PROGRAM);
    std::vector<char*> arguments;
    for (auto& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    pid_t process = 0;
    EXPECT_EQ(posix_spawn(&process, SETAE_PROGRAM, &actions, nullptr, arguments.data(), environ), 0);
    posix_spawn_file_actions_destroy(&actions);
    return process;
}

int status_of(pid_t process) {
    int status = 0;
    waitpid(process, &status, 0);
    return status;
}

/// Name and digest of every file below a folder, in order.
std::string content_of(const fs::path& folder) {
    std::vector<std::string> lines;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            lines.push_back(fs::relative(entry.path(), folder).string() + " " +
                            bytes::sha256(bytes::read_file(entry.path().string())) + "\n");
    std::sort(lines.begin(), lines.end());
    std::string text;
    for (const auto& line : lines) text += line;
    return text;
}

class StoppedStudy : public testing::Test {
protected:
    void SetUp() override {
        folder = fs::temp_directory_path() / ("setae_stopped_" + std::to_string(getpid()));
        fs::create_directories(folder);
        setenv("SOURCE_DATE_EPOCH", "1700000000", 1);
        study = variable("SETAE_STUDY", (folder / "data/study.toml").string());
        if (!std::getenv("SETAE_STUDY")) {
            ASSERT_EQ(status_of(started(
                          {"lab", "make", "tests/cli/data/recipe_two_surfaces.toml", "-o", (folder / "data").string()},
                          log())),
                      0);
        }
    }
    void TearDown() override { fs::remove_all(folder); }

    [[nodiscard]] std::string log() const { return (folder / "log").string(); }
    [[nodiscard]] std::string out() const { return (folder / "out").string(); }
    [[nodiscard]] pid_t start(const std::string& cache, bool kept = true) const {
        std::vector<std::string> words{"study", study, "--output", out(), "--progress", "none"};
        if (kept) words.insert(words.end(), {"--cache", (folder / cache).string()});
        else words.push_back("--no-cache");
        return started(words, log());
    }
    /// What an undisturbed run writes, and how long it takes.
    [[nodiscard]] std::pair<std::string, double> undisturbed() const {
        const auto begin = Clock::now();
        EXPECT_EQ(status_of(start("", false)), 0) << bytes::read_file(log());
        const double duration = std::chrono::duration<double>(Clock::now() - begin).count();
        auto content = content_of(out());
        fs::remove_all(out());
        return {content, duration};
    }

    fs::path folder;
    std::string study;
};

TEST_F(StoppedStudy, KilledAtAnyMomentEndsWithTheSameBytes) {
    const auto [content, duration] = undisturbed();
    std::mt19937_64 random(std::stoull(variable("SETAE_SEED", "1")));
    const int kills = std::stoi(variable("SETAE_KILLS", "3"));
    for (int kill_number = 0; kill_number < kills; ++kill_number) {
        const auto cache = "cache" + std::to_string(kill_number);
        const double moment = duration * static_cast<double>(random() % 10000) / 10000.0;
        const pid_t process = start(cache);
        std::this_thread::sleep_for(std::chrono::duration<double>(moment));
        kill(process, SIGKILL);
        const int killed = status_of(process);
        // the file that marks completeness is written last
        if (fs::exists(out() + "/report.html")) {
            EXPECT_EQ(content_of(out()), content) << "complete after " << moment << " s, but it is not";
        }
        const auto begin = Clock::now();
        ASSERT_EQ(status_of(start(cache)), 0) << bytes::read_file(log());
        const double rest = std::chrono::duration<double>(Clock::now() - begin).count();
        EXPECT_EQ(content_of(out()), content) << "killed after " << moment << " s";
        std::printf("killed %s after %5.2f of %.2f s, the rest took %5.2f s\n",
                    WIFSIGNALED(killed) ? "      " : "(late)", moment, duration, rest);
        fs::remove_all(out());
        fs::remove_all(folder / cache);
    }
}

TEST_F(StoppedStudy, InterruptedLeavesCompleteFilesAndCanContinue) {
    const auto [content, duration] = undisturbed();
    const pid_t process = start("cache");
    std::this_thread::sleep_for(std::chrono::duration<double>(0.4 * duration));
    kill(process, SIGINT);
    const int status = status_of(process);
    ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT) << bytes::read_file(log());
    EXPECT_NE(bytes::read_file(log()).find("repeat the command to continue"), std::string::npos)
        << bytes::read_file(log());
    for (const auto& file : fs::recursive_directory_iterator(folder))
        EXPECT_NE(file.path().extension(), ".part") << file.path();
    EXPECT_FALSE(fs::exists(out() + "/report.html"));
    ASSERT_EQ(status_of(start("cache")), 0) << bytes::read_file(log());
    EXPECT_EQ(content_of(out()), content);
}

}  // namespace
}  // namespace setae
