// SPDX-License-Identifier: GPL-3.0-or-later
// Foils through white noise: the silhouette of n lines is the highest of n normal numbers.
#include <cmath>

#include <gtest/gtest.h>

#include "setae/simulation/projection_bias.hpp"

namespace silhouette_test {

using namespace setae;
using namespace setae::simulation;

struct Highest {
    int lines;
    double mean, variance;  // of the highest of so many standard normal numbers
};

TEST(Silhouette, OfWhiteNoiseHasTheMomentsOfTheMaximumOfNormalNumbers) {
    const double pixel = 1e-9, height = 2e-9;
    const spectra::SpectralDensity white = [=](double) { return height * height * pixel * pixel; };
    for (const auto& expected : {Highest{2, 0.564189583548, 0.681690113816}, Highest{3, 0.846284375322, 0.559467203797},
                                 Highest{5, 1.16296447364, 0.447534069021}, Highest{10, 1.53875273084, 0.344343823261},
                                 Highest{20, 1.8674750598, 0.275696615619}}) {
        ProjectionOptions options;
        options.thickness = (expected.lines - 1) * pixel;
        options.grid = {200, 240, 200 * pixel, 240 * pixel};
        options.surfaces = 20;
        options.key = {5, static_cast<std::uint64_t>(expected.lines)};
        const auto bias = projection_bias(white, options);
        // 960 000/lines independent highest values of kurtosis below 3.6: variance to √(2.6/n)
        const double values = 960000.0 / expected.lines, error = std::sqrt(2.6 / values);
        EXPECT_NEAR(std::pow(bias.rms_height.value, 2) / expected.variance, 1.0, 4.0 * error) << expected.lines;
        EXPECT_NEAR(bias.rms_slope.value, bias.rms_height.value, 4.0 * error) << expected.lines;
        // the line scans' own rms, about each line's mean, is √(1 − 1/200) of the noise
        EXPECT_NEAR(bias.mean_height_shift, expected.mean / std::sqrt(1.0 - 1.0 / 200.0),
                    4.0 * std::sqrt(expected.variance / values))
            << expected.lines;
        for (Index b = 0; b < bias.C1D.size(); ++b)
            EXPECT_NEAR(bias.C1D[b], expected.variance, 5.0 * bias.C1D_standard_error[b]) << expected.lines << ' ' << b;
        // the standard error the test rests on: of the highest bin, a third of all modes
        const auto last = bias.C1D.size() - 1;
        EXPECT_LT(bias.C1D_standard_error[last], 4.0 * expected.variance * std::sqrt(2.0 / (values / 3.0)))
            << expected.lines;
        EXPECT_TRUE(std::isfinite(bias.correlation_length));
        EXPECT_LT(bias.correlation_length, pixel);
    }
}

}  // namespace silhouette_test
