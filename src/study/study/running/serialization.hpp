// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cereal/types/array.hpp>
#include <cereal/types/map.hpp>
#include <cereal/types/optional.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/variant.hpp>
#include <cereal/types/vector.hpp>

#include <optional>
#include <sstream>
#include <string>

#include "kept_reader.hpp"
#include "setae/study/study_result.hpp"

// Results as bytes, exactly, for the cache. Every function decomposes its type by a structured binding: a field added
// to a type gives a compile error here until it is stored, too.

namespace Eigen {

template <class Archive, class Scalar, int rows, int columns, int options>
void save(Archive& archive, const Array<Scalar, rows, columns, options>& a) {
    archive(a.rows(), a.cols());
    archive(cereal::binary_data(a.data(), static_cast<std::size_t>(a.size()) * sizeof(Scalar)));
}
template <class Archive, class Scalar, int rows, int columns, int options>
void load(Archive& archive, Array<Scalar, rows, columns, options>& a) {
    setae::study::load_array(archive, a);
}
template <class Archive>
void save(Archive& archive, const MatrixXd& m) {
    archive(m.rows(), m.cols());
    archive(cereal::binary_data(m.data(), static_cast<std::size_t>(m.size()) * sizeof(double)));
}
template <class Archive>
void load(Archive& archive, MatrixXd& m) {
    setae::study::load_array(archive, m);
}

template <class Archive>
void save(Archive& archive, const Matrix4d& m) {
    archive(cereal::binary_data(m.data(), static_cast<std::size_t>(m.size()) * sizeof(double)));
}
template <class Archive>
void load(Archive& archive, Matrix4d& m) {
    archive(cereal::binary_data(m.data(), static_cast<std::size_t>(m.size()) * sizeof(double)));
}

}  // namespace Eigen

// the fields of a type, all of them, in their order
#define SETAE_KEEP(Type, ...)                    \
    template <class Archive>                     \
    void serialize(Archive& archive, Type& of) { \
        auto& [__VA_ARGS__] = of;                \
        archive(__VA_ARGS__);                    \
    }

// for a type with a base, which structured bindings cannot decompose
#define SETAE_KEEP_WITH_BASE(Type, Base, ...)                 \
    template <class Archive>                                  \
    void serialize(Archive& archive, Type& of) {              \
        keep_with_base<Type, Base>(archive, of, __VA_ARGS__); \
    }

namespace setae {

/// The base and the members of a type; its size detects a missing one.
template <class Type, class Base, class Archive, class... Members>
void keep_with_base(Archive& archive, Base& base, Members&... members) {
    static_assert(sizeof(Type) == (sizeof(Base) + ... + ((sizeof(Members) + 7) / 8 * 8)), "a field is not kept");
    archive(base, members...);
}

SETAE_KEEP(Interval, lower, upper, level)
SETAE_KEEP(Estimate, value, standard_error, method, interval, degrees_of_freedom, seed, input)
SETAE_KEEP(Alert, code, subject, message, action)
SETAE_KEEP(Band, lower, upper)
SETAE_KEEP(Quantity, quantity, symbol, estimate, unit, band, n, source, alerts)

}  // namespace setae

namespace setae::processing {

SETAE_KEEP(StepRecord, step, numbers, alerts)

}  // namespace setae::processing

namespace setae::topography {

SETAE_KEEP(Instrument, name, type, tip_radius, tip_radius_standard_error, resolution)
SETAE_KEEP(Metadata, name, file, format, unit, acquisition_time, instrument, attributes, alerts)

}  // namespace setae::topography

namespace setae::spectra {

SETAE_KEEP(Spectrum, wavevector, density, band, kind, nodes, standard_error, count, waves_end)
SETAE_KEEP_WITH_BASE(MeasuredSpectrum, Spectrum, of.length, of.pitch, of.independent_lines, of.window, of.alerts,
                     of.metadata)
SETAE_KEEP(LogGrid, bins_per_decade)
SETAE_KEEP_WITH_BASE(CombinedSpectrum, Spectrum, of.instrument_count, of.grid, of.alerts)

}  // namespace setae::spectra

namespace setae::roughness {

SETAE_KEEP(RealSpaceParameters, rms_height, rms_height_of_lines, rms_slope_x, rms_slope_y, rms_slope, rms_curvature,
           mean_height, defined)
SETAE_KEEP(DirectionalSlope, angle, rms, rms_standard_error, skewness, skewness_standard_error, excess_kurtosis,
           excess_kurtosis_standard_error, blocks)
SETAE_KEEP(SlopeDistribution, directions, slope, density, gaussian_p_value, isotropy_ratio, isotropy_p_value, alerts)
SETAE_KEEP(TriangulatedArea, area_ratio, rms_slope, cells)
SETAE_KEEP(SlopeShape, share, square)
SETAE_KEEP(WeighedShape, shape, area)
SETAE_KEEP(SpectralParameters, rms_height, rms_slope, rms_curvature, elastic_energy_per_modulus, decade_C1D, area_shape)
SETAE_KEEP(BeyondData, end, up_to, exponent, rms_height, rms_slope, excess_area, elastic_energy_per_modulus)
SETAE_KEEP(ParameterSpread::Source, name, plus, minus)
SETAE_KEEP(ParameterSpread, replicas, seed, replica_method, replicas_are_draws, left_out, sources, single_bins)

}  // namespace setae::roughness

namespace setae::spectral_fit {

SETAE_KEEP(Agreement, instrument, decade, ratio, standard_error, chi_squared, groups, probability)
SETAE_KEEP(TipFactor, instrument, probe, size, wavevector, transfer)
SETAE_KEEP(SurfaceStretch, wavevector, ratio, direction)

/// The settings that decide a result: all but the threads.
template <class Archive>
void serialize(Archive& archive, LikelihoodOptions& of) {
    auto& [shortest_wavelength, bend, tip_factor, tip_band, min_transfer, rounds, tip_points, tip_length, seed,
           threads] = of;
    static_cast<void>(threads);
    archive(shortest_wavelength, bend, tip_factor, tip_band, min_transfer, rounds, tip_points, tip_length, seed);
}

}  // namespace setae::spectral_fit

namespace setae::tables {

SETAE_KEEP(ForceCurveOptions, spring_constant, sensitivity)

SETAE_KEEP(SpectrumUnits, quantity, wavevector, density, sides, kind)

}  // namespace setae::tables

namespace setae::contact {

SETAE_KEEP(RelaxationTerm, share, time)

}  // namespace setae::contact

namespace setae::contact::crack_speed {

SETAE_KEEP(Law, threshold, reference_speed, exponent)

}  // namespace setae::contact::crack_speed

namespace setae::loops {

template <class Archive, class T>
void serialize(Archive& archive, Outcome<T>& of) {
    archive(of.value, of.reason);
}

SETAE_KEEP(Loop, time, force, displacement, contact_radius)
SETAE_KEEP(LensAndCounterBody, radius, lens_poisson_ratio, counter_youngs_modulus, counter_poisson_ratio, lens_height,
           layer_thickness)
SETAE_KEEP(IndexRange, first, last)
SETAE_KEEP(TimeRange, first, last)
SETAE_KEEP(ContactEdits, jump_in, loading, hold, unloading, pull_off, cuts)
SETAE_KEEP(IgnoredSamples, range, reason)
SETAE_KEEP(SegmentEdits, baseline_before, baseline_after, contacts, ignored)
SETAE_KEEP(SegmentOptions, baseline_share, force_baseline, drift, feature_factor, turning_share, edits)
SETAE_KEEP(ContactPointChoice, mode, estimator, value)
SETAE_KEEP(AlertLimits, contact_radius_per_sphere_radius, contact_radius_per_thickness,
           contact_radius_per_unknown_height, tabor_parameter, relative_residual, contact_point_share,
           loop_sampling_share, relative_misfit, work_deviations, drift_share, noise_share, stiffness_ratio,
           pinned_modulus_ratio, frames_missing, contact_modulus_min, contact_modulus_max, work_of_adhesion_max,
           work_spread)
SETAE_KEEP(AnalysisOptions, segments, samples_dropped, sensitivity_dropped, effective_variance, displacement_drift_rate,
           leave_pinned_out, contact_radius_noise, machine_stiffness, machine_stiffness_standard_error, contact_point,
           true_area_ratio, retraction_points, retraction_modulus_free, interaction_range, relaxation, limits)
SETAE_KEEP(Baseline, range, force, force_standard_error, force_noise, force_noise_correlation, displacement_noise,
           displacement_noise_correlation, force_displacement_covariance)
SETAE_KEEP(Cycle, loading, unloading, contact, ends_in_pull_off)
SETAE_KEEP(ContactSegments, extent, jump_in, loading, hold, unloading, pull_off, cycles)
SETAE_KEEP(ForceStep, sample, size)
SETAE_KEEP(Segments, before, after, contacts, cycles, ignored, steps)
SETAE_KEEP(ForceDrift, degree, change, largest_in_contact, bend, irregular, stretches)
SETAE_KEEP(ForceZero, value, modes, drift)
SETAE_KEEP(RunsTest, runs, above, below, p_value)
SETAE_KEEP(JkrFit, method, converged, iterations, contact_modulus, youngs_modulus, work_of_adhesion, contact_point,
           unbounded_work, covariance, correlation, correlated_samples, n, residuals, residual_unit, depth_residuals,
           rms_residual, relative_residual, chi2_reduced, within_noise, runs)
SETAE_KEEP(PointwiseModulus, contact_modulus, youngs_modulus, contact_point, pointwise, rms_residual, relative_residual,
           n)
SETAE_KEEP(EnergyReleaseRate, contact_radius, energy_release_rate, standard_error, systematic, radius_measured)
SETAE_KEEP(FitRange, name, first, last, n, force_first, force_last)
SETAE_KEEP(RangeSensitivity, dropped, fit)
SETAE_KEEP(BranchAnalysis, range, radius_force, radius_force_effective_variance, linear_form, force_displacement, joint,
           pointwise, energy_release_rate, sensitivity, effective_variance_first)
SETAE_KEEP(PullOff, index, force, work_of_adhesion, last_force, work_of_adhesion_fixed_grips, machine_stiffness)
SETAE_KEEP(RetractionFit, work_of_adhesion, contact_modulus, modulus_free, first, last, n, rms_residual,
           radius_measured)
SETAE_KEEP(WorkAlongRetraction, at_pull_off, at_largest_contact, slope, smallest_radius, largest_radius, n,
           rms_residual, chi2_reduced, energy_loss, energy_loss_constant)
SETAE_KEEP(LoopErrorBudget, noise, drift, compliance, sampling, discretisation, total)
SETAE_KEEP(LoopEnergy, energy, without_drift, standard_error, opening, half_width)
SETAE_KEEP(LoopContext, largest_contact_radius, radius_measured, largest_contact_area, ideal_smooth_sphere_loss,
           tabor_parameter, applicable_model)
SETAE_KEEP(ContactPointEstimate, method, contact_point, fit)
SETAE_KEEP(ContactPoints, estimates, chosen, contact_point, spread, spread_share, chi2, degrees_of_freedom,
           work_by_contact_point, modulus_by_contact_point)
SETAE_KEEP(WorkEntry, range, energy, standard_error)
SETAE_KEEP(EnergyBudget, contact, loop, before_contact, jump_in, approach, retraction, jump_out, after_contact,
           recovered_share, ideal_fixed_grips, ideal_this_machine, machine_stiffness, largest_contact_area,
           true_area_ratio, loss_per_apparent_area, loss_per_true_area)
SETAE_KEEP(ComplianceEffect, stiffness, modulus_change, work_change, energy_change)
SETAE_KEEP(Change, first, last)
SETAE_KEEP(HoldGrowth, samples, duration, force, displacement, contact_radius, work_of_adhesion)
SETAE_KEEP(ContactAnalysis, loading, hold, pinned, unloading, pull_off, retraction, work_along_retraction, loop,
           context, contact_points, budget, compliance)
SETAE_KEEP(RecordFaults, saturated_high, saturated_low, frames, frames_missing, longest_gap, time_backwards)
SETAE_KEEP(Calibration, force, displacement, contact_radius)
SETAE_KEEP(BulkRelaxation, energy_loss, largest_force)
SETAE_KEEP(CrackSpeedFit, law, threshold, reference_speed, exponent, contact_modulus, covariance, converged, iterations,
           n, residuals, relative_residual, chi2_reduced, slow_speed, speed_ratio, modulus_deviation)
SETAE_KEEP(CycleAnalysis, cycle, loading, unloading, energy, energy_standard_error)
template <class Archive>
void serialize(Archive& archive, LoopAnalysis& of) {
    archive(static_cast<ContactAnalysis&>(of), of.corrected, of.force_zero, of.segments, of.further_contacts, of.cycles,
            of.steps_in_contact, of.faults, of.bulk, of.alerts);
}

}  // namespace setae::loops

namespace setae::study {

SETAE_KEEP(CameraInput, file, mapping, clock_offset, pixel_size, frame_rate, fringes)
SETAE_KEEP(LoopSource, file, mapping, camera, force_curve, columns)
SETAE_KEEP(LoopNumbers, contact_modulus, youngs_modulus, approach, pull_off, retraction, loss, contact_area)
SETAE_KEEP(MeasurementInput, file, channel, instrument, tip_radius, tip_shape, tip_half_angle, tip_file, foil_thickness,
           height_calibration, lateral_calibration, numerical_aperture, light_wavelength, resolution, trend, direction,
           references, unit, size, layout, keep_values, pipeline, steps, in_memory)
SETAE_KEEP(PublishedMoments, rms_height, rms_slope, rms_curvature, short_wavevector)
SETAE_KEEP(SurfaceInput, name, description, measurements, power_spectrum, spectrum_units, moments)
SETAE_KEEP(SurfaceAnalysisOptions, spectrum, longest_wavelength, shortest_wavelength, conversion, contours, window,
           weighting, tip_percentile, bootstrap_resamples, seed, likelihood, largest_map, cutoff_scan)
SETAE_KEEP(HeightPreview, positions, heights, map, size)
SETAE_KEEP(InstrumentInputs, tip_radius, foil_thickness, height_calibration, lateral_calibration)
SETAE_KEEP(MeasurementResult, file, name, error, channel, trend, processing, spectrum, real_space, arithmetic_height,
           bands_of_uncertain_tip, inputs, slopes, triangulated, slope_shape, waves_energy_per_modulus, preview, alerts)
SETAE_KEEP(SpectrumResult, curve, parameters, other_conversion, uncut_energy_per_modulus, spread)
SETAE_KEEP(FittedSpectrum, band, wavevector, C_iso, log_C_iso_standard_error, C1D, log_C1D_standard_error, agreement,
           tips, stretch, C1D_along, C1D_across, rounds, converged)
SETAE_KEEP(SurfaceResult, name, error, reconstructed, measurements, combined, method, average, likelihood, fitted,
           likelihood_error, slope_shape, beyond_data, longer_waves, alerts)

/// The bytes of a value: equal values, equal bytes.
template <class T>
[[nodiscard]] std::string bytes_of(const T& value) {
    std::ostringstream stream(std::ios::binary);
    cereal::BinaryOutputArchive archive(stream);
    archive(value);
    return std::move(stream).str();
}

/// The value of bytes_of() a value of the same type, verified by a store's digest; empty where the bytes are not
/// exactly that.
template <class T>
[[nodiscard]] std::optional<T> value_of(const std::string& bytes) {
    T value{};
    try {
        KeptReader archive(bytes);
        archive(value);
        if (!archive.at_end()) return std::nullopt;
    } catch (const std::exception&) {
        return std::nullopt;
    }
    return value;
}

}  // namespace setae::study

#undef SETAE_KEEP
