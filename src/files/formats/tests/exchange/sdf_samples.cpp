// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdint>
#include <limits>

#include <fmt/format.h>

#include "byte_builder.hpp"
#include "format_samples.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr Index nx = 5, ny = 3;

ByteBuilder header(std::uint8_t type, double z_scale, const char* magic = "bISO-1.0", std::uint32_t points = nx,
                   std::uint32_t profiles = ny) {
    ByteBuilder bytes;
    bytes.text(magic).text("Maker", 10, ' ').text("040120100853").text("050320101353");
    if (std::string_view(magic).ends_with("2.0")) {
        bytes.number(points).number(profiles);
    } else {
        bytes.number(static_cast<std::uint16_t>(points)).number(static_cast<std::uint16_t>(profiles));
    }
    return bytes.number(1e-6)
        .number(2e-6)
        .number(z_scale)
        .number(1e-9)
        .number(std::uint8_t{0})
        .number(type)
        .number(std::uint8_t{0});
}

FormatSample sample(const std::string& name, std::string content, Array2D heights, double tolerance = 1e-12) {
    return {.format = "sdf",
            .name = name,
            .content = std::move(content),
            .shape = {nx, ny},
            .size = {5e-6, 6e-6},
            .heights = std::move(heights),
            .tolerance = tolerance};
}

/// Heights raw · 1e-9 of one type, the point (3, 1) undefined if the type has a value for that.
template <class Value>
FormatSample binary(std::uint8_t type, double undefined_raw) {
    Array2D raw(nx, ny), heights(nx, ny);
    for (Index i = 0; i < nx; ++i)
        for (Index j = 0; j < ny; ++j)
            raw(i, j) = static_cast<double>(1 + 3 * i + 20 * j + (7 * i + 13 * j) % 11) -
                        (std::numeric_limits<Value>::is_signed ? 25.0 : 0.0);
    heights = raw * 1e-9;
    if (!std::isnan(undefined_raw)) {
        raw(3, 1) = undefined_raw;
        heights(3, 1) = nan;
    }
    return sample(fmt::format("type {}", type), header(type, 1e-9).rows<Value>(raw).content(), heights);
}

std::string text_header(int type, double z_scale, const char* end = "\r\n") {
    std::string lines = "aISO-1.0";
    for (const auto& line :
         {std::string("ManufacID   = Maker"), std::string("CreateDate  = 040120100853"),
          std::string("ModDate = 050320101353"), std::string("; a remark with a * in it"),
          fmt::format("NumPoints = {}", nx), fmt::format("NumProfiles = {}", ny), std::string("Xscale = 1.0E-6"),
          std::string("Yscale = 2.0E-6"), fmt::format("Zscale = {}", z_scale), std::string("Zresolution = -1"),
          std::string("Compression = 0"), fmt::format("DataType = {}", type), std::string("CheckType = 0"),
          std::string("*"), std::string()})
        lines += (lines.size() == 8 ? end : "") + line + (line.empty() ? "" : end);
    return lines;
}

FormatSample text(const std::string& name, int type, const char* end) {
    Array2D heights = lopsided_heights(nx, ny, 1e-9);
    auto content = text_header(type, 1e-9, end);
    for (Index j = 0; j < ny; ++j)
        for (Index i = 0; i < nx; ++i)
            content += (i == 3 && j == 1 ? std::string("BAD") : fmt::format("{}", std::lround(heights(i, j) * 1e9))) +
                       (i % 3 == 2 ? end : " ");
    heights(3, 1) = nan;
    auto made = sample(name, content + "*" + end + "OperatorName = Tom" + end + "*" + end, heights);
    made.may_lose_its_end = true;  // the trailer
    return made;
}

FormatSample line() {
    const Array2D heights = lopsided_heights(7, 1, 1e-9);
    return {.format = "sdf",
            .name = "one profile",
            .content = header(7, 1.0, "bISO-1.0", 7, 1).rows<double>(heights).content(),
            .shape = {7},
            .size = {7e-6},
            .heights = heights};
}

}  // namespace

std::vector<FormatSample> sdf_samples() {
    const auto heights = lopsided_heights(nx, ny, 1e-9);
    std::vector<FormatSample> samples{
        binary<std::uint8_t>(0, nan),
        binary<std::uint16_t>(1, 65535.0),
        binary<std::uint32_t>(2, 4294967295.0),
        binary<float>(3, static_cast<double>(std::numeric_limits<float>::lowest())),
        binary<std::int8_t>(4, -128.0),
        binary<std::int16_t>(5, -32768.0),
        binary<std::int32_t>(6, -2147483648.0),
        binary<double>(7, std::numeric_limits<double>::lowest()),
        sample("version 2", header(7, 1.0, "bISO-2.0").rows<double>(heights).content(), heights),
        sample("Olympus",
               header(7, 1.0).number(std::uint32_t{5}).number(std::uint32_t{1}).rows<double>(heights).content(),
               heights),
        text("text of floats", 7, "\r\n"),
        text("text of integers", 5, "\n"),
        line()};
    return samples;
}

}  // namespace setae::formats::tests
