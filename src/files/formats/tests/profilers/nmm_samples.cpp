// SPDX-License-Identifier: GPL-3.0-or-later
#include "nmm_samples.hpp"

#include <fmt/format.h>

#include "format_samples.hpp"
#include "setae/core/constants.hpp"

namespace setae::formats::tests {
namespace {

constexpr const char* dashes = "------------------------------------------";

std::string description(Index scans, Index points, Index lines) {
    return fmt::format(
        "{0}\r\nScan procedure description file\r\nCreation time : Tue Jun 14 10:20:30 2022\r\n{0}\r\n1 Scan field\r\nNumber of scans : {1}\r\nNumber of lines : {2}\r\n"
        "Scan line length : {3} [\u00b5m]\r\nScan field width : {4} [\u00b5m]\r\nDistance beetween points : 0.5 [\u00b5m]\r\nDistance beetween lines : 2.0 [\u00b5m]\r\n{0}\r\n",
        dashes, scans, lines, 0.5 * static_cast<double>(points - 1), 2.0 * static_cast<double>(lines - 1));
}

std::string columns(Index points) {
    std::string text = fmt::format("{}\r\n", dashes);
    int number = 0;
    for (const auto* name : {"Lx", "Ly", "Lz", "Ax", "-Lz+Az"})
        text += fmt::format("{} : Tue Jun 14 10:20:30 2022 : {} : {} : column {}\r\n", number++, name, points, name);
    return text + dashes + "\r\n";
}

std::string rows(const Array2D& heights, Index line) {
    std::string text;
    for (Index i = 0; i < heights.rows(); ++i) {
        const double x = 1e-3 + 0.5e-6 * static_cast<double>(i), y = 2e-6 * static_cast<double>(line);
        text += fmt::format("{:.9e} {:.9e} {:.6e} {:.3e} {:.17g}\r\n", x, y, 0.01, 0.1, heights(i, line));
    }
    return text;
}

FormatSample sample(const std::string& name, const std::vector<Array2D>& scans, std::size_t scan) {
    constexpr std::size_t channels_per_scan = 5;
    const auto& heights = scans[scan];
    FormatSample sample{.format = "nmm",
                        .name = name,
                        .content = zip_archive(nmm_members(scans)),
                        .channel = channels_per_scan * scan,
                        .shape = {heights.rows()},
                        .size = {0.5 * units::um * static_cast<double>(heights.rows())},
                        .heights = heights};
    if (heights.cols() > 1) {
        sample.shape.push_back(heights.cols());
        sample.size.push_back(2.0 * units::um * static_cast<double>(heights.cols()));
    }
    return sample;
}

}  // namespace

Members nmm_members(const std::vector<Array2D>& scans) {
    Members members{{"groove.dsc", description(static_cast<Index>(scans.size()), scans[0].rows(), scans[0].cols())}};
    for (std::size_t scan = 0; scan < scans.size(); ++scan)
        for (Index line = 0; line < scans[scan].cols(); ++line) {
            const auto name = fmt::format("groove_{}_{}", scan + 1, line + 1);
            members.emplace_back(name + ".dsc", columns(scans[scan].rows()));
            members.emplace_back(name + ".dat", rows(scans[scan], line));
        }
    return members;
}

std::vector<FormatSample> nmm_samples() {
    const auto map = lopsided_heights(7, 3, units::nm);
    return {sample("map", {map}, 0), sample("second scan", {map, 2.0 * map}, 1),
            sample("profile", {lopsided_heights(9, 1, units::nm)}, 0)};
}

}  // namespace setae::formats::tests
