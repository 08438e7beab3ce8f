// SPDX-License-Identifier: GPL-3.0-or-later
#include "edge_course.hpp"

#include <algorithm>
#include <cmath>

#include "setae/contact/jkr_curve.hpp"
#include "setae/core/constants.hpp"

namespace setae::loops {
namespace {

using Slopes = Eigen::Matrix<double, 1, EdgeCourse::parameters>;
enum : int { by_first_radius, by_modulus, by_threshold, by_reference_speed, by_exponent };

/// Speed of retraction, its derivative by the radius, and by the logarithms of the parameters at a given radius.
struct Receding {
    double speed = 0.0, by_radius = 0.0;
    Slopes by_logarithm = Slopes::Zero();
};

Receding receding(double a, double force, double radius, const EdgeParameters& at) {
    const auto& law = at.law;
    const auto rate =
        contact::jkr::energy_release_slopes(a, force, {.radius = radius, .contact_modulus = at.contact_modulus});
    const double excess = rate.value / law.threshold - 1.0, power = 1.0 / law.exponent;
    Receding result;
    if (!(excess > 0.0)) return result;
    result.speed = law.reference_speed * std::pow(excess, power);
    const double by_rate = power * result.speed / (excess * law.threshold);
    result.by_radius = by_rate * rate.by_radius;
    result.by_logarithm[by_modulus] = by_rate * rate.by_modulus * at.contact_modulus;
    result.by_logarithm[by_threshold] = -by_rate * rate.value;
    result.by_logarithm[by_reference_speed] = result.speed;
    result.by_logarithm[by_exponent] = -power * result.speed * std::log(excess);
    return result;
}

/// The radius a step later by the trapezoidal rule; NaN where there is none: the edge is unstable.
double next_radius(double a, double step, const Receding& now, double force, double radius, const EdgeParameters& at) {
    constexpr int max_rounds = 30;
    constexpr double settled = 1e-13;
    double next = a - step * now.speed;
    if (!(next > 0.0)) next = 0.5 * a;
    for (int round = 0; round < max_rounds; ++round) {
        const Receding then = receding(next, force, radius, at);
        const double defect = next - a + 0.5 * step * (now.speed + then.speed);
        const double slope = 1.0 + 0.5 * step * then.by_radius;
        if (!(slope > 0.0)) return undefined;
        const double better = std::max(next - defect / slope, 0.5 * next);
        if (std::abs(better - next) <= settled * a) return better;
        next = better;
    }
    return undefined;
}

}  // namespace

EdgeCourse edge_course(const RetractingEdge& edge, double radius, const EdgeParameters& parameters) {
    constexpr Index min_steps = 2000;
    const Index n = edge.time.size();
    const Index divisions = std::max<Index>(1, (min_steps + n - 1) / std::max<Index>(1, n - 1));
    EdgeCourse course{.contact_radius = Array1D::Constant(n, undefined), .speed = Array1D::Constant(n, undefined)};
    course.by_logarithm.setConstant(n, EdgeCourse::parameters, undefined);
    double a = parameters.first_radius;
    Slopes slopes = Slopes::Zero();
    slopes[by_first_radius] = a;
    Receding now = receding(a, edge.force[0], radius, parameters);
    for (Index i = 0;; ++i) {
        course.contact_radius[i] = a;
        course.speed[i] = now.speed;
        course.by_logarithm.row(i) = slopes;
        if (i + 1 == n) return course;
        const double step = (edge.time[i + 1] - edge.time[i]) / static_cast<double>(divisions);
        for (Index k = 1; k <= divisions; ++k) {
            const double share = static_cast<double>(k) / static_cast<double>(divisions);
            const double force = edge.force[i] + share * (edge.force[i + 1] - edge.force[i]);
            a = next_radius(a, step, now, force, radius, parameters);
            if (!std::isfinite(a)) return course;
            const Receding then = receding(a, force, radius, parameters);
            slopes = (slopes - 0.5 * step * (now.by_radius * slopes + now.by_logarithm + then.by_logarithm)) /
                     (1.0 + 0.5 * step * then.by_radius);
            now = then;
        }
    }
}

}  // namespace setae::loops
