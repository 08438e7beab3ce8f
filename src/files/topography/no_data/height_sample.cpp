// SPDX-License-Identifier: GPL-3.0-or-later
#include "height_sample.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "setae/core/constants.hpp"

namespace setae::topography {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// A pseudorandom number between 0 and 1. Source: Steele, Lea, Flood, OOPSLA 2014, splitmix64.
double scattered(std::uint64_t number) {
    number = (number + 1) * 0x9e3779b97f4a7c15u;
    number = (number ^ (number >> 30)) * 0xbf58476d1ce4e5b9u;
    number = (number ^ (number >> 27)) * 0x94d049bb133111ebu;
    return static_cast<double>((number ^ (number >> 31)) >> 11) * 0x1p-53;
}

struct Place {
    Index x, line;
};

std::vector<Place> places_of(Index nx, Index ny) {
    constexpr Index most = 1 << 14;
    const Index points = nx * ny, count = std::min(points, most);
    std::vector<Place> places;
    places.reserve(static_cast<std::size_t>(count));
    for (Index k = 0; k < count; ++k) {
        const double share =
            (static_cast<double>(k) + scattered(static_cast<std::uint64_t>(k))) / static_cast<double>(count);
        const Index place =
            points == count ? k : std::min(points - 1, static_cast<Index>(share * static_cast<double>(points)));
        places.push_back({place / ny, place % ny});
    }
    return places;
}

struct Range {
    double least = unbounded, greatest = -unbounded;
};

/// The range widened by heights; NaN is skipped. In lanes, for vectorisation.
void widen(Range& range, const double* heights, Index n) {
    constexpr Index lanes = 8;
    std::array<double, lanes> least, greatest;
    least.fill(range.least);
    greatest.fill(range.greatest);
    Index i = 0;
    for (; i + lanes <= n; i += lanes)
        for (Index lane = 0; lane < lanes; ++lane) {
            const double h = heights[i + lane];
            const auto k = static_cast<std::size_t>(lane);
            least[k] = h < least[k] ? h : least[k];
            greatest[k] = h > greatest[k] ? h : greatest[k];
        }
    for (; i < n; ++i) {
        least[0] = heights[i] < least[0] ? heights[i] : least[0];
        greatest[0] = heights[i] > greatest[0] ? heights[i] : greatest[0];
    }
    range = {*std::min_element(least.begin(), least.end()), *std::max_element(greatest.begin(), greatest.end())};
}

Range range_of(const HeightBand& band, Index nx) {
    Range range;
    if (band.distance == band.lines) {
        widen(range, band.heights, nx * band.lines);
        return range;
    }
    for (Index x = 0; x < nx; ++x) widen(range, band.heights + x * band.distance, band.lines);
    return range;
}

}  // namespace

HeightSample sampled(const HeightBands& bands) {
    const auto places = places_of(bands.nx, bands.ny);
    std::vector<SampledHeight> found(places.size(), {undefined, undefined});
    std::vector<Range> ranges(bands.count);
    bands.for_each([&](std::size_t number, const HeightBand& band) {
        ranges[number] = range_of(band, bands.nx);
        for (std::size_t k = 0; k < places.size(); ++k) {
            const auto [x, line] = places[k];
            if (line < band.first_line || line >= band.first_line + band.lines) continue;
            const double* const height = band.heights + x * band.distance + line - band.first_line;
            found[k] = {*height, x + 1 < bands.nx ? height[band.distance] : undefined};
        }
    });
    HeightSample sample{unbounded, -unbounded, {}};
    for (const auto& range : ranges) {
        sample.least = std::min(sample.least, range.least);
        sample.greatest = std::max(sample.greatest, range.greatest);
    }
    std::erase_if(found, [](const SampledHeight& point) { return std::isnan(point.height); });
    sample.heights = std::move(found);
    return sample;
}

}  // namespace setae::topography
