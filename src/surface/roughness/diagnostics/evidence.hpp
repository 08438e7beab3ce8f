// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "setae/diagnostics/diagnose.hpp"
#include "setae/processing/despike.hpp"
#include "setae/spectra/power_spectrum.hpp"
#include "setae/topography/detrend.hpp"
#include "setae/topography/mask.hpp"

namespace setae::diagnostics {

using SharedMap = std::shared_ptr<const topography::HeightMap>;

/// Rms heights from one pass [m].
struct Form {
    double rms_map = 0.0, rms_level = 0.0;         ///< as measured; without tilt
    std::optional<double> rms_without_parabola;    ///< with enough points
    std::optional<topography::MapTrend> parabola;  ///< of the level heights, with enough points
};

/// Data of the tests: heights on a grid, points along the fast axis x in rows, scan lines in columns; a line has one
/// column. In addition to the map it contains one more map, which the tests change in place one after the other.
struct Evidence {
    std::string subject;
    SharedMap map;                  ///< as measured, NaN = undefined
    topography::HeightMap heights;  ///< without tilt and instrument; after clean() without scars and spikes, with gaps
                                    ///< filled
    std::optional<topography::MapTrend> tilt;                ///< trend removed from `heights`
    Form form;                                               ///< set by form_of()
    std::optional<spectra::MeasuredSpectrum> scan_spectrum;  ///< set by clean(), with enough points
    std::optional<topography::Mask> scars;                   ///< set by scar_points()
    std::optional<processing::Spikes> spikes;      ///< set by clean(); empty if there are none, or too few points
    std::vector<processing::NewHeight> at_spikes;  ///< level heights of the spikes, removed from `heights`
    bool level_is_clean = false;                   ///< set by clean() if nothing was changed
    std::optional<double> rms_slope_x;             ///< of the clean heights, if clean() computed it [1]
    bool is_line = false;
    bool flat = false;  ///< all defined heights are equal; then `heights` are empty
    Index defined = 0;
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;  ///< of the defined heights [m]
};

/// The map must outlive the evidence.
[[nodiscard]] Evidence evidence_of(const topography::HeightMap& map, parallel::Threads threads);
[[nodiscard]] Evidence evidence_of(const topography::LineScan& scan, parallel::Threads threads);

/// Rms heights of level heights.
[[nodiscard]] Form form_of(const Evidence& evidence, parallel::Threads threads);

/// Points of strokes along x that differ from the adjacent lines, if there are several times as many as along y; empty
/// if their number is usual for a surface.
[[nodiscard]] std::optional<topography::Mask> scar_points(const topography::HeightMap& map, parallel::Threads threads);

/// Removes scars and spikes from the heights, fills undefined points, and computes the spectrum of the result.
void clean(Evidence& evidence, parallel::Threads threads);

/// Rms height of the clean heights [m].
[[nodiscard]] double clean_rms_height(const Evidence& evidence);

/// Root of the mean squared distance of the defined heights from their mean [m].
[[nodiscard]] double rms_height(const Array2D& heights);
/// Rms height of the points that are not selected.
[[nodiscard]] double rms_height_without(const Array2D& heights, const topography::Mask& chosen);

/// Root mean square of the forward differences along x over their step [1].
[[nodiscard]] double rms_slope_along_x(const Array2D& heights, double step);

/// A number of a reported problem.
[[nodiscard]] Quantity effect(std::string name, std::string symbol, double value, std::string unit,
                              double standard_error = undefined);
[[nodiscard]] Quantity effect_count(std::string name, Index count);

/// A length for a reader: "12.3 nm".
[[nodiscard]] std::string length_text(double length);

using Found = std::optional<Finding>;

// of the map as measured
[[nodiscard]] Found undefined_heights(const Evidence& evidence);
[[nodiscard]] Found constant_heights(const Evidence& evidence);

/// Step of a digitiser [m] and the number of neighbours along x with equal height.
struct Digitised {
    double step, plateau_share;
};

/// Levels of the heights: those of both ends, and their common step.
struct Levels {
    std::vector<Finding> clipped;
    std::optional<Digitised> digitised;
};
[[nodiscard]] Levels levels_of(const Evidence& evidence, parallel::Threads threads);

// of level heights
[[nodiscard]] Found quantised(const Evidence& evidence, const Digitised& digitised);
[[nodiscard]] Found large_tilt(const Evidence& evidence);
[[nodiscard]] Found curvature_left(const Evidence& evidence);
[[nodiscard]] Found scars(const Evidence& evidence);

// of clean heights
/// The spikes are temporarily restored.
[[nodiscard]] Found spikes(Evidence& evidence, parallel::Threads threads);
[[nodiscard]] Found pixel_noise(const Evidence& evidence, const DiagnosisOptions& options);
[[nodiscard]] Found tip_cutoff(const topography::Measurement& measurement, parallel::Threads threads);
[[nodiscard]] Found low_wavevector_gap(const Evidence& evidence, const DiagnosisOptions& options);
/// SCAN_DIRECTION, and ANISOTROPIC for the map without the offsets of its lines, which are removed from the heights.
[[nodiscard]] std::vector<Finding> directions(Evidence& evidence, const DiagnosisOptions& options);

}  // namespace setae::diagnostics
