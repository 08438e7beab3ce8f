// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/texture/measurement_view.hpp"

namespace setae::texture {

/// Elements of a profile, each a hill and the dale after it, found by crossings of the mean line.
///
/// A hill (dale) that is lower than the height threshold or shorter than the length threshold is joined to its
/// neighbours. Elements begin at the first crossing; parts before the first and after the last crossing are left out.
/// Source: ISO 21920-2:2021, 5; ISO 4287:1997, 3.2.7 and 4.3.
struct ProfileElements {
    double RSm = 0.0;   ///< mean length [m]; NaN without a whole element
    double RSmq = 0.0;  ///< its rms deviation [m]
    double Rc = 0.0;    ///< mean height, hill plus dale [m]
    double Rcq = 0.0;   ///< its rms deviation [m]
    Index elements = 0;
};

/// height, length: thresholds [m]; mean_line: [m]. Straight between the points.
/// @throws InvalidArgument for a map; UndefinedDataError for undefined heights.
[[nodiscard]] ProfileElements profile_elements(const MeasurementView& line, double height, double length,
                                               double mean_line);

/// Slopes of a line: uniform ones by the seven-point formula of the standard, polylines by segments.
struct ProfileSlopes {
    double Rdq = 0.0;    ///< rms [1]; NaN for fewer than seven points
    double Rda = 0.0;    ///< mean of the absolute value [1]
    double Rdt = 0.0;    ///< largest absolute value [1]
    double Rdr = 0.0;    ///< length of the straight segments between points over their length along x, minus 1 [1]
    double Rdq_2 = 0.0;  ///< rms by differences of neighbours, as in spectra [1]
};
/// @throws InvalidArgument for a map or a re-entrant profile.
/// Seven points: z' = (z₊₃ − 9 z₊₂ + 45 z₊₁ − 45 z₋₁ + 9 z₋₂ − z₋₃)/(60 Δx). Source: ISO 21920-2:2021, 4.4; ISO
/// 4287:1997, local slope.
[[nodiscard]] ProfileSlopes profile_slopes(const MeasurementView& line);

}  // namespace setae::texture
