// SPDX-License-Identifier: GPL-3.0-or-later
// Every file of instruments there is: opened and consistent, or refused for the reason it should be.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>

#include <gtest/gtest.h>

#include "reference_data.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/format.hpp"

namespace setae::formats::every_file_test {
namespace {

namespace fs = std::filesystem;

/// Files that are no topographies, with what must be said of them.
const std::map<std::string, std::string>& refused() {
    static const std::map<std::string, std::string> files{
        {"di_corrupted.di", "at byte 489346"},
        {"nonsense_txt_file.txt", "text without a row of numbers"},
        {"wrongnpyfile.npy", "which no supported format does"},
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

/// Size and unit that a user would give for a file without them.
ReadOptions said_by_the_user(const fs::path& path) {
    ReadOptions options{.unit = "nm"};
    const auto listed = open(path.string(), options);
    const auto& info = listed.front().info;
    if (info.size.empty()) options.size = std::vector<double>(info.shape.size(), 1e-6);
    return options;
}

bool looks_like_text_file(const std::string& content) {
    return std::none_of(content.begin(), content.end(), [](char c) { return c >= 0 && c < 9; });
}

void expect_consistent(const Channel& channel) {
    const auto& info = channel.info;
    SCOPED_TRACE(info.format + ": " + info.name);
    if (!info.is_height) return;
    const auto measurement = channel.read();
    EXPECT_NO_THROW(topography::validate(measurement));
    const auto [nx, ny] = topography::shape(measurement);
    EXPECT_EQ(info.shape, (std::holds_alternative<topography::HeightMap>(measurement) ? std::vector<Index>{nx, ny}
                                                                                      : std::vector<Index>{nx}));
    EXPECT_FALSE(info.unit.empty());
    const auto& metadata = topography::metadata(measurement);
    EXPECT_EQ(metadata.unit, info.unit);
    EXPECT_EQ(metadata.format, info.format);
}

TEST(EveryFile, OpensOrIsRefusedForTheExpectedReason) {
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
            if (reason == refused().end()) ADD_FAILURE() << error.what();
            else EXPECT_NE(std::string(error.what()).find(reason->second), std::string::npos) << error.what();
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

TEST(EveryFile, LargerThanTwoMegabytesOpensFromLessThanOneMegabyte) {
    if (bytes_read() == 0) GTEST_SKIP() << "this system does not count the bytes a process reads";
    int looked_at = 0;
    for (const auto& path : all_files()) {
        const bool text = path.extension() == ".txt" || path.extension() == ".csv";
        const bool compressed = path.extension() == ".mnt";  // what its objects are stands in the stream of their data
        if (fs::file_size(path) < 2'000'000 || text || compressed || refused().contains(path.filename().string()))
            continue;
        SCOPED_TRACE(path.string());
        const auto before = bytes_read();
        (void)open(path.string(), {.unit = "nm"});
        EXPECT_LT(bytes_read() - before, 1'000'000u);
        ++looked_at;
    }
    if (looked_at == 0) GTEST_SKIP() << "no files of instruments in " << tests::reference_data_folder();
}

/// The error of opening and reading all channels of bytes; empty if they are read.
std::string error_of(const std::string& content, const ReadOptions& options) {
    try {
        for (const auto& channel : open(bytes::memory_source("cut", content), options))
            if (channel.info.is_height || !channel.info.alerts.empty()) (void)channel.read();
    } catch (const FormatError& error) {
        return error.what();
    }
    return {};
}

TEST(EveryFile, TruncatedAnywhereIsRefusedWithTheOffset) {
    constexpr std::size_t cuts = 64;
    // bytes at the end that programs add for themselves and no header announces
    const std::map<std::string, std::size_t> footers{{"spot_1-1000nm.ibw", 110'000}, {"plu-1.plu", 133'200}};
    int looked_at = 0;
    for (const auto& path : all_files()) {
        if (refused().contains(path.filename().string())) continue;
        const auto content = bytes::read_file(path.string());
        if (looks_like_text_file(content) || path.extension() == ".csv")
            continue;  // a shorter text, also in UTF-16, is a whole one, too
        const auto footer = footers.find(path.filename().string());
        const auto announced = content.size() - (footer == footers.end() ? 0 : footer->second);
        SCOPED_TRACE(path.string());
        const auto options = said_by_the_user(path);
        for (std::size_t k = 0; k < cuts; ++k) {
            const auto length = content.size() * k / cuts;
            if (length >= announced) break;
            const auto error = error_of(content.substr(0, length), options);
            // what is left may look like text, whose places are lines
            const bool has_place =
                error.find("at byte ") != std::string::npos || std::regex_search(error, std::regex("^cut:[0-9]+: "));
            EXPECT_TRUE(has_place) << "cut at " << length << " of " << content.size() << ": '" << error << "'";
        }
        ++looked_at;
    }
    if (looked_at == 0) GTEST_SKIP() << "no files of instruments in " << tests::reference_data_folder();
}

}  // namespace
}  // namespace setae::formats::every_file_test
