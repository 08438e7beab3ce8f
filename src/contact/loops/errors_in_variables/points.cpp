// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/Dense>

#include "curve.hpp"
#include "fits/fit_support.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::loops::errors_in_variables {
namespace {

void require_noise(double noise, const char* channel) {
    if (noise > 0.0) return;
    throw InvalidArgument(
        fmt::format("this fit needs the noise of the {}, which is not known; give the noise, or fit without "
                    "effective variance",
                    channel));
}

double range_of(const Array1D& series) { return series.maxCoeff() - series.minCoeff(); }

/// Noise by which force and displacement are weighed.
struct Weighed {
    double force = 0.0;         ///< [N]
    double displacement = 0.0;  ///< [m]
};

/// The noise of both channels, neither below a twentieth of the effect of the other along the branch:
///
///   σ_δ >= σ_F/(20k),  σ_F >= kσ_δ/20,  k = range of F divided by range of δ
///
/// A channel of this precision is practically exact: the residual's variance σ_F² + (F'σ_δ)² increases by 1/400.
/// Without the floor its relative weight would depend on digits that no instrument has, and the normal equations on
/// rounding.
Weighed weighed_noise(const BranchData& data) {
    constexpr double share = 0.05;
    const double stiffness = range_of(data.force) / range_of(data.displacement);
    return {.force = std::max(data.force_noise, share * stiffness * data.displacement_noise),
            .displacement = std::max(data.displacement_noise, share * data.force_noise / stiffness)};
}

using Single = Eigen::Array<double, 1, 1>;

/// Change of the residual across the curve by `straightened`.
template <class Curve>
auto change_across(const Curve& curve) {
    const Single inverse = Single::Ones() / curve.dot(curve.tangent, curve.tangent);
    auto change = curve.straightened(inverse);
    for (std::size_t c = 0; c < change.size(); ++c) change[c] -= curve.residual[c];
    const Single along = inverse * curve.dot(curve.tangent, change);
    for (std::size_t c = 0; c < change.size(); ++c) change[c] -= along * curve.tangent[c];
    return change;
}

/// Calls a function template for the channels there are.
template <class Function>
auto with_channels(const Channels& channels, const Function& function) {
    if (channels.displacement && channels.contact_radius) return function.template operator()<true, true>();
    if (channels.displacement) return function.template operator()<true, false>();
    return function.template operator()<false, true>();
}

}  // namespace

Points points(const BranchData& data, const LensAndCounterBody& bodies, Channels channels) {
    require_data(data, bodies,
                 {.contact_radius = channels.contact_radius,
                  .displacement = channels.displacement,
                  .fewest = channels.displacement ? 4 : 3});
    Points result{.channels = channels, .radius = bodies.radius, .force_unit = force_scale(data)};
    result.force = data.force / result.force_unit;
    Weighed noise{data.force_noise, data.displacement_noise};
    if (channels.displacement) {
        const double range = range_of(data.displacement);
        if (!(range > 0.0))
            throw UndefinedDataError("the displacement does not change along the branch; a fit needs one that does");
        result.length = std::sqrt(range * bodies.radius);
        noise = weighed_noise(data);
    }
    require_noise(noise.force, "force");
    result.force_weight = result.force_unit / noise.force;
    if (channels.contact_radius) {
        require_noise(data.contact_radius_noise, "contact radius");
        result.length = data.contact_radius.maxCoeff();
        result.contact_radius = data.contact_radius / result.length;
        result.radius_weight = result.length / data.contact_radius_noise;
    }
    result.depth_unit = result.length * result.length / bodies.radius;
    if (channels.displacement) {
        require_noise(noise.displacement, "displacement");
        const double shared = data.force_displacement_covariance / (noise.force * noise.force);
        // a displacement with only the noise of the force keeps a twentieth of it
        constexpr double least = 1.0 / 400.0;
        const double variance = noise.displacement * noise.displacement;
        const double own = std::max(variance - shared * data.force_displacement_covariance, least * variance);
        result.origin = data.displacement[0];
        result.depth = (data.displacement - result.origin) / result.depth_unit;
        result.depth_weight = result.depth_unit / std::sqrt(own);
        result.shared = shared * result.force_unit / result.depth_unit;
    }
    return result;
}

Points averaged(const Points& all, Index neighbours) {
    Points means = all;
    means.force = block_means(all.force, neighbours);
    means.depth = block_means(all.depth, neighbours);
    means.contact_radius = block_means(all.contact_radius, neighbours);
    for (double* weight : {&means.force_weight, &means.depth_weight, &means.radius_weight})
        *weight *= std::sqrt(static_cast<double>(neighbours));
    return means;
}

Points straightened(const Points& bent, const Solution& solution) {
    Points straight = bent;
    with_channels(bent.channels, [&]<bool depth, bool radius>() {
        for (Index i = 0; i < solution.x.size(); ++i) {
            const auto curve = curve_at<depth, radius, Single>(bent, solution.parameters, Single(solution.x[i]), i);
            const auto offset = change_across(curve);
            straight.force[i] += offset[0][0] / bent.force_weight;
            if constexpr (depth)
                straight.depth[i] += offset[1][0] / bent.depth_weight + bent.shared * offset[0][0] / bent.force_weight;
            if constexpr (radius) straight.contact_radius[i] += offset.back()[0] / bent.radius_weight;
        }
    });
    return straight;
}

AlongTheCurve along_the_curve(const Points& points, const Solution& solution) {
    const Index parameters = points.channels.displacement ? 3 : 2;
    AlongTheCurve result{.pretended = Eigen::MatrixXd::Zero(parameters, parameters)};
    constexpr Index enough = 128;  // the sum is smooth along the curve
    const Index n = solution.x.size(), every = std::max<Index>(1, n / enough), taken = (n + every - 1) / every;
    with_channels(points.channels, [&]<bool depth, bool radius>() {
        for (Index i = 0; i < n; i += every) {
            const auto curve =
                curve_at<depth, radius, Single, true>(points, solution.parameters, Single(solution.x[i]), i);
            const auto dot = [&](const auto& left, const auto& right) { return curve.dot(left, right)[0]; };
            const auto& tangent = curve.tangent;
            const double length = dot(tangent, tangent), bend = dot(tangent, curve.second) / length;
            const double across = std::max(dot(curve.second, curve.second) - bend * bend * length, 0.0);
            result.curvature = std::max(result.curvature, std::sqrt(across) / length);
            auto change = curve.mixed;
            for (std::size_t p = 0; p < change.size(); ++p) {
                const double turned = dot(tangent, curve.by_parameter[p]) / length;
                for (std::size_t c = 0; c < tangent.size(); ++c) change[p][c] -= turned * curve.second[c];
                const double along = dot(tangent, change[p]) / length;
                for (std::size_t c = 0; c < tangent.size(); ++c) change[p][c] -= along * tangent[c];
            }
            for (Index p = 0; p < parameters; ++p)
                for (Index q = 0; q < parameters; ++q)
                    result.pretended(p, q) +=
                        dot(change[static_cast<std::size_t>(p)], change[static_cast<std::size_t>(q)]) / length;
        }
    });
    result.pretended *= static_cast<double>(n) / static_cast<double>(taken);
    return result;
}

Across across(const Points& points, const Solution& solution) {
    const Index n = solution.x.size();
    const Index directions = points.channels.displacement && points.channels.contact_radius ? 2 : 1;
    const Index parameters = points.channels.displacement ? 3 : 2;
    Across result;
    result.jacobians.assign(static_cast<std::size_t>(directions), Eigen::MatrixXd(n, parameters));
    result.residuals.assign(static_cast<std::size_t>(directions), Eigen::VectorXd(n));
    if (points.channels.contact_radius) result.force.resize(n);
    if (directions == 2) result.depth.resize(n);
    with_channels(points.channels, [&]<bool depth, bool radius>() {
        for (Index i = 0; i < n; ++i) {
            const auto curve = curve_at<depth, radius, Single>(points, solution.parameters, Single(solution.x[i]), i);
            const auto& tangent = curve.tangent;
            const Single inverse = Single::Ones() / curve.dot(tangent, tangent);
            const auto offset = curve.straightened(inverse);
            const auto along_direction = [&](std::size_t d, const auto& direction) {
                result.residuals[d][i] = curve.dot(direction, offset)[0];
                for (Index p = 0; p < parameters; ++p)
                    result.jacobians[d](i, p) =
                        curve.dot(direction, curve.by_parameter[static_cast<std::size_t>(p)])[0];
            };
            if constexpr (radius) {
                const Single share = offset.back() / tangent.back();
                const double force = (offset[0] - share * tangent[0])[0] / points.force_weight;
                result.force[i] = force * points.force_unit;
                if constexpr (depth)
                    result.depth[i] =
                        ((offset[1] - share * tangent[1])[0] / points.depth_weight + points.shared * force) *
                        points.depth_unit;
            }
            auto first = tangent;
            if constexpr (depth && radius) {
                const Single pair = (tangent[0].square() + tangent[2].square()).sqrt();
                first = {tangent[2] / pair, Single(0.0), -tangent[0] / pair};
                const Single both = pair * inverse.rsqrt();
                along_direction(1, decltype(first){-tangent[1] * tangent[0] / both, pair.square() / both,
                                                   -tangent[1] * tangent[2] / both});
            } else if constexpr (depth) {
                first = {-tangent[1] * inverse.sqrt(), tangent[0] * inverse.sqrt()};
            } else {
                first = {tangent[1] * inverse.sqrt(), -tangent[0] * inverse.sqrt()};
            }
            along_direction(0, first);
        }
    });
    return result;
}

Eigen::MatrixXd across_information(const Across& noise) {
    const Index parameters = noise.jacobians.front().cols();
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(parameters, parameters);
    for (const Eigen::MatrixXd& jacobian : noise.jacobians)
        for (Index p = 0; p < parameters; ++p)
            for (Index q = 0; q < parameters; ++q) sum(p, q) += jacobian.col(p).dot(jacobian.col(q));
    return sum;
}

}  // namespace setae::loops::errors_in_variables
