// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/spectra/combination.hpp"

namespace setae::spectra {

/// Combined spectra without one measurement in turn, by stratum.
struct JackknifeSpectra {
    Array1D wavevector;        ///< as in CombinedSpectrum [1/m]
    std::vector<Array2D> C1D;  ///< of each stratum: (measurement left out, bin) [m³], no gaps
};

/// Leaves out each measurement with data, once per multiplicity.
///
/// A stratum is an instrument. Single measurements of an instrument form one common stratum; if this has only one
/// member, it joins the instrument with the most measurements, so no measurement counts as exact. A single measurement
/// has no stratum. Bins covered only by the omitted measurement are filled as in bootstrap().
/// multiplicity: of each measurement, such as a row of BootstrapSpectra::drawn; empty for all of them once.
/// @throws InvalidArgument if the sizes of multiplicity and measurements differ.
/// Source: Efron, Tibshirani, An Introduction to the Bootstrap (1993), ch. 11.
[[nodiscard]] JackknifeSpectra jackknife(const BinnedSpectra& spectra, Weighting weighting = Weighting::equal,
                                         const Multiplicity& multiplicity = {});

/// Combined spectra in which one bin with a single measurement is changed by its deviation.
struct MovedBins {
    Array1D wavevector;   ///< as in CombinedSpectrum [1/m]
    Array2D plus, minus;  ///< (bin with a single measurement, bin) [m³]
};

/// Effect of the scatter of modes on bins with a single measurement, which the jackknife does not include: it fills
/// them in proportion to their neighbours.
///
///   C exp(±σ_b),  σ_b² = ψ'(1/v_b),  v_b the relative_variance of the bin
///
/// The bins are independent of each other. No rows if every bin has two measurements. One measurement cannot show the
/// scatter between places of the surface.
[[nodiscard]] MovedBins moved_single_bins(const BinnedSpectra& spectra, Weighting weighting = Weighting::equal);

}  // namespace setae::spectra
