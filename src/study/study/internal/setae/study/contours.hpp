// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/imaging/calibration.hpp"
#include "setae/imaging/contour_trace.hpp"
#include "setae/imaging/micrograph.hpp"
#include "setae/tables/tidy_table.hpp"
#include "setae/topography/traced_curve.hpp"

namespace setae::study {

/// Treatment of a contour that is no function of x.
enum class ContourShape {
    envelope,    ///< topography::Reentrance::envelope
    cut,         ///< topography::Reentrance::cut
    parametric,  ///< the curve itself, by its length
};

/// Conversion of a picture to profiles.
struct ContourOptions {
    imaging::MicrographOptions micrograph;
    imaging::CalibrationOptions calibration;
    std::optional<imaging::Calibration>
        shared_calibration;  ///< for pictures of the same magnification, in place of `calibration`
    imaging::TraceOptions trace;
    bool hide_annotations = true;  ///< scale bars, bars of data and text show no sample
    ContourShape shape = ContourShape::envelope;
    std::optional<double> foil_thickness;  ///< along the beam [m]
};

/// One segment as profile.
struct ContourProfile {
    topography::TracedCurve curve;
    topography::LevelledCurve levelled;  ///< by envelope for a parametric shape
    topography::ParametricStatistics statistics;
    double rms_height = 0.0;  ///< about the mean line, over the length [m], minus the contribution of noise: Rq
    double rms_error = 0.0;   ///< r.m.s. of standard errors of heights [m]
};

/// A picture with its traces.
struct TracedPicture {
    imaging::Micrograph micrograph;
    std::string digest;  ///< SHA-256 of the file
    imaging::Calibration calibration;
    std::vector<imaging::PictureRegion> hidden;  ///< given ones and annotations
    imaging::ContourTrace trace;
    std::vector<ContourProfile> profiles;  ///< profile of each segment
    /// warnings of reading, calibration, tracing, levelling; FOIL_THICKNESS, FOIL_PROJECTION
    std::vector<Alert> alerts;
};

/// Reads, calibrates, traces and levels.
///
///   Rq² = (1/L) ∫ h² dx − rms_error²
///
/// FOIL_PROJECTION: the contour is the silhouette of a foil; its effects are in docs/concepts/tem-projection.md. Waves
/// shorter than about ten times its thickness are too low; without a thickness there is the warning FOIL_THICKNESS.
/// @throws what read_micrograph, calibrate and trace_contour throw, with the file's name.
[[nodiscard]] TracedPicture trace_picture(const std::string& path, const ContourOptions& options = {});

/// The overlay of a picture (imaging::overlay_png).
[[nodiscard]] std::string overlay_of(const TracedPicture& picture, const ContourOptions& options);

/// Text of a segment's file: setae's open format of profiles (io/profile_file.hpp); with ContourShape::parametric CSV
/// with the columns s, x, y, standard_error [m], s along the curve.
[[nodiscard]] std::string profile_text(const TracedPicture& picture, std::size_t segment, ContourShape shape);

/// One row per segment: file, segment, pixel size, length, points, Rq, error, noise, re-entrant share, state, warnings.
[[nodiscard]] tables::TidyTable contour_table();
void add_rows(tables::TidyTable& table, const TracedPicture& picture);
/// A picture that gave nothing.
void add_failure(tables::TidyTable& table, const std::string& path, const std::string& error);

}  // namespace setae::study
