// SPDX-License-Identifier: GPL-3.0-or-later
#include "stretched_groups.hpp"

#include <algorithm>
#include <cmath>

#include "setae/core/constants.hpp"
#include "setae/numerics/dense.hpp"

namespace setae::spectral_fit {
namespace {

Array1D lengths_of(const ObservedGroup& group, const StretchLaw& law) {
    return group.data.nodes.unaryExpr([&](double q) { return std::sqrt(law.at(q).length_square(group.direction)); });
}

/// Expectation of the surface in the periodogram of a group, with the waves followed by its tip.
Array1D surface_part(const PeriodogramClass& c, const LogSpline& spline, const Eigen::VectorXd& theta) {
    Array1D C =
        (spline.design(surface_wavevectors(c).min(spline.shortest())) * theta).array().exp() * surface_factors(c);
    if (c.log_followed.size() > 0) C *= c.log_followed.exp();
    return (c.response.matrix() * C.matrix()).array();
}

}  // namespace

bool several_directions(const std::vector<ObservedGroup>& groups) {
    constexpr double same = 1e-3;
    return std::any_of(groups.begin(), groups.end(), [&](const ObservedGroup& g) {
        return std::abs(std::sin(g.direction - groups.front().direction)) > same;
    });
}

KnownStretch unknown_stretch(const Band& band) {
    constexpr double size = 1.0, change = 0.3;
    const double first = std::log(band.lower), last = std::log(band.upper);
    const auto knots = std::max<Index>(1, static_cast<Index>(std::lround((last - first) / std::log(10.0))));
    std::vector<double> places;
    for (Index k = 0; k < knots; ++k)
        places.push_back(first + (last - first) * (static_cast<double>(k) + 0.5) / static_cast<double>(knots));
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(2 * knots, 2 * knots);
    information.topLeftCorner<2, 2>().diagonal().setConstant(1.0 / (size * size));
    for (Index i = 0; i + 2 < 2 * knots; ++i) {
        const double weight = 1.0 / (change * change);
        information(i, i) += weight;
        information(i + 2, i + 2) += weight;
        information(i, i + 2) -= weight;
        information(i + 2, i) -= weight;
    }
    return {StretchLaw(places, std::vector<Eigen::Vector2d>(places.size(), Eigen::Vector2d::Zero())), information};
}

double surface_end(const StretchLaw& law, double shortest) { return shortest / std::sqrt(law.at(shortest).ratio()); }

void take_stretch(std::vector<ObservedGroup>& groups, const StretchLaw& law, double shortest) {
    for (auto& g : groups) {
        g.data.lengths = law.isotropic() ? Array1D() : lengths_of(g, law);
        g.data.surface_end = surface_end(law, shortest);
    }
}

double lines_end(const StretchLaw& law, double shortest, double direction) {
    return surface_end(law, shortest) * std::sqrt(law.at(shortest).length_square(direction));
}

std::vector<Eigen::MatrixXd> answers_to_stretch(const std::vector<ObservedGroup>& groups, const LogSpline& spline,
                                                const WhittleFit& fit, const StretchLaw& law) {
    constexpr double step = 1e-3;
    const Eigen::VectorXd values = law.values();
    std::vector<Eigen::MatrixXd> answers;
    for (std::size_t c = 0; c < groups.size(); ++c) {
        auto moved = groups[c].data;
        Eigen::MatrixXd answer(moved.wavevector.size(), values.size());
        for (Index i = 0; i < values.size(); ++i) {
            Array1D change = Array1D::Zero(moved.wavevector.size());
            for (const double side : {-1.0, 1.0}) {
                Eigen::VectorXd at = values;
                at[i] += side * step;
                const auto other = law.with(at);
                moved.lengths = lengths_of(groups[c], other);
                moved.surface_end = surface_end(other, spline.shortest());
                change += side * surface_part(moved, spline, fit.theta);
            }
            answer.col(i) = (change / (2.0 * step * fit.expected[c])).matrix();
        }
        answers.push_back(std::move(answer));
    }
    return answers;
}

StretchStep stretch_step(const std::vector<ObservedGroup>& groups, const LogSpline& spline, const WhittleFit& fit,
                         const StretchLaw& law, const KnownStretch& known) {
    constexpr double longest_step = 0.5;
    const auto answers = answers_to_stretch(groups, spline, fit, law);
    const Eigen::VectorXd values = law.values();
    Eigen::MatrixXd own = Eigen::MatrixXd::Zero(values.size(), values.size());
    Eigen::MatrixXd shared = Eigen::MatrixXd::Zero(fit.theta.size(), values.size());
    Eigen::VectorXd score = known.information * (known.law.values() - values);
    for (std::size_t c = 0; c < groups.size(); ++c) {
        const auto& data = groups[c].data;
        const Eigen::MatrixXd weighted = data.freedom.matrix().asDiagonal() * answers[c];
        own += weighted.transpose() * answers[c];
        shared += fit.jacobian[c].transpose() * weighted;
        score += weighted.transpose() * (data.periodogram / fit.expected[c] - 1.0).matrix();
    }
    const Eigen::MatrixXd marginal = own - shared.transpose() * fit.gain * shared;
    const Eigen::MatrixXd information = 0.5 * (marginal + marginal.transpose()) + known.information;
    StretchStep result;
    result.covariance = numerics::inverse(information);
    Eigen::VectorXd step = result.covariance * score;
    const double largest = step.cwiseAbs().maxCoeff();
    if (largest > longest_step) step *= longest_step / largest;
    result.law = law.with(values + step);
    return result;
}

DirectionMean direction_mean(const LogSpline& spline, const Eigen::VectorXd& theta, const StretchLaw& law,
                             const Array1D& wavevector) {
    constexpr int directions = 16;  // of 180°, periodic: exact to the stretch to the power −32
    const double end = surface_end(law, spline.shortest());
    const Index n = wavevector.size();
    Array1D sum = Array1D::Zero(n);
    DirectionMean mean{Array1D(), Eigen::MatrixXd::Zero(n, spline.coefficients())};
    for (int d = 0; d < directions; ++d) {
        const double angle = pi * d / directions;
        const Array1D moved =
            wavevector.unaryExpr([&](double q) { return q * std::sqrt(law.at(q).wave_square(angle)); });
        const Eigen::MatrixXd design = spline.design(moved.min(spline.shortest()));
        const Array1D C =
            moved.unaryExpr([end](double q) { return share_below(q, end); }) * (design * theta).array().exp();
        sum += C;
        mean.design += C.matrix().asDiagonal() * design;
    }
    mean.log_density = (sum / directions).log();
    mean.design = sum.inverse().matrix().asDiagonal() * mean.design;
    return mean;
}

Array1D density_of_lines(const LogSpline& spline, const Eigen::VectorXd& theta, const StretchLaw& law,
                         const Array1D& wavevector, double turn) {
    const double end = surface_end(law, spline.shortest());
    return wavevector.unaryExpr([&](double q) {
        const auto stretch = law.at(q);
        const double square = stretch.length_square(stretch.direction() + turn), surface = q / std::sqrt(square);
        return spline.value(theta, std::min(surface, spline.shortest())) * share_below(surface, end) / square;
    });
}

}  // namespace setae::spectral_fit
