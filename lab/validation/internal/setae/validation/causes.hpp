// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "setae/parallel/for_each.hpp"
#include "setae/validation/comparison.hpp"

namespace setae::validation {

/// Causes of error that an arithmetic mean of spectra does not correct.
struct Causes {
    bool segments = false;          ///< straight lines between the points of contours
    bool trend_and_window = false;  ///< tilt or parabola removed and Hann window, in place of C1D(q_k)
    bool aliasing = false;          ///< waves shorter than two pixels
    bool tip = false;               ///< a spherical tip in place of a point
    bool eq11 = false;              ///< C_iso by [D19], Eq. 11, in place of the exact moments
};

/// One row of the table: a name and its causes.
struct NamedCauses {
    std::string name;
    Causes causes;
};

/// No cause, each cause separately, all causes.
[[nodiscard]] std::vector<NamedCauses> all_causes();

struct CausesOptions {
    int runs = 10;
    std::uint64_t first_seed = 1;  ///< as ValidationOptions
    std::string folder;            ///< where data sets are made; each is removed when it is analysed
    parallel::Threads threads;
    std::function<void(int done)> progress;
};

/// Results of [D19]'s mean over measurements for a recipe's surfaces if every periodogram equals its expectation under
/// some of the causes: without scatter, so that few surfaces are sufficient.
///
/// Reliable bands, shapes and points are those of simulated measurements. Their C1D is replaced by, from the true one,
///   segments: C1D R(q) (spectra::SegmentResponse);   trend and window: K C_iso (spectral_fit::scan_kernel), nodes up
///   to Nyquist; aliasing: Σ_m C1D(|q + 2πm/Δ|);   tip: C1D T(q) (spectral_fit::tip_response)
/// and all their products. Comparisons as for validations, method: the name; work_of_adhesion: at E* = 1 MPa from the
/// true W_app; work_of_adhesion_from_loss: W_int r/r_found.
/// @throws as run_validation.
[[nodiscard]] std::vector<Comparison> readings_by_cause(const std::string& recipe, const CausesOptions& options);

}  // namespace setae::validation
