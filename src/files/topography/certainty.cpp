// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/topography/certainty.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "contact_search.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "tip_contact.hpp"

namespace setae::topography {
namespace {

/// The map with undefined heights around it, as wide as the tip: surface beyond its ends that the tip may touch.
HeightMap with_margin(const HeightMap& map, Index margin_x, Index margin_y) {
    const auto [nx, ny] = map.shape();
    const auto pixel = map.pixel_size();
    HeightMap wide{
        Array2D::Constant(nx + 2 * margin_x, ny + 2 * margin_y, undefined),
        {pixel[0] * static_cast<double>(nx + 2 * margin_x), pixel[1] * static_cast<double>(ny + 2 * margin_y)},
        map.periodic,
        map.metadata};
    wide.heights.block(margin_x, margin_y, nx, ny) = map.heights;
    return wide;
}

}  // namespace

Certainty certainty_map(const HeightMap& image, const Tip& tip, const DilationOptions& options,
                        std::optional<double> tolerance) {
    const double range = height_range(image, options), margin = tolerance.value_or(1e-9 * range);
    if (!(margin >= 0.0))
        throw InvalidArgument(fmt::format("tolerance {} m of the certainty map; expected >= 0", margin));
    const auto probe = touching_tip(image, tip, options);
    const auto [nx, ny] = image.shape();
    const Index margin_x = image.periodic ? 0 : probe.centre_x, margin_y = image.periodic ? 0 : probe.centre_y;

    auto everywhere = options;
    everywhere.keep_undefined = false;
    everywhere.height_range = range;
    Array2D bound = eroded(with_margin(image, margin_x, margin_y), tip, everywhere).heights;
    const Array2D known = (!image.heights.isNaN()).select(bound.block(margin_x, margin_y, nx, ny), undefined);
    const double highest = (!known.isNaN()).select(known, -std::numeric_limits<double>::infinity()).maxCoeff();
    bound = (bound > highest).select(highest, bound);

    const ContactSearch search(bound, image.periodic, image.periodic, probe, options.threads);
    // the tip at points of one row touches points of other rows: each row has its own list
    std::vector<std::vector<Index>> proven(static_cast<std::size_t>(nx));
    parallel::for_each_index(proven.size(), options.threads, [&, ny = ny](std::size_t row) {
        const auto x = static_cast<Index>(row);
        for (Index y = 0; y < ny; ++y) {
            const double apex = image.heights(x, y);
            if (std::isnan(apex)) continue;
            const auto touching = search.touching(x + margin_x, y + margin_y, apex - margin);
            if (touching.points == 1) proven[row].push_back(touching.contact.x * bound.cols() + touching.contact.y);
        }
    });

    Certainty result{{known, image.size, image.periodic, image.metadata}, {}, 0.0};
    result.certain.setZero(nx, ny);
    for (const auto& points : proven)
        for (const Index point : points) {
            const Index x = point / bound.cols() - margin_x, y = point % bound.cols() - margin_y;
            const bool inside = x >= 0 && y >= 0 && x < nx && y < ny;
            if (inside && !std::isnan(known(x, y))) result.certain(x, y) = 1;
        }
    result.share = static_cast<double>((result.certain != 0).count()) / static_cast<double>((!known.isNaN()).count());
    return result;
}

}  // namespace setae::topography
