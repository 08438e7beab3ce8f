// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/loops/loop.hpp"
#include "setae/simulation/data_set.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::simulation {

/// A name as part of a file name: characters other than letters, digits, '-' or '.' become '_'.
[[nodiscard]] std::string file_stem(const std::string& name);

/// Instruments' text exports: x [um] or [nm] and h [nm] in columns, a map as a matrix with Gwyddion's header.
[[nodiscard]] std::string scan_text(const topography::LineScan& scan);
[[nodiscard]] std::string map_text(const topography::HeightMap& map);
[[nodiscard]] std::string contour_text(const topography::Profile& contour);
[[nodiscard]] std::string loop_text(const loops::Loop& loop);

/// truth.json: true values, SI.
[[nodiscard]] std::string true_values_text(const Recipe& recipe, const std::vector<TrueSurfaceValues>& surfaces,
                                           const std::vector<KnownLoop>& loops);

/// A measurement file of a surface.
struct MeasurementFile {
    std::string file{};  ///< relative to the data set's folder
    std::string instrument;
    std::string tip_radius;                 ///< "5e-06 ± 2e-07 m", an input's name, or empty without tip
    std::string height_calibration{};       ///< "afm_height", "1 ± 0.02"; empty without one
    std::string lateral_calibration{};      ///< calibration of lengths
    double foil_thickness = 0.0;            ///< [m]; 0: a line
    std::vector<std::string> references{};  ///< scans of a smooth reference in the same session
};

/// study.toml: an analysis of the data set with only the inputs that an experiment has.
[[nodiscard]] std::string study_text(const Recipe& recipe,
                                     const std::vector<std::vector<MeasurementFile>>& measurements,
                                     const std::vector<KnownLoop>& loops);

}  // namespace setae::simulation
