// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/topography/line_scans.hpp"

#include <cmath>

namespace setae::topography {

std::vector<LineScan> line_scans(const HeightMap& map) {
    std::vector<LineScan> scans;
    scans.reserve(static_cast<std::size_t>(map.heights.cols()));
    for (Index j = 0; j < map.heights.cols(); ++j)
        scans.push_back({map.heights.col(j), map.size[0], map.periodic, map.metadata});
    return scans;
}

Profile to_profile(const LineScan& scan) {
    const double step = scan.pixel_size();
    const auto defined = (!scan.heights.isNaN()).count();
    Profile profile{Array1D(defined), Array1D(defined), scan.metadata};
    for (Index i = 0, kept = 0; i < scan.heights.size(); ++i) {
        if (std::isnan(scan.heights[i])) continue;
        profile.positions[kept] = static_cast<double>(i) * step;
        profile.heights[kept++] = scan.heights[i];
    }
    return profile;
}

std::optional<LineScan> to_line_scan(const Profile& profile) {
    const auto n = profile.positions.size();
    const bool would_lose = profile.response || profile.standard_error.size() > 0;
    if (n < 2 || would_lose) return std::nullopt;
    const double step = profile.size() / static_cast<double>(n - 1);
    if (!(step > 0.0)) return std::nullopt;
    // rounded positions may deviate from the grid by less than half the last digit, a small share of a step
    for (Index i = 0; i < n; ++i) {
        const double stray = profile.positions[i] - profile.positions[0] - static_cast<double>(i) * step;
        if (std::abs(stray) > 0.02 * step) return std::nullopt;
    }
    return LineScan{profile.heights, step * static_cast<double>(n), false, profile.metadata};
}

}  // namespace setae::topography
