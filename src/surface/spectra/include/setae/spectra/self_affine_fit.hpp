// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "setae/core/quantity.hpp"
#include "setae/spectra/combination.hpp"
#include "setae/spectra/power_spectrum.hpp"
#include "setae/spectra/self_affine.hpp"

namespace setae::spectra {

struct SelfAffineFitOptions {
    std::optional<Band> range;  ///< wavevectors fitted [1/m]; absent: all
    bool rolloff = true;        ///< fit a roll-off; false: the power law continues to the lowest wavevector
    bool short_cutoff = false;  ///< fit the short-wave end of the spectrum of the surface; false: it is beyond the data
    double level = 0.95;        ///< of the intervals
};

/// Values and their expectation for a model.
struct FittedValues {
    Array1D wavevector;  ///< [1/m]
    Array1D values;      ///< [m³], > 0
    Array1D freedom;  ///< ν of each: gamma distributed about its expectation with relative variance 1/ν; 0 excludes the
                      ///< value
    /// Expectations [m³] at the wavevectors for a model whose q_s is finite.
    std::function<Array1D(const spectra::SelfAffine&)> expected;
};

enum class FitStatus {
    converged,
    not_converged,  ///< the best point found is reported
};

/// Result of the fit for a scale.
enum class ScaleStatus {
    found,    ///< both ends of its interval are within the range covered by the values
    bounded,  ///< only one end is known: the other is infinite or 0
    not_asked,
};

/// A self-affine surface fitted to spectra of lines.
///
///   C_iso(q) = C_0 max(1, q/q_r)^(−2−2H) for q <= q_s, 0 above; A = C_0 q_r^(2+2H) the amplitude, which data without
///   roll-off determine
///
/// The likelihood is that of gamma variates, Σ −ν (ln E + P/E); its curvature times max(1, χ²/dof) gives the standard
/// errors, and the intervals of wavelengths end where the profile likelihood has decreased by half the quantile of χ²
/// with one degree of freedom.
struct SelfAffineFit {
    spectra::SelfAffine model;  ///< as fitted; a scale that was not fitted is 10³ beyond the fitted wavevectors
    Quantity hurst_exponent;    ///< H [1]
    Quantity plateau;           ///< C_0 [m⁴]; NaN without roll-off in the fit
    Quantity amplitude;         ///< C_iso at the reference wavevector [m⁴], the geometric mean of the range; the best
                                ///< determined parameter
    double reference_wavevector = 0.0;  ///< [1/m]
    Quantity rolloff_wavelength;        ///< λ_r = 2π/q_r [m]; NaN if not fitted
    Quantity shortest_wavelength;       ///< λ_s = 2π/q_s [m]; NaN if not fitted
    ScaleStatus rolloff = ScaleStatus::not_asked;
    ScaleStatus short_cutoff = ScaleStatus::not_asked;
    std::vector<std::string> parameters;  ///< names of the rows of covariance: "ln amplitude", "H", "ln
                                          ///< rolloff_wavelength", "ln shortest_wavelength" if fitted
    Eigen::MatrixXd covariance;
    Eigen::MatrixXd correlation;
    Band range;                            ///< from the lowest to the highest wavevector fitted [1/m]
    Array1D wavevector, values, expected;  ///< of all values fitted, in increasing order [1/m], [m³]
    Array1D residual;                      ///< signed root of the deviance of each value: about normal if the model is
                                           ///< correct
    double chi_squared = 0.0;              ///< deviance Σ 2ν (r − 1 − ln r)/(1 + 1/6ν), r = P/E
    double degrees_of_freedom = 0.0;
    double probability = 1.0;  ///< of a larger χ² if the model is correct
    int iterations = 0;
    FitStatus status = FitStatus::converged;
    /// NOT_CONVERGED, MODEL_MISSES, MODEL_MISSES_BEYOND, FIT_AT_BOUND, ROLLOFF_NOT_SEEN, CUTOFF_NOT_SEEN
    std::vector<Alert> alerts;
};

/// Fit of any values: Levenberg–Marquardt by Fisher scoring in ln amplitude, H, ln λ_r, ln λ_s.
/// @throws InvalidArgument for values, freedoms or wavevectors outside their domain, a range without at least two more
/// values than parameters, or a level outside (0, 1).
[[nodiscard]] SelfAffineFit fit_self_affine(std::span<const FittedValues> data,
                                            const SelfAffineFitOptions& options = {});

/// Fit of a spectrum combined from at least two measurements: ν of a bin is (C/SE)², (C/SE)² of a bin pooled with two
/// on either side; the expectation is the exact C1D of lines at the centres of the bins. Windows and sampling distort
/// C1D at both ends of each measurement, which a combined spectrum does not record: combine undistorted() spectra.
/// @throws as above; UndefinedDataError if no bin has a standard error.
[[nodiscard]] SelfAffineFit fit_self_affine(const CombinedSpectrum& spectrum, const SelfAffineFitOptions& options = {});

/// Fit of the modes of one measurement inside its reliable band; without a range up to a quarter of the highest
/// wavevector. ν is modes × independent share of a mode × independent lines, 2.5/q apart (∫ρ² of neighbouring lines of
/// a self-affine surface). The expectation includes the main lobe of the Hann window and, for modes up to the Nyquist
/// wavevector, aliases. Without a range, the warning MODEL_MISSES_BEYOND states where reliable values outside the fit,
/// up to half of the highest wavevector, are on average more than 1.25 times or less than 0.8 times the model, and
/// differ from it by more than four standard errors.
[[nodiscard]] SelfAffineFit fit_self_affine(const MeasuredSpectrum& spectrum, const SelfAffineFitOptions& options = {});

/// Fit of several measurements: of their combined spectrum, each undistorted(), if all of its bins have a scatter
/// between measurements, alone or with two bins on either side; otherwise of the modes of all measurements
/// simultaneously, each treated as one measurement. A single measurement is fitted as such.
/// @throws as above; InvalidArgument for an empty list.
[[nodiscard]] SelfAffineFit fit_self_affine(std::span<const MeasuredSpectrum> spectra,
                                            const SelfAffineFitOptions& options = {});

/// The spectrum with its band restricted to the range in which it is that of the surface to a few per cent: from the
/// eighth mode on (a window mixes the first modes) to a quarter of the highest wavevector (aliasing). Input of the
/// combination for a fit.
[[nodiscard]] MeasuredSpectrum undistorted(MeasuredSpectrum spectrum);

/// C1D of the model with its standard error, from the covariance: the columns of an export. Its band is the range of
/// the fit; values outside are extrapolated.
[[nodiscard]] Spectrum model_spectrum(const SelfAffineFit& fit, const ArrayView1D& wavevector);

}  // namespace setae::spectra
