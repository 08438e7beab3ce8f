// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/loops/loop.hpp"

namespace setae::loops {

/// The smallest force of a stretch.
struct ForceMinimum {
    Index sample = 0;
    double force = 0.0;           ///< [N]
    double standard_error = 0.0;  ///< from noise or, if larger, the scatter about the parabola [N]
};

/// Noise of a sample [N], and number of samples whose mean is as noisy as that of one independent sample.
struct SampleNoise {
    double sigma = 0.0;
    double correlated_samples = 1.0;
};

/// The smallest force in a section that starts at a larger one.
///
/// The smallest of noisy samples lies about two standard deviations below the smallest force. Therefore a parabola is
/// fitted to the samples around it whose averaged force is within a share s of it, s² = 2σ/|F| and at most 5 %, and its
/// vertex is used. On a JKR curve at constant speed the vertex is 0.05 s² of the force too high: a tenth of the noise.
/// Without noise (σ < 1e-6 |F|) it is the smallest sample.
[[nodiscard]] ForceMinimum smallest_force(const Array1D& force, const IndexRange& stretch, const SampleNoise& noise);

}  // namespace setae::loops
