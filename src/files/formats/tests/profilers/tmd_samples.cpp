// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "setae/core/constants.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

constexpr int nx = 7, ny = 4;
constexpr float length_x = 1.75f, length_y = 2.0f;

FormatSample sample(const std::string& name, const std::string& comment, const std::optional<std::string>& unit,
                    double factor) {
    Array2D values = lopsided_heights(nx, ny, 0.25);
    Array2D heights = values * factor;
    values(4, 2) = std::numeric_limits<double>::quiet_NaN();
    heights(4, 2) = undefined;
    ByteBuilder file;
    file.text("Binary TrueMap Data File v2.0\r\n", 32)
        .text(comment)
        .number<std::uint32_t>(nx)
        .number<std::uint32_t>(ny)
        .number(length_x)
        .number(length_y)
        .number(0.5f)
        .number(0.0f)
        .rows<float>(values);
    return {.format = "tmd",
            .name = name,
            .content = file.content(),
            .options = {.size = {}, .unit = unit},
            .shape = {nx, ny},
            .size = {static_cast<double>(length_x) * factor, static_cast<double>(length_y) * factor},
            .heights = heights};
}

}  // namespace

std::vector<FormatSample> tmd_samples() {
    using namespace std::string_literals;
    return {sample("TrueMap", "Created by TrueMap v6\r\n\0"s, {}, units::mm),
            sample("GelSight, no comment", "\0"s, {}, units::mm),
            sample("comment filled up with zeros", "plate\0"s + std::string(18, '\0'), {}, units::mm),
            sample("unit given", "in micrometres\0"s, "um", units::um)};
}

}  // namespace setae::formats::tests
