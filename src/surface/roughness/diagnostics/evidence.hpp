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

/// Rms heights of one pass side by side [m].
struct Form {
    double rms_map = 0.0, rms_level = 0.0;         ///< as measured; without tilt
    std::optional<double> rms_without_parabola;    ///< of enough points
    std::optional<topography::MapTrend> parabola;  ///< of the level heights, of enough points
};

/// What the tests look at: heights on a grid, points along the fast axis x in rows, scan lines in columns; a line has
/// one column. Beside the map itself it holds one more, which the tests change in place one after the other.
struct Evidence {
    std::string subject;
    SharedMap map;                  ///< as measured, NaN = undefined
    topography::HeightMap heights;  ///< without tilt and instrument; by clean() without scars and spikes, gaps filled
    std::optional<topography::MapTrend> tilt;                ///< what `heights` lack of a map
    Form form;                                               ///< by form_of()
    std::optional<spectra::MeasuredSpectrum> scan_spectrum;  ///< by clean(), of enough points
    std::optional<topography::Mask> scars;                   ///< by scar_points()
    std::optional<processing::Spikes> spikes;      ///< by clean(); nothing where there are none, or too few points
    std::vector<processing::NewHeight> at_spikes;  ///< level heights of the spikes, which `heights` lack
    bool level_is_clean = false;                   ///< by clean(), which found nothing to change
    std::optional<double> rms_slope_x;             ///< of the clean heights, where clean() came to know it [1]
    bool is_line = false;
    bool flat = false;  ///< all defined heights are equal; then `heights` are empty
    Index defined = 0;
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;  ///< of the defined heights [m]
};

/// The map must live as long as the evidence.
[[nodiscard]] Evidence evidence_of(const topography::HeightMap& map, parallel::Threads threads);
[[nodiscard]] Evidence evidence_of(const topography::LineScan& scan, parallel::Threads threads);

/// Of level heights.
[[nodiscard]] Form form_of(const Evidence& evidence, parallel::Threads threads);

/// Points of strokes along x that stand out of the lines beside, where there are several times as many as along y:
/// nothing where there are no more than a surface has by itself.
[[nodiscard]] std::optional<topography::Mask> scar_points(const topography::HeightMap& map, parallel::Threads threads);

/// Takes scars, then spikes out of the heights, fills what is undefined, and finds the spectrum of the rest.
void clean(Evidence& evidence, parallel::Threads threads);

/// Rms height of the clean heights [m].
[[nodiscard]] double clean_rms_height(const Evidence& evidence);

/// Root of the mean squared distance of the defined heights from their mean [m].
[[nodiscard]] double rms_height(const Array2D& heights);
/// The same of those that are not chosen.
[[nodiscard]] double rms_height_without(const Array2D& heights, const topography::Mask& chosen);

/// Root mean square of the forward differences along x over their step [1].
[[nodiscard]] double rms_slope_along_x(const Array2D& heights, double step);

/// A number of a finding.
[[nodiscard]] Quantity effect(std::string name, std::string symbol, double value, std::string unit,
                              double standard_error = undefined);
[[nodiscard]] Quantity effect_count(std::string name, Index count);

/// A length for a reader: "12.3 nm".
[[nodiscard]] std::string length_text(double length);

using Found = std::optional<Finding>;

// of the map as measured
[[nodiscard]] Found undefined_heights(const Evidence& evidence);
[[nodiscard]] Found constant_heights(const Evidence& evidence);

/// A digitiser's step [m] and how many neighbours along x have the same height.
struct Digitised {
    double step, plateau_share;
};

/// What the levels of the heights show: those of both ends, and the step they have in common.
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
/// The spikes are put back for a while.
[[nodiscard]] Found spikes(Evidence& evidence, parallel::Threads threads);
[[nodiscard]] Found pixel_noise(const Evidence& evidence, const DiagnosisOptions& options);
[[nodiscard]] Found tip_cutoff(const topography::Measurement& measurement, parallel::Threads threads);
[[nodiscard]] Found low_wavevector_gap(const Evidence& evidence, const DiagnosisOptions& options);
/// SCAN_DIRECTION, and ANISOTROPIC of the map without the offsets of its lines, which the heights lose.
[[nodiscard]] std::vector<Finding> directions(Evidence& evidence, const DiagnosisOptions& options);

}  // namespace setae::diagnostics
