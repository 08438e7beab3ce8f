// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/core/quantity.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"
#include "setae/topography/tiled_map.hpp"

namespace setae::topography {

/// A value that may mark missing heights: many heights have exactly this value, or it is far from all others.
struct NoDataValue {
    double value = 0.0;      ///< [m]
    Index count = 0;         ///< number of heights with this value
    bool no_height = false;  ///< the evidence is overwhelming; otherwise the value is only suspected
};

/// Information that helps to recognise the markers of a file.
struct NoDataHints {
    double unit = 1.0;               ///< metres per number of the file
    std::vector<double> codes = {};  ///< [m]: extremes of the number type of the file
};

/// The values that mark missing heights, and the basis of the decision.
struct NoDataReport {
    std::vector<NoDataValue> values;     ///< in increasing order
    Index defined = 0;                   ///< number of finite heights, including those values
    double least = 0.0, greatest = 0.0;  ///< of the heights with none of those values [m]

    [[nodiscard]] bool any_undefined() const;
};

/// Looks for values that mark missing heights, such as −9999, 0 or 1e30.
///
/// m, s, r: median, half the range of the central 68 % and largest distance from m of the heights without the value v;
/// d = |v − m|; k: heights that have v exactly; b: heights on the side of v beyond the midpoint, m + (v − m)/2. v is
/// dominant if its k is ten times that of all but four other values. v is isolated if no other height is nearer to it
/// than d/4 (saturated peaks and clipped valleys have near heights), and it is dominant or d >= 8 s and b <= k/20. Its
/// runs along scan lines are irregular if six or more of their lengths, or of the gaps between them, scatter by half
/// their mean or more, or if six or more are single points or pairs and its share, k over all heights, is 5 % or less.
///
/// v is no height if one of these conditions is true:
///   d >= 1000 r;
///   v is isolated and a usual mark (999 and other numbers of nines, ±2^15, 2^16 − 1, ±2^31 and so on, powers of ten
///   from 1e6, numbers from 1e20, the extremes in `hints`), k >= 2 or d >= 20 r;
///   v is isolated, its runs are irregular, k >= 5 and its share is half or less;
///   v is dominant within the range of the others, its runs are irregular, its share is half or less, k >= 10, 90 % of
///   the steps into and out of runs exceed 8 times the usual step between neighbours, and the heights next to the runs
///   scatter by 5 such steps or more.
/// v is only suspected if it is isolated and k >= 3, if d >= 20 r (100 r for a single height), or if it is dominant
/// within the range of the others and the heights next to its runs are s/2 or more away, or there are none next to
/// them. Nothing is found if the others have fewer than 8 different values: pictures of two levels, noiseless gratings.
///
/// Cost: one pass over the heights and a sample of 2^14 of them; further passes only for candidates. The result is the
/// same for any number of threads.
[[nodiscard]] NoDataReport find_no_data(const Measurement& measurement, const NoDataHints& hints = {},
                                        parallel::Threads threads = {});
/// Search in a map in bands of scan lines.
[[nodiscard]] NoDataReport find_no_data(const TiledMap& map, const NoDataHints& hints = {});

/// Sets heights undefined that have a value with overwhelming evidence.
void undefine(Measurement& measurement, const NoDataReport& report);
void undefine(Array2D& heights, const NoDataReport& report);

/// The warnings: NO_DATA for values taken as undefined, NO_DATA_SUSPECTED for values that are kept. Values are stated
/// in `unit`, the unit of heights in the file.
[[nodiscard]] std::vector<Alert> alerts_of(const NoDataReport& report, const std::string& subject,
                                           const std::string& unit);

}  // namespace setae::topography
