// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/protected_inputs.hpp"

#include <gtest/gtest.h>

#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "setae/bytes/source.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"

namespace setae::bytes::protected_inputs_test {
namespace {

namespace fs = std::filesystem;

class ProtectedFiles : public testing::Test {
protected:
    void SetUp() override {
        folder = fs::temp_directory_path() / ("setae_files_" + std::to_string(getpid()) +
                                              testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::create_directories(folder);
        std::ofstream(path("input")) << "measured";
    }
    void TearDown() override { fs::remove_all(folder); }
    [[nodiscard]] std::string path(const std::string& name) const { return (folder / name).string(); }
    [[nodiscard]] std::string refusal(const std::string& name) const {
        try {
            write_whole_file(path(name), "computed");
        } catch (const FileError& error) {
            return error.what();
        }
        return "";
    }

    fs::path folder;
};

TEST_F(ProtectedFiles, ThatWereReadAreNotReplacedUnderAnyName) {
    const ProtectedInputs inputs;
    fs::create_symlink("input", path("symbolic"));
    fs::create_symlink("symbolic", path("twice"));
    fs::create_hard_link(path("input"), path("hard"));
    (void)read_file(path("input"));
    for (const auto* name : {"input", "symbolic", "twice", "hard"})
        EXPECT_NE(refusal(name).find("is an input of this run"), std::string::npos) << name;
    EXPECT_EQ(read_back(path("input")), "measured");
    EXPECT_EQ(refusal("other"), "");
}

TEST_F(ProtectedFiles, OfAFinishedRunMayBeReplaced) {
    {
        const ProtectedInputs inputs;
        protect_input(path("input"));
        EXPECT_THROW(require_no_input(path("input")), FileError);
    }
    EXPECT_EQ(refusal("input"), "");
    EXPECT_EQ(read_back(path("input")), "computed");
}

TEST_F(ProtectedFiles, ReadBackByTheProgramAreNotInputs) {
    const ProtectedInputs inputs;
    (void)read_back(path("input"));
    EXPECT_EQ(refusal("input"), "");
}

// Systems reuse the number of a removed file.
TEST_F(ProtectedFiles, ThatWereRemovedAreNoLongerProtected) {
    const ProtectedInputs inputs;
    protect_input(path("input"));
    fs::remove(path("input"));
    std::ofstream(path("new")) << "of another";
    EXPECT_EQ(refusal("new"), "");
}

TEST_F(ProtectedFiles, AreRefusedAtOnceIfPipesOrCircularLinks) {
    ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
    fs::create_symlink("circle", path("circle"));
    const auto reason = [&](const std::string& what) {
        try {
            (void)file_source(what);
        } catch (const FileError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(reason(path("pipe")), path("pipe") + ": is a pipe, expected a regular file");
    EXPECT_EQ(reason("/dev/zero"), "/dev/zero: is a device, expected a regular file");
    EXPECT_EQ(reason(folder.string()), folder.string() + ": is a folder, expected a regular file");
    EXPECT_EQ(reason(path("circle")), path("circle") + ": its symbolic links form a loop");
    EXPECT_EQ(reason(path("none")), path("none") + ": no such file");
    EXPECT_NE(reason(path("input/below")).find("not a folder"), std::string::npos);
    EXPECT_NE(reason(path(std::string(300, 'x'))).find("name is too long"), std::string::npos);
    for (const auto* name : {"pipe", "."})
        EXPECT_NE(refusal(name).find("expected the name of a file"), std::string::npos);
    EXPECT_THROW(write_whole_file("/dev/null", ""), FileError);
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(ProtectedFiles, BehindLinksAreReplacedAndLinksRemain) {
    fs::create_symlink("input", path("link"));
    write_whole_file(path("link"), "computed");
    EXPECT_TRUE(fs::is_symlink(path("link")));
    EXPECT_EQ(read_back(path("input")), "computed");
}

TEST_F(ProtectedFiles, SparseBeyondMemoryAreNotReadWhole) {
    fs::resize_file(path("input"), std::uintmax_t{1} << 42);
    EXPECT_THROW((void)read_file(path("input")), FormatError);
    EXPECT_EQ(file_source(path("input")).head(8), "measured");
}

}  // namespace
}  // namespace setae::bytes::protected_inputs_test
