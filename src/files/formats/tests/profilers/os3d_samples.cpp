// SPDX-License-Identifier: GPL-3.0-or-later
#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "setae/core/constants.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

constexpr int nx = 7, ny = 4;
constexpr double spacing_x = 0.5, spacing_y = 1.25;  // [µm]

FormatSample sample(const std::string& name, const std::string& identification, const std::string& picture) {
    Array2D values = lopsided_heights(nx, ny, -0.5);
    Array2D heights = values * units::um;
    values(1, 2) = -3.4028235e38;
    heights(1, 2) = undefined;
    const std::string time = "20180321T101500";
    ByteBuilder file;
    file.text("OmniSurf3D")
        .number<std::int32_t>(1)
        .number<std::int32_t>(1)
        .number(static_cast<std::int32_t>(identification.size()))
        .text(identification);
    file.number(static_cast<std::int32_t>(time.size()))
        .text(time)
        .number<std::int32_t>(nx)
        .number<std::int32_t>(ny)
        .number(spacing_x)
        .number(spacing_y)
        .number(3.0)
        .number(4.0);
    file.rows<float>(values).number<std::uint8_t>(picture.empty() ? 0 : 1).text(picture);
    return {.format = "os3d",
            .name = name,
            .content = file.content(),
            .shape = {nx, ny},
            .size = {nx * spacing_x * units::um, ny * spacing_y * units::um},
            .heights = heights,
            .may_lose_its_end = true};
}

}  // namespace

std::vector<FormatSample> os3d_samples() {
    return {sample("heights", "pen", ""), sample("heights and picture", "", "\x89PNG\r\n")};
}

}  // namespace setae::formats::tests
