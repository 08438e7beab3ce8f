// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/core/arrays.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/spectra/reliability.hpp"
#include "setae/spectra/window.hpp"
#include "setae/topography/detrend.hpp"

namespace setae::spectra {

/// Interpretation of the straight segments between the points of a traced contour.
enum class ContourTreatment {
    sinc_corrected,  ///< points are samples of a curve: the spectrum of the segments is divided by segment_response
    segments,        ///< the segments are the curve ([D19])
};

struct SpectrumOptions {
    Window window = Window::automatic;
    topography::Trend trend = topography::Trend::mean;            ///< trend removed before the window
    ContourTreatment contour = ContourTreatment::sinc_corrected;  ///< profiles only
    bool trace_response = true;          ///< correct profiles for the known response of their trace; false: as traced
    std::optional<Array1D> wavevectors;  ///< [1/m], profiles only; default 2πk/L up to π/(mean step)
    ReliabilityOptions reliability;
    parallel::Threads threads;
};

}  // namespace setae::spectra
