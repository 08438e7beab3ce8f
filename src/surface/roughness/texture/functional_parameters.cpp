// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/texture/functional_parameters.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "curve_interpolant.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/bracketing.hpp"

namespace setae::texture {
namespace {

/// Volumes of material and void above and below heights [m³/m²], and the ratio at each.
struct MaterialVolumes {
    Array1D ratio;        ///< P(h)
    Array1D material;     ///< Vm(p)
    Array1D void_volume;  ///< Vv(p)
};

constexpr double central_share = 0.4;

/// Height differences below this share of the whole are neglected.
constexpr double rounding = 1e-12;

/// The first p with the smallest H(p) − H(p + 0.4).
double flattest_start(const CurveInterpolant& curve) {
    const auto fall = [&curve](double p) { return curve.height(p) - curve.height(p + central_share); };
    constexpr int steps = 600;
    const double noise = rounding * (curve.highest() - curve.lowest());
    int best = 0;
    double least = fall(0.0);
    for (int k = 1; k <= steps; ++k) {
        const double value = fall((1.0 - central_share) * k / steps);
        if (value < least - noise) {
            least = value;
            best = k;
        }
    }
    // refined between the neighbours
    double best_place = (1.0 - central_share) * best / steps;
    const auto noted_fall = [&](double p) {
        const double value = fall(p);
        if (value < least - noise) {
            best_place = p;
            least = value;
        }
        return value;
    };
    (void)numerics::golden_section(noted_fall, (1.0 - central_share) * std::max(0, best - 1) / steps,
                                   (1.0 - central_share) * std::min(steps, best + 1) / steps, 40);
    return best_place;
}

/// The straight line of the core, at ratios 0 and 1.
struct CoreLine {
    double upper = 0.0;
    double lower = 0.0;
};

CoreLine core_line(const CurveInterpolant& curve) {
    const double start = flattest_start(curve), end = start + central_share, middle = start + 0.5 * central_share;
    const double high = curve.height(start), low = curve.height(end);
    // ∫ H dp and ∫ p H dp over the 40 % by parts
    const double heights = end * low - start * high + curve.volume(low) - curve.volume(high);
    const double moments = 0.5 * (end * end * low - start * start * high + curve.square(low) - curve.square(high));
    const double slope = 12.0 * (moments - middle * heights) / (central_share * central_share * central_share);
    const double upper = heights / central_share - slope * middle;
    return {upper, upper + slope};
}

void require_ratio(double ratio) {
    if (!(ratio >= 0.0 && ratio <= 1.0))
        throw InvalidArgument(fmt::format("material ratio is {}; expected 0 … 1", ratio));
}

/// Volumes above and below heights, in any order.
MaterialVolumes volumes_at(const MeasurementView& measurement, const ArrayView1D& heights, Between between,
                           parallel::Threads threads) {
    MaterialVolumes volumes{Array1D(heights.size()), Array1D(heights.size()), Array1D(heights.size())};
    std::vector<double> sorted(heights.begin(), heights.end());
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    if (sorted.empty()) return volumes;
    const auto curve = material_ratio_curve(
        measurement, Eigen::Map<const Array1D>(sorted.data(), static_cast<Index>(sorted.size())), between, threads);
    for (Index k = 0; k < heights.size(); ++k) {
        const auto place =
            static_cast<Index>(std::lower_bound(sorted.begin(), sorted.end(), heights[k]) - sorted.begin());
        volumes.ratio[k] = curve.ratio[place];
        volumes.material[k] = curve.volume[place];
        volumes.void_volume[k] = std::max(0.0, curve.volume[place] + (heights[k] - curve.mean));
    }
    return volumes;
}

}  // namespace

FunctionalParameters functional_parameters(const MeasurementView& measurement, const MaterialRatios& ratios,
                                           Between between, parallel::Threads threads) {
    for (const double ratio : {ratios.peaks, ratios.valleys, ratios.extreme, ratios.extreme_reference, ratios.upper,
                               ratios.lower, ratios.inverse})
        require_ratio(ratio);
    if (ratios.height && !std::isfinite(*ratios.height))
        throw InvalidArgument(
            fmt::format("height of a material ratio is {}; expected a finite number", *ratios.height));
    const Elements elements(measurement, between);
    const CurveInterpolant curve(elements, threads);
    FunctionalParameters result;
    if (curve.highest() == curve.lowest()) {
        result.Smrk2 = 1.0;
        result.Smc = curve.nodes().front();
        if (ratios.height) result.Smr = *ratios.height <= curve.nodes().front() ? 1.0 : 0.0;
        return result;
    }
    const auto core = core_line(curve);
    result.Sk = core.upper - core.lower;
    result.Smrk1 = curve.ratio(core.upper);
    result.Smrk2 = curve.ratio(core.lower);
    result.Sak1 = curve.volume(core.upper);
    result.Sak2 = curve.void_volume(core.lower);
    result.Spk = result.Smrk1 > rounding ? 2.0 * result.Sak1 / result.Smrk1 : 0.0;
    result.Svk = 1.0 - result.Smrk2 > rounding ? 2.0 * result.Sak2 / (1.0 - result.Smrk2) : 0.0;
    result.Spkx = std::max(0.0, curve.highest() - core.upper);
    result.Svkx = std::max(0.0, core.lower - curve.lowest());
    const Array1D wanted = (Array1D(7) << ratios.peaks, ratios.valleys, ratios.extreme, ratios.extreme_reference,
                            ratios.upper, ratios.lower, ratios.inverse)
                               .finished();
    const HeightLocator locate(Eigen::Map<const Array1D>(curve.nodes().data(), std::ssize(curve.nodes())));
    const auto heights = heights_at_ratio(elements, locate, curve.sums(), wanted, threads);
    const Array1D levels = (Array1D(3) << heights.head(2), ratios.height.value_or(heights[0])).finished();
    const auto volumes = volumes_at(measurement, levels, between, threads);
    result.Smc = heights[6];
    if (ratios.height) result.Smr = volumes.ratio[2];
    result.Vmp = volumes.material[0];
    result.Vmc = volumes.material[1] - result.Vmp;
    result.Vvv = volumes.void_volume[1];
    result.Vvc = volumes.void_volume[0] - result.Vvv;
    result.Sxp = heights[2] - heights[3];
    result.Sdc = heights[4] - heights[5];
    return result;
}

}  // namespace setae::texture
