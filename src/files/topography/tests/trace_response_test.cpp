// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/topography/trace_response.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include <Eigen/LU>

#include "setae/core/constants.hpp"

namespace setae::topography::trace_response_test {
namespace {

TEST(SmoothingTransfer, EqualsThatOfAnEquidistantSmoothingSpline) {
    // the discrete smoother min Σ(g − h)² + λ Σ(Δ²g)² on a ring: λ = (smoothing_length/step)⁴
    const Index n = 48;
    const TraceResponse response{0.0, 0.9, 0.5, 0.0};
    Eigen::MatrixXd differences = Eigen::MatrixXd::Zero(n, n);
    for (Index i = 0; i < n; ++i) {
        differences(i, i) = -2.0;
        differences(i, (i + 1) % n) = differences(i, (i + n - 1) % n) = 1.0;
    }
    const Eigen::MatrixXd smoother =
        (Eigen::MatrixXd::Identity(n, n) + std::pow(0.9 / 0.5, 4) * differences.transpose() * differences).inverse();
    const Array1D positions = Array1D::LinSpaced(n, 0.0, 0.5 * (n - 1));
    for (const int mode : {1, 5, 12, 24}) {
        const double q = 2.0 * pi * mode / (0.5 * n);
        const Eigen::VectorXd wave = (q * positions).cos().matrix();
        const double kept = (smoother * wave)[0] / wave[0];
        EXPECT_NEAR(smoothing_transfer(response, Array1D::Constant(1, q))[0], kept, 1e-12) << mode;
    }
}

TEST(TraceTransfer, OfBlurOnlyIsAGaussian) {
    const TraceResponse response{0.2, 0.0, 0.1, 0.0};
    EXPECT_NEAR(trace_transfer(response, Array1D::Constant(1, 5.0))[0], std::exp(-0.5), 1e-15);
    EXPECT_NEAR(trace_band_end(response), std::sqrt(std::log(10.0)) / 0.2, 1e-12);
}

TEST(TraceBandEnd, IsNyquistIfAllWavesAreKept) { EXPECT_NEAR(trace_band_end({0.0, 0.0, 0.1, 1.0}), 10.0 * pi, 1e-12); }

}  // namespace
}  // namespace setae::topography::trace_response_test
