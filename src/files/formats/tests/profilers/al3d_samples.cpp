// SPDX-License-Identifier: GPL-3.0-or-later
#include "al3d_samples.hpp"

#include <fmt/format.h>

#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "setae/core/constants.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

using namespace std::string_view_literals;

constexpr double dx = 4.38027e-07, dy = 5.5e-07;
constexpr std::size_t icon_bytes = 68;

ByteBuilder& tag(ByteBuilder& file, const std::string& key, const std::string& value) {
    return file.text(key, 20).text(value, 30).text("\r\n");
}

FormatSample sample(const char* name, Index nx) {
    constexpr Index ny = 4;
    auto heights = lopsided_heights(nx, ny, units::um);
    auto stored = heights;
    heights(2, 1) = undefined;
    stored(2, 1) = 3e15;
    heights(nx - 1, 3) = undefined;
    stored(nx - 1, 3) = undefined;
    return {.format = "al3d",
            .name = name,
            .content = al3d_file(
                stored, {{"CreatingApplication", "MeasureSuite 5.3.6"}, {"InvalidPixelValue", "3.000000028082e+15"}}),
            .shape = {nx, ny},
            .size = {dx * static_cast<double>(nx), dy * ny},
            .heights = heights,
            .tolerance = 1e-7};
}

}  // namespace

std::string al3d_file(const Array2D& heights, std::vector<std::pair<std::string, std::string>> tags) {
    tags.insert(tags.begin(), {{"Cols", fmt::format("{}", heights.rows())},
                               {"Rows", fmt::format("{}", heights.cols())},
                               {"PixelSizeXMeter", "4.38027e-07"},
                               {"PixelSizeYMeter", "5.5e-07"}});
    const std::size_t head = 17 + (2 + tags.size() + 3) * 52 + 256;
    const std::size_t depth = head + icon_bytes, row = (static_cast<std::size_t>(heights.rows()) * 4 + 7) / 8 * 8;
    tags.emplace_back("IconOffset", fmt::format("{}", head));
    tags.emplace_back("DepthImageOffset", fmt::format("{}", depth));
    tags.emplace_back("TextureImageOffset", fmt::format("{}", depth + row * static_cast<std::size_t>(heights.cols())));
    ByteBuilder file;
    file.text("AliconaImaging\0\r\n"sv);
    tag(file, "Version", "1");
    tag(file, "TagCount", fmt::format("{}", tags.size()));
    for (const auto& [key, value] : tags) tag(file, key, value);
    file.text("polished", 254).text("\r\n").text("icon", icon_bytes, '\x7f');
    for (Index j = 0; j < heights.cols(); ++j) {
        for (Index i = 0; i < heights.rows(); ++i) file.number(static_cast<float>(heights(i, j)));
        if (heights.rows() % 2 == 1) file.number(1e9f);
    }
    return file.text("texture", static_cast<std::size_t>((heights.rows() + 7) / 8 * 8 * heights.cols()), '\x55')
        .content();
}

std::vector<FormatSample> al3d_samples() { return {sample("padded rows", 5), sample("rows without padding", 6)}; }

}  // namespace setae::formats::tests
