// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "setae/diagnostics/diagnose.hpp"
#include "setae/processing/despike.hpp"
#include "setae/spectra/power_spectrum.hpp"
#include "setae/topography/mask.hpp"

namespace setae::diagnostics {

using SharedMap = std::shared_ptr<const topography::HeightMap>;

/// What the tests look at: heights on a grid, points along the fast axis x in rows, scan lines in columns; a line has
/// one column.
struct Evidence {
    std::string subject;
    SharedMap map;    ///< as measured, NaN = undefined
    SharedMap level;  ///< without its tilt
    SharedMap clean;  ///< without tilt, scars and spikes, undefined points filled; `level` itself where nothing changed
    double rms_map = 0.0, rms_level = 0.0;                   ///< rms_height() of both
    std::optional<spectra::MeasuredSpectrum> scan_spectrum;  ///< of `clean`, of enough points
    std::optional<topography::Mask>
        scars;  ///< points of strokes along x, where there are more than a surface has by itself
    std::optional<processing::Spikes> spikes;  ///< nothing where there are none, or too few points to look for them
    bool is_line = false;
    bool flat = false;  ///< all defined heights are equal
    Index defined = 0;
};

/// The map must live as long as the evidence.
/// @throws UndefinedDataError where no height is defined.
[[nodiscard]] Evidence evidence_of(const topography::HeightMap& map, parallel::Threads threads);
[[nodiscard]] Evidence evidence_of(const topography::LineScan& scan, parallel::Threads threads);

/// Points of strokes along x that stand out of the lines beside, where there are several times as many as along y.
[[nodiscard]] std::optional<topography::Mask> scar_points(const topography::HeightMap& map, parallel::Threads threads);

/// Root of the mean squared distance of the defined heights from their mean [m].
[[nodiscard]] double rms_height(const Array2D& heights);
/// Of two maps of one shape side by side, which takes as long as one.
[[nodiscard]] std::array<double, 2> rms_heights(const Array2D& first, const Array2D& second);

/// Root mean square of the forward differences along x over their step [1].
[[nodiscard]] double rms_slope_along_x(const Array2D& heights, double step);

/// A number of a finding.
[[nodiscard]] Quantity effect(std::string name, std::string symbol, double value, std::string unit,
                              double standard_error = undefined);
[[nodiscard]] Quantity effect_count(std::string name, Index count);

/// A length for a reader: "12.3 nm".
[[nodiscard]] std::string length_text(double length);

using Found = std::optional<Finding>;

[[nodiscard]] Found undefined_heights(const Evidence& evidence);
[[nodiscard]] Found large_tilt(const Evidence& evidence);
[[nodiscard]] Found curvature_left(const Evidence& evidence, parallel::Threads threads);
[[nodiscard]] Found quantised(const Evidence& evidence, parallel::Threads threads);
[[nodiscard]] std::vector<Finding> clipped(const Evidence& evidence, parallel::Threads threads);
[[nodiscard]] Found spikes(const Evidence& evidence, parallel::Threads threads);
[[nodiscard]] Found scars(const Evidence& evidence);
[[nodiscard]] Found pixel_noise(const Evidence& evidence, const DiagnosisOptions& options);
[[nodiscard]] Found tip_cutoff(const topography::Measurement& measurement, parallel::Threads threads);
[[nodiscard]] Found low_wavevector_gap(const Evidence& evidence, const DiagnosisOptions& options);
/// SCAN_DIRECTION, and ANISOTROPIC of the map without the offsets of its lines.
[[nodiscard]] std::vector<Finding> directions(const Evidence& evidence, const DiagnosisOptions& options);

}  // namespace setae::diagnostics
