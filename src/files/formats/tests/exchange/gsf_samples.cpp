// SPDX-License-Identifier: GPL-3.0-or-later
#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "setae/core/constants.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

/// A header of any length, NULs up to the next multiple of four, at least one, then float32.
std::string gsf_file(std::string header, const Array2D& values) {
    header.append(4 - header.size() % 4, '\0');
    return ByteBuilder().text(header).rows<float>(values).content();
}

}  // namespace

std::vector<FormatSample> gsf_samples() {
    Array2D map = lopsided_heights(6, 4, 1.0);
    map(2, 1) = undefined;
    const std::string first = "Gwyddion Simple Field 1.0\nXRes = 6\nYRes = 4\n";
    const auto sized = first + "XReal = 3e-06\nYReal = 2e-06\nXYUnits = m\nZUnits = nm\nTitle = Topography\n";
    std::vector<FormatSample> samples;
    for (const int extra : {0, 1, 2, 3})
        samples.push_back(
            {.format = "gsf",
             .name = "header and " + std::to_string(extra),
             .content = gsf_file(sized + "Note = " + std::string(static_cast<std::size_t>(extra) + 1, 'n') + "\n", map),
             .shape = {6, 4},
             .size = {3e-6, 2e-6},
             .heights = map * units::nm,
             .tolerance = 1e-6});
    samples.push_back({.format = "gsf",
                       .name = "without size and unit",
                       .content = gsf_file(first, map),
                       .options = {.size = {{3e-6, 2e-6}}, .unit = "um"},
                       .shape = {6, 4},
                       .size = {3e-6, 2e-6},
                       .heights = map * units::um,
                       .tolerance = 1e-6});
    samples.push_back({.format = "gsf",
                       .name = "size of zero",
                       .content = gsf_file(first + "XReal = 0\nYReal = 0\nXYUnits = m\nZUnits = m\n", map),
                       .options = {.size = {{3e-6, 2e-6}}, .unit = {}},
                       .shape = {6, 4},
                       .size = {3e-6, 2e-6},
                       .heights = map,
                       .tolerance = 1e-6});
    return samples;
}

}  // namespace setae::formats::tests
