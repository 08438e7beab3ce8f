// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "sample_files.hpp"
#include "setae/core/constants.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

constexpr Index nx = 7, ny = 5;

std::string index_of(Index columns, Index rows, int layers) {
    auto xml = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<xml><GENERAL><VERSION>10</VERSION><AUTHOR>N. N.</AUTHOR><DATE>Tue Mar 14 10:11:12 2023</DATE>"
        "<IMAGE_SIZE_X>{}</IMAGE_SIZE_X><IMAGE_SIZE_Y>{}</IMAGE_SIZE_Y><FOV_X>0.645</FOV_X><FOV_Y>0.5</FOV_Y></GENERAL>"
        "<INFO><SIZE>2</SIZE><ITEM_0><NAME>Device</NAME><VALUE>S neox</VALUE></ITEM_0><ITEM_1><NAME>Objective</NAME><VALUE>20X</VALUE></ITEM_1></INFO>",
        columns, rows);
    for (int layer = 0; layer < layers; ++layer)
        xml += fmt::format(
            "<LAYER_{0}><FILENAME_Z>LAYER_{0}.raw</FILENAME_Z><FILENAME_C>LAYER_{0}.stack.raw</FILENAME_C></LAYER_{0}>",
            layer);
    return xml + "</xml>";
}

std::string floats(const Array2D& heights) { return ByteBuilder().rows<float>(heights).content(); }

FormatSample sample(const std::string& name, const std::vector<Array2D>& layers, std::size_t channel) {
    const auto& heights = layers[channel];
    Members members{{"index.xml", index_of(heights.rows(), heights.cols(), static_cast<int>(layers.size()))},
                    {"recipe.txt", "<?xml version=\"1.0\"?><xml></xml>"}};
    for (std::size_t k = 0; k < layers.size(); ++k)
        members.emplace_back(fmt::format("LAYER_{}.raw", k), floats(layers[k]));
    FormatSample sample{.format = "plux",
                        .name = name,
                        .content = zip_archive(members),
                        .channel = channel,
                        .shape = {heights.rows()},
                        .size = {0.645 * units::um * static_cast<double>(heights.rows())},
                        .heights = heights * units::um,
                        .tolerance = 1e-7};
    if (heights.cols() > 1) {
        sample.shape.push_back(heights.cols());
        sample.size.push_back(0.5 * units::um * static_cast<double>(heights.cols()));
    }
    return sample;
}

}  // namespace

std::vector<FormatSample> plux_samples() {
    auto map = lopsided_heights(nx, ny, 0.25);
    map(3, 1) = undefined;
    const Array2D second = map * -3.0;
    return {sample("one layer", {map}, 0), sample("second layer", {map, second}, 1),
            sample("profile", {lopsided_heights(9, 1, 0.5)}, 0)};
}

}  // namespace setae::formats::tests
