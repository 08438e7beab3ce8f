// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/core/quantity.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::spectra {

/// Kind of power spectral density; h̃ is the Fourier transform of heights over a length L or an area A.
enum class Density {
    C1D,    ///< |h̃(q)|²/L of line scans, two-sided and averaged over ±q [m³]; h_rms² = (1/π) ∫ C1D dq
    C_iso,  ///< radial average of |h̃(q)|²/A over the full circle [m⁴]; h_rms² = (1/2π) ∫ q C_iso dq
};

/// Interpolation between the nodes of a spectrum.
enum class Nodes {
    power_law,  ///< a power law from node to node: averages over bins, models
    modes,      ///< none: each node is a mode of one measurement with its cell, so sums satisfy Parseval's relation
};

/// A power spectral density, measured or modelled.
struct Spectrum {
    Array1D wavevector;  ///< q [1/m], increasing, > 0
    Array1D density;     ///< [m³] or [m⁴]; integrals skip nodes that are NaN (and 0, between power laws)
    Band band;           ///< [1/m] of reliable values; the outer power laws or cells continue to its ends
    Density kind = Density::C1D;
    Nodes nodes = Nodes::power_law;
    Array1D standard_error = {};  ///< of the density, in its unit; NaN, or empty, if unknown
    Array1D count = {};           ///< number of lines, modes or measurements averaged at each node; empty for models
    double waves_end = std::numeric_limits<double>::infinity();  ///< the surface has no shorter waves [1/m]
};

/// The spectrum of one measurement.
struct MeasuredSpectrum : Spectrum {
    double length = 0.0;             ///< L [m] of lines
    double pitch = 0.0;              ///< distance of the lines of a map [m]; 0 for one line
    Array1D independent_lines = {};  ///< n of each mode: C1D has the relative variance 1/n; at most the count
    std::string window;
    std::vector<Alert> alerts;
    topography::Metadata metadata;
};

}  // namespace setae::spectra
