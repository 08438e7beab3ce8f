// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/answers/self_affine.hpp"
#include "setae/core/table.hpp"
#include "setae/output/json.hpp"
#include "setae/study/surface_analysis.hpp"

namespace setae::answers {

/// What `setae psd` is asked.
struct PowerSpectrumRequest {
    study::SurfaceInput surface;
    study::SurfaceAnalysisOptions analysis;
    bool isotropic = false;  ///< also C_iso, on the combined grid
    bool abel = false;       ///< also C_iso by the inverse Abel transform, on the combined grid
    bool binned = false;     ///< one measurement on the combined grid too
    SelfAffineRequest fit;
    bool every_measurement = false;  ///< the first failure of one is thrown, in place of a spectrum without it
};

/// The spectrum of a surface: C1D of the one measurement, mode by mode, or of all in the bins of the combined grid.
///
/// Columns: wavevector [1/m], C1D [m³], standard_error [m³], count; and what else was asked for. Without columns where
/// the surface failed.
struct PowerSpectrum {
    study::SurfaceResult surface;
    Table table;
    std::optional<spectra::SelfAffineFit> fit;
};

/// @throws InvalidArgument for what a table of a spectrum cannot answer; what the fit throws; what reading throws where
/// every measurement is wanted.
[[nodiscard]] PowerSpectrum power_spectrum(const PowerSpectrumRequest& request, parallel::Threads threads = {});

/// Columns by name, "units", "conventions", "band", "measurements", "alerts" and "fit".
[[nodiscard]] output::Json to_json(const PowerSpectrum& spectrum);

}  // namespace setae::answers
