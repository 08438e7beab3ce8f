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
    Array1D lower, upper;  ///< 95 %; empty where nothing is known of it
    std::string method;    ///< "likelihood", "average", "given" or "moments"
};

/// C1D of the spectrum everything else rests on, within the limits of the study; nothing for a surface that failed.
///
/// C1D of a C_iso with an end is left out near it, where it falls to 0 for want of shorter waves.
/// Fitted spectra: C1D exp(± 1.96 SE of ln C1D).  Averages: C1D ± t SE between measurements, t Student's of one
/// less than their number in the bin, where there are two or more.
[[nodiscard]] std::optional<SurfaceCurve> C1D_of(const study::SurfaceResult& surface);

/// C_iso of the same spectrum. C1D is converted as the study says: by the inverse Abel integral, or by (11).
[[nodiscard]] std::optional<SurfaceCurve> C_iso_of(const study::SurfaceResult& surface,
                                                   roughness::Conversion conversion);

/// What a reader calls a method of SurfaceCurve.
[[nodiscard]] std::string method_in_words(const std::string& method);

}  // namespace setae::study_figures
