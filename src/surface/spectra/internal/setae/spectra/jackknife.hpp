// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/spectra/combination.hpp"

namespace setae::spectra {

/// Combined spectra with one measurement left out in turn, by stratum.
struct JackknifeSpectra {
    Array1D wavevector;        ///< as CombinedSpectrum's [1/m]
    std::vector<Array2D> C1D;  ///< of each stratum: (measurement left out, bin) [m³], no gaps
};

/// Leaves out each measurement that has data, once for every time it takes part.
///
/// A stratum is an instrument. Measurements alone with their instrument form one stratum together; one that would be
/// alone even there joins the instrument with the most measurements, so that none counts as exactly known.
/// A single measurement has no stratum.
/// Bins that only the measurement left out covers are filled as bootstrap() does.
/// multiplicity: of each measurement, such as a row of BootstrapSpectra::drawn; empty for all of them once.
/// @throws InvalidArgument where the multiplicity is of another size than the measurements.
/// Source: Efron, Tibshirani, An Introduction to the Bootstrap (1993), ch. 11.
[[nodiscard]] JackknifeSpectra jackknife(const BinnedSpectra& spectra, Weighting weighting = Weighting::equal,
                                         const Multiplicity& multiplicity = {});

/// Combined spectra in which one bin that a single measurement covers is moved by its own deviation.
struct MovedBins {
    Array1D wavevector;   ///< as CombinedSpectrum's [1/m]
    Array2D plus, minus;  ///< (bin that one measurement covers, bin) [m³]
};

/// What the scatter of modes does to bins of a single measurement, of which the jackknife sees nothing: it fills them
/// in proportion to their neighbours.
///
///   C exp(±σ_b),  σ_b² = ψ'(1/v_b),  v_b the bin's relative_variance
///
/// The bins are independent of each other. No rows where every bin has two measurements. What places of the surface
/// have apart from each other there, one measurement cannot tell.
[[nodiscard]] MovedBins moved_single_bins(const BinnedSpectra& spectra, Weighting weighting = Weighting::equal);

}  // namespace setae::spectra
