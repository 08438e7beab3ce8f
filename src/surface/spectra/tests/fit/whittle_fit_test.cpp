// SPDX-License-Identifier: GPL-3.0-or-later
#include "fit/whittle_fit.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"

namespace setae::spectral_fit::whittle_fit_test {
namespace {

const LogSpline& spline() {
    static const LogSpline made(1e5, 1e8);
    return made;
}

double truth(double q) { return 1e-30 * std::pow(1.0 + q / 1e6, -3.4); }

/// A class that measures C_iso directly at forty wavevectors per decade.
PeriodogramClass direct(double from, double to, double freedom) {
    PeriodogramClass c;
    const Index n = static_cast<Index>(40.0 * std::log10(to / from));
    c.instrument = "direct";
    c.wavevector = c.nodes = Array1D::LinSpaced(n, std::log(from), std::log(to)).exp();
    c.response = Eigen::MatrixXd::Identity(n, n).array();
    c.periodogram = c.nodes.unaryExpr([](double q) { return truth(q); });
    c.freedom = Array1D::Constant(n, freedom);
    c.log_followed = c.followed_response = Array1D::Zero(n);
    return c;
}

/// True amplitude as measured by a class with a tip.
double amplitude_of_truth(double order) {
    double sum = 0.0;
    constexpr int n = 40000;
    for (int i = 0; i < n; ++i) {
        const double q = 1e8 * (i + 0.5) / n;
        sum += std::pow(q, order) * truth(q) * 1e8 / n;
    }
    return sum;
}

double log_error(const WhittleFit& fit, double q) { return std::log(spline().value(fit.theta, q) / truth(q)); }

TEST(WhittleFit, RecoversASmoothSpectrum) {
    const auto fit = fit_whittle({direct(1e5, 9.9e7, 1e4)}, spline(), {});
    EXPECT_TRUE(fit.converged);
    for (const double q : {2e5, 1e6, 7e6, 9e7}) EXPECT_NEAR(log_error(fit, q), 0.0, 2e-3) << q;
}

// E = C + σ² N: noise and surface are distinguished where C is below it.
TEST(WhittleFit, SeparatesNoiseFromTheSurface) {
    auto c = direct(1e5, 9.9e7, 1e4);
    constexpr double noise = 1e-34;
    c.noise_response = Array1D::Ones(c.nodes.size());
    c.periodogram += noise;
    const auto fit = fit_whittle({c, direct(1e7, 9.9e7, 1e4)}, spline(), {});
    EXPECT_NEAR(fit.log_noise[0], std::log(noise), 0.05);
    EXPECT_TRUE(std::isnan(fit.log_noise[1]));
    EXPECT_NEAR(log_error(fit, 5e7), 0.0, 5e-3);
}

// A tip with ln T = −0.3 (A/A_true), linearised where A was 20 % too large: the fit returns to the true value, because
// T responds to A.
TEST(WhittleFit, AccountsForTheTipResponseToAmplitude) {
    auto c = direct(1e5, 9.9e7, 1e4);
    const double A = amplitude_of_truth(1.0);
    c.periodogram *= std::exp(-0.3);
    c.amplitude_order = 1.0;
    c.amplitude_end = 1e8;
    c.reference_amplitude = 1.2 * A;
    c.followed_response = Array1D::Constant(c.nodes.size(), -0.3 / std::log(1.2) * 0.2);
    c.log_followed = Array1D::Constant(c.nodes.size(), -0.3 * 1.2);
    const auto fit = fit_whittle({c}, spline(), {});
    EXPECT_TRUE(fit.converged);
    EXPECT_NEAR(log_error(fit, 1e6), 0.0, 0.01);
    // without the response it keeps the effect of the wrong T
    c.reference_amplitude = 0.0;
    EXPECT_NEAR(log_error(fit_whittle({c}, spline(), {}), 1e6), 0.06, 0.01);
}

/// A tip that follows an eighth of the power below 1e6 1/m, and adds seven times as much.
PeriodogramClass mostly_added(double freedom) {
    auto c = direct(1e5, 1e6, freedom);
    c.log_followed = Array1D::Constant(c.nodes.size(), std::log(0.125));
    c.added = 0.875 * c.periodogram;
    c.added_response = Array1D::Zero(c.nodes.size());
    c.periodogram = 0.125 * c.periodogram + c.added;
    return c;
}

TEST(WhittleFit, SubtractsPowerAddedByTheTip) {
    const auto fit = fit_whittle({mostly_added(1e6), direct(1e6, 9.9e7, 1e4)}, spline(), {});
    EXPECT_TRUE(fit.converged);
    for (const double q : {2e5, 5e5, 7e6}) EXPECT_NEAR(log_error(fit, q), 0.0, 5e-3) << q;
}

// 1 % of the added power is 7 % of the followed one: an error of 1 % of a band of added power leaves C_iso with an
// error of 7 %.
TEST(WhittleFit, PropagatesTheErrorOfPowerAddedByTheTip) {
    const auto error = [](double known_to) {
        auto c = mostly_added(1e6);
        if (known_to > 0.0) c.added_errors = Array2D::Constant(1, c.nodes.size(), known_to);
        const auto fit = fit_whittle({c, direct(1e7, 9.9e7, 1e4)}, spline(), {.bend = 3.0, .slope = 3.0});
        const Eigen::MatrixXd design = spline().design(Array1D::Constant(1, 3e5));
        return std::sqrt((design * fit.covariance * design.transpose())(0, 0));
    };
    EXPECT_LT(error(0.0), 0.02);
    EXPECT_NEAR(error(0.01), 0.07, 0.015);
}

// P is gamma distributed with ν about E: the covariance is the scatter of the fits. The error of a standard deviation
// from 300 fits is 4 %.
TEST(WhittleFit, CovarianceIsTheScatterOfFits) {
    constexpr double freedom = 6.0;
    constexpr int fits = 300;
    std::mt19937_64 random(3);
    std::gamma_distribution<double> gamma(freedom, 1.0 / freedom);
    const auto exact = direct(1e5, 9.9e7, freedom);
    Array1D at(2);
    at << 1e6, 2e7;
    const Eigen::MatrixXd design = spline().design(at);
    Eigen::Vector2d sum = Eigen::Vector2d::Zero(), squares = sum, stated = sum;
    for (int f = 0; f < fits; ++f) {
        auto c = exact;
        for (Index k = 0; k < c.periodogram.size(); ++k) c.periodogram[k] *= gamma(random);
        const auto fit = fit_whittle({c}, spline(), {});
        const Eigen::Vector2d error(log_error(fit, at[0]), log_error(fit, at[1]));
        sum += error;
        squares += error.cwiseAbs2();
        stated += (design * fit.covariance * design.transpose()).diagonal();
    }
    for (int i = 0; i < 2; ++i) {
        const double bias = sum[i] / fits, scatter = std::sqrt(squares[i] / fits - bias * bias),
                     deviation = std::sqrt(stated[i] / fits);
        EXPECT_NEAR(bias, 0.0, 4.0 * scatter / std::sqrt(fits) + 0.01) << at[i];
        EXPECT_NEAR(scatter / deviation, 1.0, 0.2)
            << at[i];  // the prior contributes to the covariance, less to the scatter
        EXPECT_LT(scatter, 1.1 * deviation);
    }
}

TEST(WhittleFit, RefusesDataWithoutModes) {
    EXPECT_THROW((void)fit_whittle({direct(1e5, 1e8, 0.0)}, spline(), {}), InvalidArgument);
}

TEST(SplineMoment, HasTheValueAndDerivativeOfTheIntegral) {
    const auto theta = fit_whittle({direct(1e5, 9.9e7, 1e4)}, spline(), {}).theta;
    for (const double order : {1.0, 5.0}) {
        const auto moment = spline_moment(spline(), theta, order, 1e8);
        EXPECT_NEAR(moment.value / amplitude_of_truth(order), 1.0, 5e-3) << order;
        EXPECT_NEAR(moment.gradient.sum() / moment.value, 1.0, 1e-9) << "all coefficients up by ε raise it by ε";
    }
}

}  // namespace
}  // namespace setae::spectral_fit::whittle_fit_test
