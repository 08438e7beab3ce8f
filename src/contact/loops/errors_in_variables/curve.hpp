// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "setae/contact/jkr_curve.hpp"
#include "solution.hpp"

namespace setae::loops::errors_in_variables {

/// The curve at true radii x and the samples from `first` on, in units of the noise: one entry per channel.
template <std::size_t channels, std::size_t parameters, class Lane>
struct CurveBesideSamples {
    using Vector = std::array<Lane, channels>;
    Vector residual;  ///< sample − curve
    Vector tangent;   ///< derivative by x
    Vector second;    ///< second derivative by x
    std::array<Vector, parameters> by_parameter;
    std::array<Vector, parameters> mixed;  ///< derivative by x and parameter; undefined unless requested

    /// Residual without the offset that noise along the bent curve makes on average, −γ''/(2|γ'|²) across it. Where the
    /// noise is as large as the bend's radius, as where a contact without adhesion begins, that series means nothing:
    /// it fades. inverse: 1/|γ'|².
    [[nodiscard]] Vector straightened(const Lane& inverse) const {
        const Lane bend = dot(second, second) * inverse.square();
        const Lane share = 0.5 * inverse / (1.0 + bend.square());
        Vector result = residual;
        for (std::size_t c = 0; c < channels; ++c) result[c] += share * second[c];
        return result;
    }

    [[nodiscard]] static Lane dot(const Vector& left, const Vector& right) {
        Lane sum = left[0] * right[0];
        for (std::size_t c = 1; c < channels; ++c) sum += left[c] * right[c];
        return sum;
    }
};

template <bool depth, bool radius, class Lane, bool with_mixed = false>
[[nodiscard]] auto curve_at(const Points& points, const Parameters& at, const Lane& x, Index first) {
    constexpr Index width = Lane::SizeAtCompileTime;
    constexpr std::size_t depth_channel = 1, radius_channel = depth ? 2 : 1;
    CurveBesideSamples<1 + depth + radius, depth ? 3 : 2, Lane> curve;
    const double e = at[0], g = at[1];
    const contact::jkr::CurveAt<Lane> jkr(x);
    const double wf = points.force_weight;
    curve.residual[0] = wf * (points.force.segment<width>(first) - jkr.force(e, g));
    curve.tangent[0] = wf * jkr.force_slope(e, g);
    curve.second[0] = wf * jkr.force_bend(e, g);
    curve.by_parameter[0][0] = wf * jkr.cube;
    curve.by_parameter[1][0] = -wf * jkr.three_halves;
    if constexpr (with_mixed) {
        curve.mixed[0][0] = 3.0 * wf * jkr.square;
        curve.mixed[1][0] = -1.5 * wf * jkr.root;
    }
    if constexpr (depth) {
        const double wd = points.depth_weight, pull = 2.0 / 3.0 * g / e;
        const double shared = points.shared * wd / wf;  // of the force in units of its noise
        const Lane inverse_root = jkr.inverse_root();
        curve.by_parameter[2][0].setZero();
        curve.residual[depth_channel] =
            wd * (points.depth.segment<width>(first) - (jkr.depth(pull) + at[2])) - shared * curve.residual[0];
        curve.tangent[depth_channel] = wd * jkr.depth_slope(pull) - shared * curve.tangent[0];
        curve.second[depth_channel] = wd * jkr.depth_bend(pull) - shared * curve.second[0];
        curve.by_parameter[0][depth_channel] = wd * pull / e * jkr.root - shared * curve.by_parameter[0][0];
        curve.by_parameter[1][depth_channel] = -wd * (2.0 / 3.0) / e * jkr.root - shared * curve.by_parameter[1][0];
        curve.by_parameter[2][depth_channel].setConstant(wd);
        if constexpr (with_mixed) {
            curve.mixed[0][depth_channel] = 0.5 * wd * pull / e * inverse_root - shared * curve.mixed[0][0];
            curve.mixed[1][depth_channel] = -wd / (3.0 * e) * inverse_root - shared * curve.mixed[1][0];
            for (Lane& part : curve.mixed[2]) part.setZero();
        }
    }
    if constexpr (radius) {
        const double wx = points.radius_weight;
        curve.residual[radius_channel] = wx * (points.contact_radius.segment<width>(first) - x);
        curve.tangent[radius_channel].setConstant(wx);
        curve.second[radius_channel].setZero();
        for (auto& slope : curve.by_parameter) slope[radius_channel].setZero();
        if constexpr (with_mixed)
            for (auto& slope : curve.mixed) slope[radius_channel].setZero();
    }
    return curve;
}

}  // namespace setae::loops::errors_in_variables
