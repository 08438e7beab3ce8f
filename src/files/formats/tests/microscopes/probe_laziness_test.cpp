// SPDX-License-Identifier: GPL-3.0-or-later
#include <stdexcept>

#include <gtest/gtest.h>

#include "counted_source.hpp"
#include "format_samples.hpp"
#include "igor_builder.hpp"
#include "setae/formats/format.hpp"
#include "tiff_builder.hpp"

using namespace setae::tests;

namespace setae::formats::tests::probe_laziness_test {
namespace {

constexpr std::uint64_t gigabyte = 1'000'000'000, megabyte = 1'000'000;

std::string replaced(std::string content, const std::string& from, const std::string& to) {
    for (auto at = content.find(from); at != std::string::npos; at = content.find(from, at + to.size()))
        content.replace(at, from.size(), to);
    return content;
}

/// The header of the sample of that format and name.
std::string sample_text(const std::vector<FormatSample>& samples, const std::string& name) {
    for (const auto& sample : samples)
        if (sample.name == name) return sample.content;
    throw std::runtime_error("no sample " + name);
}

std::string large_nanoscope_header() {
    const auto header = sample_text(nanoscope_samples(), "2 bytes");
    return replaced(replaced(replaced(header.substr(0, 2048), "Data length: 56", "Data length: 480000000"),
                             "Samps/line: 7", "Samps/line: 20000"),
                    "Number of lines: 4", "Number of lines: 12000");
}

void expect_lazy(const std::string& head, Index nx, Index ny) {
    const CountedSource large(head, gigabyte);
    const auto channels = formats::open(large.source(), {});
    EXPECT_EQ(channels.back().info.shape, (std::vector<Index>{nx, ny}));
    EXPECT_TRUE(channels.back().info.is_height);
    EXPECT_LT(large.bytes(), megabyte);
}

TEST(ScanningProbeFormats, OpenAGigabyteWithLessThanAMegabyte) {
    expect_lazy(large_nanoscope_header(), 20000, 12000);
    const auto mi = sample_text(mi_samples(), "BINARY_32");
    expect_lazy(replaced(replaced(mi.substr(0, mi.find("BINARY_32\n") + 10), "xPixels       8", "xPixels       10000"),
                         "yPixels       5", "yPixels       9000"),
                10000, 9000);
    const auto nanosurf = sample_text(nanosurf_samples(), "int16");
    expect_lazy(replaced(replaced(nanosurf.substr(0, nanosurf.find("#!") + 2), "Points=6", "Points=12000"), "Lines=4",
                         "Lines=11000"),
                12000, 11000);
    const IgorContent wave{.points = {15000, 14000, 1, 0},
                           .step = {1e-9, 1e-9, 1, 1},
                           .data_unit = "m",
                           .lateral_unit = "m",
                           .numbers_bytes = 4 * 15000 * 14000};
    expect_lazy(igor_wave_5(std::endian::little, wave), 15000, 14000);
    TiffPageBuilder thumbnail(std::endian::big), page(std::endian::big);
    thumbnail.picture(2, 2, 8, 1)
        .strips(2, {std::string(4, 'x')})
        .real(0x8042, 1e-6)
        .real(0x8043, 1e-6)
        .text(0x8050, "thumbnail");
    page.picture(16000, 15000, 32, 2)
        .longs(278, {15000})
        .longs(273, {4096})
        .longs(279, {4 * 16000 * 15000})
        .text(0x8052, "Height")
        .signed_long(0x8080, 1);
    page.text(0x8090, "calibrated").text(0x80a2, "m").text(0x80a3, "LinearScaling").real(0x80a4, 1e-12);
    expect_lazy(tiff_file(std::endian::big, {thumbnail, page}), 16000, 15000);
}

}  // namespace
}  // namespace setae::formats::tests::probe_laziness_test
