// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/simulation/side_view.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "instrument.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/simulation/silhouette.hpp"

namespace setae::simulation {
namespace {

/// Random sequences of the key.
enum ViewStream : std::uint64_t { step_stream, trace_stream, reentrant_stream };

void check(const FoilContourOptions& options) {
    if (!(options.step > 0.0) || !(options.length >= options.step) || !(options.length / options.step < 1e8))
        throw InvalidArgument(
            fmt::format("contour of {} m in steps of {} m; expected 0 < step <= length and fewer than 1e8 points",
                        options.length, options.step));
    const double widest = widest_spread(options.steps);
    if (!(options.step_spread >= 0.0) || !(options.step_spread <= widest))
        throw InvalidArgument(
            fmt::format("spread {} of the contour's steps; expected 0 … {}", options.step_spread, widest));
    require_not_negative(options.blur, "blur [m] of the projection");
    require_not_negative(options.trace_noise_rms, "rms deviation [m] of the trace");
    if (options.trace_noise_rms > 0.0 && !(options.trace_noise_length > 0.0))
        throw InvalidArgument(fmt::format("the trace's deviation is correlated over {} m; expected a positive length",
                                          options.trace_noise_length));
    if (!(options.reentrant_share >= 0.0) || !(options.reentrant_share <= 0.5) || options.reentrant_points < 1)
        throw InvalidArgument(
            fmt::format("share {} of re-entrant points in stretches of {}; expected 0 … 0.5 and at least 1",
                        options.reentrant_share, options.reentrant_points));
}

/// Distances of neighbouring points over their mean.
class StepLaw {
public:
    explicit StepLaw(const FoilContourOptions& options)
        : kind_(options.step_spread > 0.0 ? options.steps : ContourSteps::regular),
          spread_(options.step_spread),
          key_(substream(options.key, step_stream)) {
        if (kind_ == ContourSteps::gamma) freedoms_ = std::max<Index>(1, std::llround(2.0 / (spread_ * spread_)));
    }

    [[nodiscard]] double operator()(Index k) const {
        if (kind_ == ContourSteps::regular) return 1.0;
        if (kind_ == ContourSteps::uniform)
            return 1.0 +
                   std::numbers::sqrt3 * spread_ * (2.0 * uniform_number(key_, static_cast<std::uint64_t>(k)) - 1.0);
        const auto first = static_cast<std::uint64_t>(k * freedoms_);
        return numerics::normal_numbers(key_, first, freedoms_).square().sum() / static_cast<double>(freedoms_);
    }

private:
    ContourSteps kind_;
    double spread_;
    numerics::RandomKey key_;
    Index freedoms_ = 0;
};

Array1D positions_of(const FoilContourOptions& options) {
    const StepLaw law(options);
    // a regular contour ends on its length in spite of rounding
    const double end = options.length * (1.0 + 1e-9);
    std::vector<double> positions{0.0};
    if (options.steps == ContourSteps::regular || options.step_spread == 0.0) {
        for (Index k = 1; static_cast<double>(k) * options.step <= end; ++k)
            positions.push_back(static_cast<double>(k) * options.step);
    } else {
        for (Index k = 0;; ++k) {
            const double next = positions.back() + options.step * law(k);
            if (next > end) break;
            if (next > positions.back()) positions.push_back(next);
        }
    }
    return Eigen::Map<const Array1D>(positions.data(), static_cast<Index>(positions.size()));
}

/// Heights smoothed by a Gaussian; at the ends of a line that is not periodic, by the part of it inside.
Array1D blurred(const topography::LineScan& line, double blur) {
    const double step = line.pixel_size();
    const auto n = line.heights.size(), reach = static_cast<Index>(std::ceil(6.0 * blur / step));
    if (blur < 1e-3 * step) return line.heights;
    const Array1D offsets =
        Array1D::LinSpaced(2 * reach + 1, -static_cast<double>(reach), static_cast<double>(reach)) * (step / blur);
    const Array1D weights = (-0.5 * offsets.square()).exp();
    Array1D result(n);
    for (Index i = 0; i < n; ++i) {
        double sum = 0.0, norm = 0.0;
        for (Index k = -reach; k <= reach; ++k) {
            if (!line.periodic && (i + k < 0 || i + k >= n)) continue;
            sum += weights[k + reach] * line.heights[((i + k) % n + n) % n];
            norm += weights[k + reach];
        }
        result[i] = sum / norm;
    }
    return result;
}

/// Heights between the points of a line.
Array1D interpolated(const Array1D& heights, double step, bool periodic, double start, const Array1D& positions) {
    const auto n = heights.size();
    Array1D result(positions.size());
    for (Index k = 0; k < positions.size(); ++k) {
        const double at = (start + positions[k]) / step;
        const double left = std::floor(at);
        const bool outside = !(at >= 0.0) || !(at <= static_cast<double>(n - 1) * (1.0 + 1e-12));
        if (!std::isfinite(at) || (!periodic && outside))
            throw InvalidArgument(fmt::format(
                "contour at x = {} m, the surface ends at {} m; expected a contour inside it, or a periodic "
                "surface",
                start + positions[k], static_cast<double>(n - 1) * step));
        const auto i = static_cast<Index>(left), first = (i % n + n) % n;
        const Index second = periodic ? (first + 1) % n : std::min(first + 1, n - 1);
        const double share = at - left;
        result[k] = share == 0.0 ? heights[first] : (1.0 - share) * heights[first] + share * heights[second];
        if (std::isnan(result[k]))
            throw UndefinedDataError(
                fmt::format("the silhouette is undefined at x = {} m; a contour needs a surface without holes",
                            start + positions[k]));
    }
    return result;
}

/// n(x) = rms Σ_k exp(−((x − kd)/length)²) ξ_k/norm, d = length/2: correlation exp(−x²/(2 length²)) to 1e-8.
Array1D trace_deviation(const FoilContourOptions& options, const Array1D& positions) {
    Array1D result = Array1D::Zero(positions.size());
    if (options.trace_noise_rms == 0.0) return result;
    constexpr Index reach = 12;  // exp(−36) beyond
    const double distance = 0.5 * options.trace_noise_length;
    const double norm = options.trace_noise_rms / std::sqrt(2.0 * std::sqrt(0.5 * pi));
    const auto last = static_cast<Index>(std::ceil(positions[positions.size() - 1] / distance));
    const Array1D numbers = numerics::normal_numbers(substream(options.key, trace_stream), 0, last + 2 * reach + 1);
    for (Index p = 0; p < positions.size(); ++p) {
        const auto nearest = static_cast<Index>(std::llround(positions[p] / distance));
        for (Index k = nearest - reach; k <= nearest + reach; ++k) {
            const double offset = (positions[p] - static_cast<double>(k) * distance) / options.trace_noise_length;
            result[p] += norm * std::exp(-offset * offset) * numbers[k + reach];
        }
    }
    return result;
}

/// One stretch at a random place in each block of points; the last point of a block always stays.
void turn_back(Array1D& positions, const FoilContourOptions& options) {
    if (options.reentrant_share == 0.0) return;
    const Index stretch = options.reentrant_points;
    const auto block = static_cast<Index>(std::llround(static_cast<double>(stretch) / options.reentrant_share));
    const auto key = substream(options.key, reentrant_stream);
    for (Index b = 0; 1 + (b + 1) * block < positions.size(); ++b) {
        const Index first = 1 + b * block + random_index(key, static_cast<std::uint64_t>(b), block - stretch);
        const double front = positions[first - 1];
        for (Index k = first; k < first + stretch; ++k) positions[k] = front - 0.5 * (positions[k] - front);
    }
}

}  // namespace

double widest_spread(ContourSteps steps) {
    return steps == ContourSteps::gamma ? std::numbers::sqrt2 : 1.0 / std::numbers::sqrt3;
}

topography::Profile projected_contour(const topography::HeightMap& surface, const FoilContourOptions& options) {
    check(options);
    const auto line = silhouette(surface, options.thickness, options.start_y);
    topography::Profile contour;
    contour.positions = positions_of(options);
    contour.heights = interpolated(blurred(line, options.blur), line.pixel_size(), line.periodic, options.start_x,
                                   contour.positions) +
                      trace_deviation(options, contour.positions);
    turn_back(contour.positions, options);
    contour.metadata.name = "simulated tem";
    contour.metadata.unit = "m";
    contour.metadata.instrument.name = "simulated tem";
    contour.metadata.instrument.type = "tem";
    contour.metadata.attributes["foil_thickness"] = fmt::format("{} m", options.thickness);
    return contour;
}

}  // namespace setae::simulation
