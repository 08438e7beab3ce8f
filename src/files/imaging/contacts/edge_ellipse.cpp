// SPDX-License-Identifier: GPL-3.0-or-later
#include "edge_ellipse.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <Eigen/Cholesky>

#include "setae/core/statistics.hpp"

namespace setae::imaging {
namespace {

constexpr double tukey = 4.685;  // 95 % efficient for Gaussian scatter
constexpr double mad_to_deviation = 1.4826;
constexpr int reweightings = 6;

double median_magnitude(const std::vector<double>& values) {
    std::vector<double> magnitudes(values.size());
    std::transform(values.begin(), values.end(), magnitudes.begin(), [](double v) { return std::abs(v); });
    return upper_median(std::move(magnitudes));
}

/// (1 + ρ)/(1 − ρ), the variance of a mean over that of independent residuals for a correlation ρ of neighbours (powers
/// of ρ for farther ones); pairs are used if both agree. `parameters` were fitted to the residuals. At least 1.
double correlation_factor(const std::vector<double>& residuals, const std::vector<double>& weights, int parameters) {
    constexpr double most = 0.8;
    const auto n = residuals.size();
    double variance = 0, counted = 0, product = 0, pairs = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const auto j = (i + 1) % n;
        if (weights[i] > 0) {
            variance += residuals[i] * residuals[i];
            counted += 1;
        }
        if (weights[i] > 0 && weights[j] > 0) {
            product += residuals[i] * residuals[j];
            pairs += 1;
        }
    }
    if (pairs < 12 || variance <= 0) return 1.0;
    const double correlation =
        std::clamp(product / pairs / (variance / counted) + parameters / counted, 0.0, most);  // the fit subtracts p/n
    return (1 + correlation) / (1 - correlation);
}

std::uint64_t mixed(std::uint64_t value) {  // splitmix64, Steele, Lea & Flood 2014
    value += 0x9E3779B97F4A7C15U;
    value = (value ^ (value >> 30)) * 0xBF58476D1CE4E5B9U;
    value = (value ^ (value >> 27)) * 0x94D049BB133111EBU;
    return value ^ (value >> 31);
}

}  // namespace

double Outline::stretch() const { return std::hypot(stretch_cosine, stretch_sine); }
double Outline::angle() const { return 0.5 * std::atan2(stretch_sine, stretch_cosine); }

double Outline::radius_at(double polar_angle) const {
    const double t = polar_angle - angle();
    return 1.0 / std::hypot(std::cos(t) / semi_major(), std::sin(t) / semi_minor());
}

OutlineDistance::OutlineDistance(const Outline& outline)
    : centre_x_(outline.centre_x),
      centre_y_(outline.centre_y),
      cosine_(std::cos(outline.angle())),
      sine_(std::sin(outline.angle())),
      inverse_major_(1.0 / outline.semi_major()),
      inverse_minor_(1.0 / outline.semi_minor()) {}

double OutlineDistance::operator()(double x, double y) const {
    const double dx = x - centre_x_, dy = y - centre_y_;
    const double u = (cosine_ * dx + sine_ * dy) * inverse_major_, v = (cosine_ * dy - sine_ * dx) * inverse_minor_;
    const double level = std::sqrt(u * u + v * v);
    if (level < 1e-9) return -1.0 / inverse_minor_;
    const double slope_x = u * inverse_major_, slope_y = v * inverse_minor_;
    return level * (level - 1.0) / std::sqrt(slope_x * slope_x + slope_y * slope_y);
}

OutlineCorrection corrected_outline(const Outline& outline, const std::vector<EdgeOffset>& offsets,
                                    OutlineShape shape) {
    using Matrix = Eigen::Matrix<double, 5, 5>;
    using Vector = Eigen::Matrix<double, 5, 1>;
    const int parameters = shape == OutlineShape::circle ? 3 : 5;
    const auto n = offsets.size();
    OutlineCorrection result{outline, std::vector<double>(n, 1.0), Matrix::Zero()};
    if (n < static_cast<std::size_t>(parameters) + 3) return result;
    std::vector<Vector> rows(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double c = std::cos(offsets[i].angle), s = std::sin(offsets[i].angle);
        rows[i] << c, s, 1.0, c * c - s * s, 2.0 * c * s;
        if (shape == OutlineShape::circle) rows[i].tail<2>().setZero();
    }
    std::vector<double> residuals(n);
    Vector step = Vector::Zero();
    Matrix normal;
    for (int round = 0; round < reweightings; ++round) {
        normal.setZero();
        Vector right = Vector::Zero();
        for (std::size_t i = 0; i < n; ++i) {
            const double weight = result.weights[i] / offsets[i].variance;
            normal.noalias() += weight * rows[i] * rows[i].transpose();
            right += weight * offsets[i].offset * rows[i];
        }
        if (shape == OutlineShape::circle) normal(3, 3) = normal(4, 4) = 1.0;
        const auto factors = normal.ldlt();
        if (factors.info() != Eigen::Success || factors.rcond() < 1e-7) return result;
        step = factors.solve(right);
        for (std::size_t i = 0; i < n; ++i)
            residuals[i] = (offsets[i].offset - rows[i].dot(step)) / std::sqrt(offsets[i].variance);
        result.scale = std::max(1e-6, mad_to_deviation * median_magnitude(residuals));
        for (std::size_t i = 0; i < n; ++i) {
            const double t = residuals[i] / (tukey * result.scale);
            result.weights[i] = std::abs(t) < 1.0 ? (1 - t * t) * (1 - t * t) : 0.0;
        }
    }
    // variance of an M-estimator: ⟨ψ²⟩/⟨ψ'⟩² with ψ = residual times weight (Huber 1981, ch. 7)
    double influence = 0, slope = 0, agreeing = 0;
    for (std::size_t i = 0; i < n; ++i) {
        if (result.weights[i] <= 0) continue;
        const double t = residuals[i] / (tukey * result.scale);
        influence += std::pow(result.weights[i] * residuals[i], 2);
        slope += (1 - t * t) * (1 - 5 * t * t);
        agreeing += 1;
    }
    if (agreeing < parameters + 3 || slope <= 0) return result;
    const double freedom = agreeing - parameters;
    // never below the scatter from pixel noise; the last factor is the variance of Student's t, because few offsets
    // determine their scatter poorly
    const double scatter =
        std::max(1.0, influence * agreeing / (slope * slope) * (agreeing / freedom) * (freedom / (freedom - 2)));
    normal.setZero();
    for (std::size_t i = 0; i < n; ++i)
        if (result.weights[i] > 0) normal.noalias() += rows[i] * rows[i].transpose() / offsets[i].variance;
    if (shape == OutlineShape::circle) normal(3, 3) = normal(4, 4) = 1.0;
    result.covariance =
        normal.ldlt().solve(Matrix::Identity()) * scatter * correlation_factor(residuals, result.weights, parameters);
    if (shape == OutlineShape::circle)
        result.covariance.bottomRows<2>().setZero(), result.covariance.rightCols<2>().setZero();
    result.outline.centre_x += step[0];
    result.outline.centre_y += step[1];
    result.outline.mean_radius += step[2];
    if (shape == OutlineShape::ellipse) {
        result.outline.stretch_cosine += step[3];
        result.outline.stretch_sine += step[4];
    }
    result.largest_step = step.cwiseAbs().maxCoeff();
    result.solved = result.outline.semi_minor() > 0.3 * result.outline.semi_major();
    return result;
}

Outline consensus_circle(const std::vector<EdgePoint>& points, double tolerance, const Outline& otherwise) {
    constexpr std::uint64_t triples = 100;
    const auto n = points.size();
    Outline best = otherwise;
    const auto agreeing = [&](const Outline& circle) {
        return std::count_if(points.begin(), points.end(), [&](const EdgePoint& p) {
            return std::abs(std::hypot(p.x - circle.centre_x, p.y - circle.centre_y) - circle.mean_radius) < tolerance;
        });
    };
    auto most = agreeing(otherwise);
    if (n < 6) return best;
    for (std::uint64_t k = 0; k < triples; ++k) {
        // three points about a third of the perimeter apart, or arbitrary
        const auto first = mixed(3 * k) % n, second = (first + 1 + mixed(3 * k + 1) % (n - 1)) % n,
                   third = (first + 1 + mixed(3 * k + 2) % (n - 1)) % n;
        if (second == third) continue;
        const auto &a = points[first], &b = points[second], &c = points[third];
        const double bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y, cross = 2.0 * (bx * cy - by * cx);
        if (std::abs(cross) < 1.0) continue;
        const double ux = (cy * (bx * bx + by * by) - by * (cx * cx + cy * cy)) / cross,
                     uy = (bx * (cx * cx + cy * cy) - cx * (bx * bx + by * by)) / cross;
        const Outline circle{a.x + ux, a.y + uy, std::hypot(ux, uy)};
        if (const auto count = agreeing(circle); count > most) {
            most = count;
            best = circle;
        }
    }
    return best;
}

}  // namespace setae::imaging
