// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/hysteresis/moving_edge.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/hysteresis/machine.hpp"
#include "setae/numerics/bracketing.hpp"

namespace setae::hysteresis {
namespace {

void require_valid(const MovingEdge& edge) {
    const auto positive = [](double value) { return value > 0.0 && std::isfinite(value); };
    if (!positive(edge.law.reference_speed) || !positive(edge.law.exponent) || !positive(edge.motor_speed) ||
        !(edge.reading_time >= 0.0 && std::isfinite(edge.reading_time)))
        throw InvalidArgument(fmt::format(
            "a moving contact edge with v0 {} m/s, n {}, motor speed {} m/s and reading time {} s; expected "
            "speeds and exponent above 0, and a time of at least 0",
            edge.law.reference_speed, edge.law.exponent, edge.motor_speed, edge.reading_time));
}

/// One sphere in one testing machine, with its edge.
class Equations {
public:
    Equations(const HystereticSphere& sphere, const Pressing& pressing, const MovingEdge& edge)
        : radius_(sphere.radius),
          modulus_(sphere.contact_modulus),
          threshold_(sphere.work_retraction),
          compliance_(1.0 / pressing.machine_stiffness),
          edge_(edge) {}

    /// m = a²/R + 4E*a³/(3R k_m) − s (1 + 2aE*/k_m) where the surface is opened by s = a²/R − δ at the edge.
    [[nodiscard]] double motor(double a, double opening) const {
        return a * a / radius_ + compliance_ * 4.0 * modulus_ * a * a * a / (3.0 * radius_) -
               opening * (1.0 + 2.0 * a * modulus_ * compliance_);
    }
    [[nodiscard]] double opening(double a, double rate) const { return std::sqrt(2.0 * pi * a * rate / modulus_); }
    [[nodiscard]] double displacement(double a, double opening) const { return a * a / radius_ - opening; }
    [[nodiscard]] double force(double a, double opening) const {
        return 2.0 * a * modulus_ * (2.0 * a * a / (3.0 * radius_) - opening);
    }
    [[nodiscard]] double threshold() const { return threshold_; }
    /// G at v = v0 exp(log_speed).
    [[nodiscard]] double rate(double log_speed) const {
        return threshold_ * (1.0 + std::exp(edge_.law.exponent * log_speed));
    }
    /// 2π a G da = E* s² da.
    [[nodiscard]] double work_per_radius(double opening) const { return modulus_ * opening * opening; }

    /// ln v/v0 at the end of a step to a < before: m(a, G(v)) + V da/v = m before. The left side decreases with v.
    [[nodiscard]] double log_speed_after(double a, double step, double motor_before, double start) const {
        const double ratio = edge_.motor_speed * step / edge_.law.reference_speed;
        const auto residual = [&](double x) {
            return motor(a, opening(a, rate(x))) - motor_before + ratio * std::exp(-x);
        };
        const auto slope = [&](double x) {
            const double fast = std::exp(edge_.law.exponent * x);
            return -0.5 * opening(a, rate(x)) * (1.0 + 2.0 * a * modulus_ * compliance_) * edge_.law.exponent * fast /
                       (1.0 + fast) -
                   ratio * std::exp(-x);
        };
        double lower = start, upper = start, x = start;
        for (double jump = 1.0; residual(lower) < 0.0; jump *= 2.0) lower -= jump;
        for (double jump = 1.0; residual(upper) > 0.0; jump *= 2.0) upper += jump;
        constexpr int most = 100;
        constexpr double rounding = 1e-13;
        for (int i = 0; i < most; ++i) {
            const double at = residual(x);
            (at > 0.0 ? lower : upper) = x;
            double next = x - at / slope(x);
            if (!(next > lower && next < upper)) next = 0.5 * (lower + upper);
            if (std::abs(next - x) <= rounding * std::max(1.0, std::abs(x))) return next;
            x = next;
        }
        return x;
    }

private:
    double radius_, modulus_, threshold_, compliance_;
    MovingEdge edge_;
};

EdgeRetractionCourse course_of(const HystereticSphere& sphere, const Pressing& pressing, const MovingEdge& edge,
                               double largest, int steps) {
    const Equations equations(sphere, pressing, edge);
    EdgeRetractionCourse course;
    for (auto* column :
         {&course.motor, &course.displacement, &course.contact_radius, &course.force, &course.energy_release_rate})
        *column = Array1D(steps + 1);
    const auto set = [&](Index k, double a, double motor, double opening, double rate) {
        course.motor[k] = motor;
        course.displacement[k] = equations.displacement(a, opening);
        course.contact_radius[k] = a;
        course.force[k] = equations.force(a, opening);
        course.energy_release_rate[k] = rate;
    };
    double opening = equations.opening(largest, equations.threshold()), motor = equations.motor(largest, opening);
    set(0, largest, motor, opening, equations.threshold());
    const double step = largest / steps;
    double log_speed = 0.0;
    for (Index k = 1; k < steps; ++k) {
        const double a = largest - step * static_cast<double>(k);
        log_speed = equations.log_speed_after(a, step, motor, log_speed);
        const double rate = equations.rate(log_speed);
        opening = equations.opening(a, rate);
        motor = equations.motor(a, opening);
        set(k, a, motor, opening, rate);
    }
    set(steps, 0.0, motor, -motor, course.energy_release_rate[steps - 1]);  // nothing pulls any more: δ = m
    return course;
}

/// Value at a position between the states i and i + 1.
double between(const Array1D& values, Index i, double share) { return values[i] + share * (values[i + 1] - values[i]); }

/// Mean of G over the motor's motion to `end` from at most `way` before.
double mean_rate(const EdgeRetractionCourse& course, double end, double way) {
    const double from = std::min(course.motor[0], end + way);
    double sum = 0.0, last = 0.0;
    for (Index i = 0; i + 1 < course.motor.size(); ++i) {
        const double upper = std::min(from, course.motor[i]), lower = std::max(end, course.motor[i + 1]);
        const double width = course.motor[i] - course.motor[i + 1];
        if (!(width > 0.0) || course.motor[i] < end) continue;
        const auto at = [&](double m) { return between(course.energy_release_rate, i, (course.motor[i] - m) / width); };
        if (lower <= end) last = at(end);
        if (upper > lower) sum += 0.5 * (at(upper) + at(lower)) * (upper - lower);
    }
    return from > end ? sum / (from - end) : last;
}

/// Where a parabola through three states has its smallest force, as contact radius; the state itself at an end.
double radius_of_smallest(const EdgeRetractionCourse& course, Index i) {
    const auto &a = course.contact_radius, &f = course.force;
    if (i == 0 || i + 1 == a.size()) return a[i];
    const double curvature = f[i - 1] - 2.0 * f[i] + f[i + 1];
    return curvature > 0.0 ? a[i] + 0.5 * (f[i + 1] - f[i - 1]) / curvature * (a[i - 1] - a[i]) : a[i];
}

EdgeRetraction summary(const EdgeRetractionCourse& course, const HystereticSphere& sphere, const MovingEdge& edge) {
    Index smallest = 0;
    course.force.minCoeff(&smallest);
    const double radius = radius_of_smallest(course, smallest);
    // by the parabola through these three states
    const auto at_smallest = [&](const Array1D& values) {
        if (smallest == 0 || smallest + 1 == values.size()) return values[smallest];
        const double x = (course.contact_radius[smallest] - radius) /
                         (course.contact_radius[smallest] - course.contact_radius[smallest + 1]);
        const double before = values[smallest - 1], here = values[smallest], after = values[smallest + 1];
        return here + 0.5 * x * (after - before) + 0.5 * x * x * (after - 2.0 * here + before);
    };
    EdgeRetraction result{
        .smallest_force = at_smallest(course.force),
        .work_read = mean_rate(course, at_smallest(course.motor), edge.motor_speed * edge.reading_time)};
    const auto work_at = [&](Index i) {
        const double a = course.contact_radius[i], opening = a * a / sphere.radius - course.displacement[i];
        return sphere.contact_modulus * opening * opening;
    };
    for (Index i = 0; i + 1 < course.motor.size(); ++i)
        result.edge_work +=
            0.5 * (work_at(i) + work_at(i + 1)) * (course.contact_radius[i] - course.contact_radius[i + 1]);
    return result;
}

/// From two courses, the error of whose numbers goes with the step.
EdgeRetraction recession_from(double largest, const HystereticSphere& sphere, const Pressing& pressing,
                              const MovingEdge& edge) {
    constexpr int steps = 200;
    const auto coarse = summary(course_of(sphere, pressing, edge, largest, steps), sphere, edge),
               fine = summary(course_of(sphere, pressing, edge, largest, 2 * steps), sphere, edge);
    const auto limit = [&](double EdgeRetraction::*number) { return 2.0 * fine.*number - coarse.*number; };
    return {.smallest_force = limit(&EdgeRetraction::smallest_force),
            .work_read = limit(&EdgeRetraction::work_read),
            .edge_work = limit(&EdgeRetraction::edge_work)};
}

/// W of an edge at rest that takes so much in all, the jump at its end included: w π a² + E_out(w).
double resting_equivalent(double largest, HystereticSphere sphere, const Pressing& pressing, double edge_work) {
    const Machine machine(pressing.machine_stiffness);
    const double area = pi * largest * largest;
    const auto excess = [&](double work) {
        sphere.work_retraction = work;
        const auto retraction = sphere.retraction();
        const double separation = std::min(largest, machine.instability_radius(retraction));
        return work * area + machine.energy(equilibrium(separation, retraction), retraction) - edge_work;
    };
    constexpr double least = 1e-9;  // share of the work at the edge
    return numerics::bracketed_root(excess, least * edge_work / area, edge_work / area, 50);
}

double read_from(double largest, const HystereticSphere& sphere, const Pressing& pressing, const MovingEdge& edge,
                 Reading reading) {
    const auto receding = recession_from(largest, sphere, pressing, edge);
    switch (reading) {
        case Reading::last_points: return receding.work_read;
        case Reading::smallest_force:
            return contact::jkr::work_of_adhesion_from_pull_off(receding.smallest_force, sphere.radius);
        case Reading::loop_area: return resting_equivalent(largest, sphere, pressing, receding.edge_work);
    }
    throw InternalError("unknown reading of W_ret");
}

}  // namespace

EdgeRetractionCourse edge_retraction_course(const HystereticSphere& sphere, const Pressing& pressing,
                                            const MovingEdge& edge, int steps) {
    require_valid(edge);
    constexpr int fewest = 8;
    if (steps < fewest)
        throw InvalidArgument(fmt::format("a retracting contact edge in {} steps; expected {} or more", steps, fewest));
    const auto loop = sphere_loop(sphere, pressing);
    return course_of(sphere, pressing, edge, loop.turning_point.contact_radius, steps);
}

EdgeRetraction edge_retraction(const HystereticSphere& sphere, const Pressing& pressing, const MovingEdge& edge) {
    require_valid(edge);
    return recession_from(sphere_loop(sphere, pressing).turning_point.contact_radius, sphere, pressing, edge);
}

double work_read(const HystereticSphere& sphere, const Pressing& pressing, const MovingEdge& edge, Reading reading) {
    require_valid(edge);
    return read_from(sphere_loop(sphere, pressing).turning_point.contact_radius, sphere, pressing, edge, reading);
}

double work_at_rest(HystereticSphere sphere, const Pressing& pressing, const MovingEdge& edge, Reading reading,
                    double read) {
    if (!(read > 0.0 && std::isfinite(read)))
        throw InvalidArgument(fmt::format("work of adhesion on retraction must be > 0 J/m2, got {}", read));
    require_valid(edge);
    sphere.work_retraction = sphere.work_approach;
    const double largest = sphere_loop(sphere, pressing).turning_point.contact_radius, least = 1e-6 * read;
    const auto excess = [&](double work) {
        sphere.work_retraction = work;
        return read_from(largest, sphere, pressing, edge, reading) - read;
    };
    constexpr int bits = 30;
    return numerics::bracketed_root(excess, least, read, bits);
}

SphereLoop sphere_loop(const HystereticSphere& sphere, const Pressing& pressing, const MovingEdge& edge) {
    auto loop = sphere_loop(sphere, pressing);
    const auto receding = edge_retraction(sphere, pressing, edge);
    loop.smallest_force = receding.smallest_force;
    loop.speed_loss = receding.edge_work - sphere.work_retraction * loop.largest_contact_area() - loop.jump_out_loss;
    return loop;
}

}  // namespace setae::hysteresis
