// SPDX-License-Identifier: GPL-3.0-or-later
#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "setae/core/constants.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

constexpr int nx = 7, ny = 4;
constexpr float step_x = 0.5f, step_y = 0.75f, step_z = 0.0625f;  // [µm]

FormatSample sample(const std::string& name, const std::string& comment) {
    Array2D raw = lopsided_heights(nx, ny, 150.0);
    ByteBuilder file;
    file.text("Zeta-Instruments", 85)
        .number<std::uint32_t>(nx)
        .number<std::uint32_t>(ny)
        .number<std::uint32_t>(0)
        .number(step_x)
        .number(step_y)
        .number(step_z);
    file.pad_to(117)
        .number(static_cast<std::uint32_t>(comment.size()))
        .pad_to(131)
        .text("bump recipe", 68)
        .pad_to(205)
        .text(comment)
        .rows<std::uint16_t>(raw);
    return {.format = "zmg",
            .name = name,
            .content = file.content(),
            .shape = {nx, ny},
            .size = {nx * static_cast<double>(step_x) * units::um, ny * static_cast<double>(step_y) * units::um},
            .heights = raw * (static_cast<double>(step_z) * units::um)};
}

}  // namespace

std::vector<FormatSample> zmg_samples() {
    return {sample("without comment", ""), sample("with comment", "measured twice")};
}

}  // namespace setae::formats::tests
