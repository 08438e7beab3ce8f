// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "setae/study/surface_analysis.hpp"

namespace setae::study_figures {

/// A surface's spectrum as it is drawn.
struct SurfaceCurve {
    Array1D wavevector;    ///< [1/m]
    Array1D values;        ///< [m³] or [m⁴]
    Array1D lower, upper;  ///< 95 % band; empty where it is unknown
    std::string method;    ///< "likelihood", "average", "given" or "moments"
};

/// C1D of the spectrum used for all other results, within the limits of the study; empty for a failed surface.
///
/// C1D of a C_iso with an end is left out near it, where it decreases to 0 because shorter waves are missing.
/// Fitted spectra: C1D exp(± 1.96 SE of ln C1D).  Averages: C1D ± t SE between measurements, t Student's with their
/// number in the bin minus one, where there are two or more.
[[nodiscard]] std::optional<SurfaceCurve> C1D_of(const study::SurfaceResult& surface);

/// C_iso of the same spectrum. C1D is converted as in the study: by the inverse Abel integral, or by Eq. 11.
[[nodiscard]] std::optional<SurfaceCurve> C_iso_of(const study::SurfaceResult& surface,
                                                   roughness::Conversion conversion);

/// Name of a method of SurfaceCurve for readers.
[[nodiscard]] std::string method_in_words(const std::string& method);

}  // namespace setae::study_figures
