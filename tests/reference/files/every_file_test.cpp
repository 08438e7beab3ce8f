// SPDX-License-Identifier: GPL-3.0-or-later
// Every file of instruments there is: opened and consistent, or refused for the reason it should be.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>

#include <gtest/gtest.h>

#include "reference_data.hpp"
#include "setae/core/errors.hpp"
#include "setae/io/format.hpp"

namespace setae::io {
namespace {

namespace fs = std::filesystem;

/// Files that are no topographies, with what must be said of them.
const std::map<std::string, std::string>& refused() {
    static const std::map<std::string, std::string> files{
        {"di_corrupted.di", "at byte 489346"},
        {"nonsense_txt_file.txt", "text without a row of numbers"},
        {"wrongnpyfile.npy", "which no format setae reads does"},
        {"ISO5436-sample1_bin.xml", "open the archive instead"},
        {"ISO5436-sample4_bin.xml", "open the archive instead"},
        {"ISO5436-sample2.x3p", "cloud of points"},
        {"ISO5436-sample2.xml", "cloud of points"},
        {"dabam-010.txt", "JSON"},
        {"dabam-011.txt", "JSON"},
        {"dabam-014.txt", "JSON"},
        {"dabam-041.txt", "JSON"},
        {"dabam-045.txt", "JSON"},
    };
    return files;
}

std::vector<fs::path> all_files() {
    std::vector<fs::path> files;
    const auto folder = tests::reference_data_folder() / "topography";
    if (!fs::exists(folder)) return files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

/// What a user would say of a file that leaves its size or unit open.
ReadOptions said_by_the_user(const fs::path& path) {
    ReadOptions options{.unit = "nm"};
    const auto listed = open(path.string(), options);
    const auto& info = listed.front().info;
    if (info.size.empty()) options.size = std::vector<double>(info.shape.size(), 1e-6);
    return options;
}

void expect_consistent(const Channel& channel) {
    const auto& info = channel.info;
    SCOPED_TRACE(info.format + ": " + info.name);
    if (!info.is_height) return;
    const auto measurement = channel.read();
    EXPECT_NO_THROW(topography::validate(measurement));
    const auto [nx, ny] = topography::shape(measurement);
    EXPECT_EQ(info.shape, (std::holds_alternative<topography::HeightMap>(measurement) ? std::vector<Index>{nx, ny} : std::vector<Index>{nx}));
    EXPECT_FALSE(info.unit.empty());
    const auto& metadata = topography::metadata(measurement);
    EXPECT_EQ(metadata.unit, info.unit);
    EXPECT_EQ(metadata.format, info.format);
}

TEST(EveryFile, OpensOrIsRefusedForItsReason) {
    const auto files = all_files();
    if (files.empty()) GTEST_SKIP() << "no files of instruments in " << tests::reference_data_folder();
    for (const auto& path : files) {
        SCOPED_TRACE(path.string());
        const auto reason = refused().find(path.filename().string());
        try {
            const auto channels = open(path.string(), said_by_the_user(path));
            EXPECT_EQ(reason, refused().end()) << "opened";
            EXPECT_FALSE(channels.empty());
            for (const auto& channel : channels) expect_consistent(channel);
        } catch (const Error& error) {
            if (reason == refused().end())
                ADD_FAILURE() << error.what();
            else
                EXPECT_NE(std::string(error.what()).find(reason->second), std::string::npos) << error.what();
        }
    }
}

/// Bytes this process has read from files so far.
std::uint64_t bytes_read() {
    std::ifstream counters("/proc/self/io");
    std::string name;
    std::uint64_t value = 0;
    while (counters >> name >> value)
        if (name == "rchar:") return value;
    return 0;
}

TEST(EveryFile, LargerThanTwoMegabytesOpensFromLessThanOne) {
    if (bytes_read() == 0) GTEST_SKIP() << "this system does not count the bytes a process reads";
    int looked_at = 0;
    for (const auto& path : all_files()) {
        const bool text = path.extension() == ".txt" || path.extension() == ".csv";
        const bool compressed = path.extension() == ".mnt";  // what its objects are stands in the stream of their data
        if (fs::file_size(path) < 2'000'000 || text || compressed || refused().contains(path.filename().string())) continue;
        SCOPED_TRACE(path.string());
        const auto before = bytes_read();
        (void)open(path.string(), {.unit = "nm"});
        EXPECT_LT(bytes_read() - before, 1'000'000u);
        ++looked_at;
    }
    if (looked_at == 0) GTEST_SKIP() << "no files of instruments in " << tests::reference_data_folder();
}

}  // namespace
}  // namespace setae::io
