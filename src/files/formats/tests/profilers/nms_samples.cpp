// SPDX-License-Identifier: GPL-3.0-or-later
#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "setae/core/constants.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

constexpr int nx = 7, ny = 4;
constexpr double lowest = -2.5, highest = 7.5, pitch_x = 312.5, pitch_y = 625.0;  // [µm], [nm]

FormatSample sample(const std::string& name, const std::string& program, bool with_picture) {
    const Array2D raw = lopsided_heights(nx, ny, 150.0);
    ByteBuilder file;
    file.number<std::uint32_t>(2)
        .number<std::uint32_t>(1)
        .number<std::uint32_t>(0)
        .number<std::uint32_t>(65535)
        .number(lowest)
        .number(highest)
        .text_at(32, program)
        .text_at(52, "Confocal Height Image");
    file.text_at(1076, "2022-02-09T13:25")
        .number_at<std::uint32_t>(1352, 3468)
        .number_at<std::uint32_t>(1368, nx)
        .number_at<std::uint32_t>(1372, ny);
    file.number_at(1376, pitch_x).number_at(1384, pitch_y).pad_to(3468).rows<std::uint16_t>(raw);
    if (with_picture) file.text(std::string(nx * ny, 'p'));
    return {.format = "nms",
            .name = name,
            .content = file.content(),
            .shape = {nx, ny},
            .size = {nx * pitch_x * units::nm, ny * pitch_y * units::nm},
            .heights = (lowest + raw / 65534.0 * (highest - lowest)) * units::um,
            .may_lose_its_end = with_picture};
}

}  // namespace

std::vector<FormatSample> nms_samples() {
    return {sample("heights", "OM_MS_2.0", false), sample("heights and picture", "OM_MS_2.0", true),
            sample("of an unknown program", "", false)};
}

}  // namespace setae::formats::tests
