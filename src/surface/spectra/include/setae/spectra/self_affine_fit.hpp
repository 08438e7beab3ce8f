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
    bool rolloff = true;        ///< look for a roll-off; false: the power law goes on to the lowest wavevector
    bool short_cutoff = false;  ///< look for the end of the surface's own spectrum; false: it lies beyond the data
    double level = 0.95;        ///< of the intervals
};

/// Values whose expectation a model gives.
struct FittedValues {
    Array1D wavevector;  ///< [1/m]
    Array1D values;      ///< [m³], > 0
    Array1D
        freedom;  ///< ν of each: gamma distributed about its expectation with relative variance 1/ν; 0 leaves it out
    /// Expectations [m³] at the wavevectors for a model whose q_s is finite.
    std::function<Array1D(const spectra::SelfAffine&)> expected;
};

enum class FitStatus {
    converged,
    not_converged,  ///< the best point found is reported
};

/// What the values say of a scale.
enum class ScaleStatus {
    found,    ///< both ends of its interval lie where the values can tell
    bounded,  ///< one end alone is known: the other is infinite or 0
    not_asked,
};

/// A self-affine surface fitted to spectra of lines.
///
///   C_iso(q) = C_0 max(1, q/q_r)^(−2−2H) for q <= q_s, 0 above;  A = C_0 q_r^(2+2H) its strength, which data without
///   roll-off know
///
/// The likelihood is that of gamma variates, Σ −ν (ln E + P/E); its curvature times max(1, χ²/dof) gives the standard
/// errors, and the intervals of wavelengths are where the profile of the likelihood has fallen by half the quantile of
/// χ² with one degree of freedom.
struct SelfAffineFit {
    spectra::SelfAffine model;  ///< as fitted; a scale not asked for lies 10³ beyond the wavevectors fitted
    Quantity hurst_exponent;    ///< H [1]
    Quantity plateau;           ///< C_0 [m⁴]; NaN where no roll-off was asked for
    Quantity amplitude;  ///< C_iso at the reference wavevector [m⁴], the geometric mean of the range; known best
    double reference_wavevector = 0.0;  ///< [1/m]
    Quantity rolloff_wavelength;        ///< λ_r = 2π/q_r [m]; NaN where not asked for
    Quantity shortest_wavelength;       ///< λ_s = 2π/q_s [m]; likewise
    ScaleStatus rolloff = ScaleStatus::not_asked;
    ScaleStatus short_cutoff = ScaleStatus::not_asked;
    std::vector<std::string> parameters;  ///< of the rows of covariance: "ln amplitude", "H", "ln rolloff_wavelength",
                                          ///< "ln shortest_wavelength" as far as fitted
    Eigen::MatrixXd covariance;
    Eigen::MatrixXd correlation;
    Band range;                            ///< from the lowest to the highest wavevector fitted [1/m]
    Array1D wavevector, values, expected;  ///< of all values fitted, in increasing order [1/m], [m³]
    Array1D residual;                      ///< signed root of each value's deviance: about normal where the model holds
    double chi_squared = 0.0;              ///< deviance Σ 2ν (r − 1 − ln r)/(1 + 1/6ν), r = P/E
    double degrees_of_freedom = 0.0;
    double probability = 1.0;  ///< of a larger χ² where the model holds
    int iterations = 0;
    FitStatus status = FitStatus::converged;
    /// NOT_CONVERGED, MODEL_MISSES, MODEL_MISSES_BEYOND, FIT_AT_BOUND, ROLLOFF_NOT_SEEN, CUTOFF_NOT_SEEN
    std::vector<Alert> alerts;
};

/// Of any values: Levenberg–Marquardt by Fisher scoring in ln amplitude, H, ln λ_r, ln λ_s.
/// @throws InvalidArgument for values, freedoms or wavevectors outside their domain, a range without at least two more
/// values than parameters, or a level outside (0, 1).
[[nodiscard]] SelfAffineFit fit_self_affine(std::span<const FittedValues> data,
                                            const SelfAffineFitOptions& options = {});

/// Of a spectrum combined from at least two measurements: ν of a bin is (C/SE)², (C/SE)² of a bin pooled with two on
/// either side; the expectation is the exact C1D of lines at the bins' centres. Windows and sampling bend C1D at both
/// ends of each measurement, which a combined spectrum no longer knows: combine what is undistorted().
/// @throws as above; UndefinedDataError where no bin has a standard error.
[[nodiscard]] SelfAffineFit fit_self_affine(const CombinedSpectrum& spectrum, const SelfAffineFitOptions& options = {});

/// Of one measurement's modes inside its reliable band, without a range up to a quarter of the highest wavevector: ν is
/// modes × the share of a mode that is its own × independent lines, 2.5/q apart (∫ρ² of neighbouring lines of a
/// self-affine surface). The expectation knows the Hann window's main lobe and, where the modes go up to the Nyquist
/// wavevector, its aliases. Without a range, the alert MODEL_MISSES_BEYOND says where reliable values outside the fit,
/// up to half of the highest wavevector, are on average more than 1.25 times the model or less than its 0.8, and more
/// than four standard errors apart from it.
[[nodiscard]] SelfAffineFit fit_self_affine(const MeasuredSpectrum& spectrum, const SelfAffineFitOptions& options = {});

/// Of several measurements: of their combined spectrum, each undistorted(), where all of its bins have a scatter
/// between measurements, alone or with two bins on either side; else of the modes of all of them at once, each as that
/// of one measurement. One measurement: that of one.
/// @throws as above; InvalidArgument for none.
[[nodiscard]] SelfAffineFit fit_self_affine(std::span<const MeasuredSpectrum> spectra,
                                            const SelfAffineFitOptions& options = {});

/// The spectrum with its band cut to where it is the surface's to a few per cent: from the eighth mode on (a window
/// mixes fewer) to a quarter of the highest wavevector (sampling folds back more). What is combined for a fit.
[[nodiscard]] MeasuredSpectrum undistorted(MeasuredSpectrum spectrum);

/// C1D of the model with its standard error, from the covariance: the columns of an export. Its band is the range of
/// the fit; what lies outside is extrapolated.
[[nodiscard]] Spectrum model_spectrum(const SelfAffineFit& fit, const ArrayView1D& wavevector);

}  // namespace setae::spectra
