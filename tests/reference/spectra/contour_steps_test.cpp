// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/fourier/nonuniform.hpp"
#include "setae/spectra/power_spectrum.hpp"

namespace contour_steps_test {

using namespace setae;
using namespace setae::spectra;
using topography::Profile;

constexpr double rolloff = 0.05, band = pi;  // [1/m] for a mean step of 1 m

/// Flat to the roll-off, then q^−2.6 (a line on a surface with H = 0.8), nothing beyond the band.
double true_spectrum(double q) { return q >= band ? 0.0 : std::pow(std::max(q, rolloff) / rolloff, -2.6); }

/// A Gaussian line of that spectrum, as waves twice as close as the line's own modes, at points with steps between half
/// and one and a half of their mean.
Profile random_line(std::mt19937_64& engine, Index points) {
    std::uniform_real_distribution<double> step(0.5, 1.5);
    std::normal_distribution<double> number;
    Profile line{Array1D::Zero(points), Array1D(points), {}};
    for (Index k = 1; k < points; ++k) line.positions[k] = line.positions[k - 1] + step(engine);
    const double spacing = pi / line.size();
    const auto waves = static_cast<Index>(band / spacing);
    const Array1D q = Array1D::LinSpaced(waves, 0.5, static_cast<double>(waves) - 0.5) * spacing;
    // h = sum √(C spacing/π) (a cos qx + b sin qx): h_rms² = (1/π)∫C dq
    const Array1D amplitude = q.unaryExpr([&](double p) { return std::sqrt(true_spectrum(p) * spacing / pi); });
    const Array1D a = amplitude.unaryExpr([&](double scale) { return scale * number(engine); });
    const Array1D b = amplitude.unaryExpr([&](double scale) { return scale * number(engine); });
    line.heights = fourier::nonuniform_transform(q, a, line.positions).real() -
                   fourier::nonuniform_transform(q, b, line.positions).imag();
    return line;
}

/// Mean over lines of measured over true C1D in bands of q up to 0.8 of the end, by mean of ratios.
std::vector<double> recovered(ContourTreatment treatment, int lines) {
    const std::vector<double> edges{0.1, 0.25, 0.4, 0.5, 0.6, 0.7, 0.8};
    std::vector<double> sums(edges.size() - 1, 0.0), counts = sums;
    std::mt19937_64 engine(20);
    for (int line = 0; line < lines; ++line) {
        const auto spectrum = power_spectrum(random_line(engine, 401), {.contour = treatment});
        for (Index k = 0; k < spectrum.wavevector.size(); ++k)
            for (std::size_t b = 0; b + 1 < edges.size(); ++b)
                if (spectrum.wavevector[k] >= edges[b] * band && spectrum.wavevector[k] < edges[b + 1] * band) {
                    sums[b] += spectrum.density[k] / true_spectrum(spectrum.wavevector[k]);
                    counts[b] += 1.0;
                }
    }
    for (std::size_t b = 0; b < sums.size(); ++b) sums[b] /= counts[b];
    return sums;
}

TEST(ContourSteps, CorrectionRecoversTrueSpectraToFourFifthsOfTheBand) {
    // 400 lines, at least 20 modes a band, neighbours sharing the Hann window: statistical error about 1 %
    for (const double ratio : recovered(ContourTreatment::sinc_corrected, 400)) EXPECT_NEAR(ratio, 1.0, 0.03);
}

TEST(ContourSteps, SegmentsLosePowerAsTheResponse) {
    const auto kept = recovered(ContourTreatment::segments, 40);
    EXPECT_GT(kept.front(), 0.9);
    EXPECT_LT(kept.back(), 0.45);
}

}  // namespace contour_steps_test
