// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/roughness/slope_shape.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/roughness/true_area.hpp"

namespace setae::roughness {
namespace {

constexpr double classes_a_decade = 40.0, lowest_decade = -6.0, highest_decade = 4.0;
constexpr auto class_count = static_cast<Index>((highest_decade - lowest_decade) * classes_a_decade);

struct Classes {
    Array1D count = Array1D::Zero(class_count), sum = Array1D::Zero(class_count);

    void add(double square) {
        const double place = square > 0.0 ? (std::log10(square) - lowest_decade) * classes_a_decade : 0.0;
        const auto at = std::clamp<Index>(static_cast<Index>(place), 0, class_count - 1);
        count[at] += 1.0;
        sum[at] += square;
    }
};

}  // namespace

double SlopeShape::area_ratio(double rms_slope) const {
    if (!(rms_slope >= 0.0)) throw InvalidArgument(fmt::format("rms slope is {}, expected a number >= 0", rms_slope));
    return (share * (1.0 + rms_slope * rms_slope * square).sqrt()).sum();
}

SlopeShape slope_shape(const topography::HeightMap& map, parallel::Threads threads) {
    const double rms = triangulated_area(map, threads).rms_slope;
    if (!(rms > 0.0)) throw UndefinedDataError(map.metadata.file + ": all slopes are 0");
    const Index nx = map.heights.rows(), ny = map.heights.cols();
    const Index rows = map.periodic ? nx : nx - 1, columns = map.periodic ? ny : ny - 1;
    const auto [dx, dy] = map.pixel_size();
    constexpr Index together = 32;
    std::vector<Classes> parts(static_cast<std::size_t>((rows + together - 1) / together));
    parallel::for_each_index(parts.size(), threads, [&, dx = dx, dy = dy](std::size_t part) {
        const Index first = static_cast<Index>(part) * together;
        for (Index i = first; i < std::min(rows, first + together); ++i) {
            const Index next_i = (i + 1) % nx;
            for (Index j = 0; j < columns; ++j) {
                const Index next_j = (j + 1) % ny;
                const auto& h = map.heights;
                const double along[2] = {(h(next_i, j) - h(i, j)) / (dx * rms),
                                         (h(next_i, next_j) - h(i, next_j)) / (dx * rms)},
                             across[2] = {(h(i, next_j) - h(i, j)) / (dy * rms),
                                          (h(next_i, next_j) - h(next_i, j)) / (dy * rms)};
                if (!std::isfinite(along[0] + along[1] + across[0] + across[1])) continue;
                for (const double x : along)
                    for (const double y : across) parts[part].add(x * x + y * y);
            }
        }
    });
    Classes all;
    for (const auto& part : parts) {
        all.count += part.count;
        all.sum += part.sum;
    }
    return {all.count / all.count.sum(), (all.count > 0.0).select(all.sum / all.count.max(1.0), 0.0)};
}

SlopeShape mean_shape(const std::vector<WeighedShape>& shapes) {
    if (shapes.empty()) throw InvalidArgument("no map to take the distribution of slopes from");
    double area = 0.0;
    for (const auto& weighed : shapes) area += weighed.area;
    SlopeShape mean{Array1D::Zero(class_count), Array1D::Zero(class_count)};
    for (const auto& [shape, own] : shapes) {
        mean.share += own / area * shape.share;
        mean.square += own / area * shape.share * shape.square;
    }
    mean.square = (mean.share > 0.0).select(mean.square / mean.share.max(1e-300), 0.0);
    return mean;
}

}  // namespace setae::roughness
