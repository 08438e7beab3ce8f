// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "setae/parallel/for_each.hpp"
#include "setae/validation/comparison.hpp"

namespace setae::validation {

/// What an arithmetic mean of spectra leaves uncorrected.
struct Causes {
    bool segments = false;          ///< straight lines between the points of contours
    bool trend_and_window = false;  ///< tilt or parabola removed and Hann window, in place of C1D(q_k)
    bool aliasing = false;          ///< waves shorter than two pixels
    bool tip = false;               ///< a ball in place of a point
    bool eq11 = false;              ///< C_iso by [D19] (11) in place of the exact moments
};

/// One row of the table: a name and what is switched on.
struct NamedCauses {
    std::string name;
    Causes causes;
};

/// None, each alone, all of them.
[[nodiscard]] std::vector<NamedCauses> all_causes();

struct CausesOptions {
    int runs = 10;
    std::uint64_t first_seed = 1;  ///< as ValidationOptions
    std::string folder;            ///< where data sets are made; each is removed when it is analysed
    parallel::Threads threads;
    std::function<void(int done)> progress;
};

/// What [D19]'s mean over measurements would read of a recipe's surfaces if every periodogram were its own expectation
/// under some of the causes alone: no scatter, so that a few surfaces show the effect.
///
/// Reliable bands, shapes and points are those of simulated measurements. In the place of their C1D stand, of the
/// planted one,
///   segments: C1D R(q) (spectra::SegmentResponse);   trend and window: K C_iso (spectral_fit::scan_kernel), nodes up
///   to Nyquist; aliasing: Σ_m C1D(|q + 2πm/Δ|);   tip: C1D T(q) (spectral_fit::tip_response)
/// and all their products. Comparisons as of validations, method: the name; work_of_adhesion: at E* = 1 MPa from the
/// planted W_app; work_of_adhesion_from_loss: W_int r/r_found.
/// @throws as run_validation.
[[nodiscard]] std::vector<Comparison> readings_by_cause(const std::string& recipe, const CausesOptions& options);

}  // namespace setae::validation
