// SPDX-License-Identifier: GPL-3.0-or-later
#include "plu_samples.hpp"

#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "setae/core/constants.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

constexpr Index nx = 6, ny = 4;

FormatSample sample(const std::string& name, std::uint32_t kind, const std::vector<Array2D>& layers,
                    std::size_t channel) {
    const auto& heights = layers[channel];
    FormatSample sample{.format = "plu",
                        .name = name,
                        .content = plu_file(kind, layers),
                        .channel = channel,
                        .shape = {heights.rows()},
                        .size = {1.5 * units::um * static_cast<double>(heights.rows())},
                        .heights = heights * units::um,
                        .tolerance = 1e-7};
    if (kind == 3) {
        sample.shape.push_back(heights.cols());
        sample.size.push_back(2.0 * units::um * static_cast<double>(heights.cols()));
    }
    // after the heights of the last layer there is a picture that is not read
    sample.may_lose_its_end = true;
    return sample;
}

}  // namespace

std::string plu_file(std::uint32_t kind, const std::vector<Array2D>& layers) {
    ByteBuilder file;
    const auto rows = static_cast<std::uint32_t>(layers[0].cols()),
               columns = static_cast<std::uint32_t>(layers[0].rows());
    file.text("Fri Mar 10 16:35:59 2023", 128).number(std::uint32_t{0x640b4e5f}).text("lapped", 256);
    file.number(rows)
        .number(columns)
        .number(columns)
        .number(28.22f)
        .number(1.5f)
        .number(2.0f)
        .number(-52.0f)
        .number(-6042.0f)
        .number(1.5f)
        .number(142.4f);
    file.number(kind)
        .number(std::uint32_t{3})
        .number(std::uint32_t{0})
        .number(std::uint32_t{14})
        .number(std::uint32_t{3});
    file.number(rows)
        .number(columns)
        .number(rows)
        .number(columns)
        .number(std::uint32_t{1})
        .number(0.06875)
        .number(55.6f)
        .number(std::uint32_t{23})
        .number(std::uint32_t{0});
    file.number(std::uint8_t{0})
        .number(static_cast<std::uint8_t>(layers.size()))
        .number(std::uint8_t{0xfb})
        .number(std::uint8_t{6})
        .number(std::uint8_t{1})
        .text("", 3)
        .number(std::uint32_t{1});
    for (const auto& layer : layers) {
        file.number(rows).number(columns);
        file.rows<float>(layer.isNaN().select(1000001.0, layer));
        const double least = layer.isNaN().select(1e9, layer).minCoeff(),
                     greatest = layer.isNaN().select(-1e9, layer).maxCoeff();
        file.number(static_cast<float>(least))
            .number(static_cast<float>(greatest))
            .text("picture", 3 * rows * columns, '\x33');
    }
    return file.content();
}

std::vector<FormatSample> plu_samples() {
    auto map = lopsided_heights(nx, ny, 0.25);
    map(1, 2) = undefined;
    auto line = lopsided_heights(9, 1, 0.5);
    line(0, 0) = undefined;
    return {sample("topography", 3, {map}, 0), sample("second layer", 3, {map, map * 2.0}, 1),
            sample("profile", 1, {line}, 0)};
}

}  // namespace setae::formats::tests
