// SPDX-License-Identifier: GPL-3.0-or-later
// What detrending, window and sampling do to a periodogram, against what was measured on random lines (THEORY §4.2).
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "setae/core/constants.hpp"
#include "setae/spectral_fit/hat_node.hpp"
#include "setae/spectral_fit/scan_kernel.hpp"
#include "setae/validation/causes.hpp"
#include "setae/validation/summary.hpp"

namespace causes_test {

using namespace setae;

/// E[P_k]/C1D(q_k) of the first fourteen modes of n points for C_iso = q^−(2+2H), so that C1D ∝ q^−(1+2H); relative to
/// the fourteenth, which reads the true surface.
Array1D first_modes(Index points, int trend_degree, double hurst) {
    constexpr Index first = -180, last = 90;
    const auto kernel = spectral_fit::scan_kernel({points, trend_degree}, first, last, {1});
    const Array1D nodes =
        (Array1D::LinSpaced(last - first + 1, double(first), double(last)) * spectral_fit::node_spacing).exp();
    const Array1D expected = (kernel.response.matrix() * nodes.pow(-2.0 - 2.0 * hurst).matrix()).array();
    const Array1D modes = Array1D::LinSpaced(14, 1.0, 14.0);
    const Array1D ratio = expected.head(14) * modes.pow(1.0 + 2.0 * hurst);
    return ratio / ratio[13];
}

TEST(TrendAndWindow, BiasTheFirstModesAsForRandomLines) {
    for (const double hurst : {0.7, 0.8, 0.9}) {
        const auto tilt = first_modes(512, 1, hurst), parabola = first_modes(512, 2, hurst);
        EXPECT_NEAR(tilt[0], 0.5, 0.1) << hurst;
        EXPECT_NEAR(tilt[1], 1.65, 0.25) << hurst;
        EXPECT_NEAR(tilt[2], 1.25, 0.1) << hurst;
        EXPECT_NEAR(tilt[3], 1.1, 0.06) << hurst;
        EXPECT_NEAR(parabola[0], 0.17, 0.05) << hurst;
        EXPECT_NEAR(parabola[1], 1.25, 0.1) << hurst;
        EXPECT_NEAR(parabola[2], 1.2, 0.1) << hurst;
        EXPECT_NEAR(parabola[3], 1.1, 0.06) << hurst;
    }
}

// Each cause alone, on the first surfaces of the closure: signs and sizes of THEORY §4.2.
TEST(Causes, HaveTheEffectsOfTheory) {
    const auto folder = (std::filesystem::temp_directory_path() / "setae_causes").string();
    const auto rows = validation::summary(validation::readings_by_cause("tests/reference/validation/surfaces.toml",
                                                                        {.runs = 1, .folder = folder, .threads = {2}}));
    std::filesystem::remove_all(folder);
    const auto bias = [&](const char* quantity, const char* cause) {
        for (const auto& row : rows)
            if (row.quantity == quantity && row.method == cause) return row.bias;
        ADD_FAILURE() << quantity << " by " << cause;
        return undefined;
    };
    EXPECT_NEAR(bias("rms_height", "none"), 0.0, 0.02);
    EXPECT_NEAR(bias("rms_slope", "none"), 0.0, 0.02);
    EXPECT_NEAR(bias("elastic_energy_per_modulus", "none"), 0.0, 0.02);
    EXPECT_NEAR(bias("rms_slope", "segments"), -0.08, 0.03);
    EXPECT_NEAR(bias("rms_curvature", "segments"), -0.30, 0.05);
    EXPECT_LT(bias("rms_height", "tip"), -0.04);
    EXPECT_LT(bias("elastic_energy_per_modulus", "tip"), -0.02);
    EXPECT_GT(bias("C1D 1e6", "aliasing"), 0.02);
    EXPECT_NEAR(bias("rms_height", "eq. (11)"), std::sqrt(0.5 * pi) - 1.0, 0.02);
}

}  // namespace causes_test
