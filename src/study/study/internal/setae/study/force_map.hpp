// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "setae/formats/quantity_maps.hpp"
#include "setae/loops/force_curve_summary.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/study/open_loop.hpp"
#include "setae/tables/force_map.hpp"

namespace setae::study {

/// A curve of a map: its position and results, or the reason for which it has none.
struct MappedCurve {
    long number = 0;                            ///< as the file counts it
    double x = undefined, y = undefined;        ///< [m]; NaN where the file does not state it
    std::optional<std::array<Index, 2>> pixel;  ///< column from the left, row from the top, on the map's grid
    loops::Outcome<loops::ForceCurveSummary> summary;
};

/// All force curves of a file.
struct ForceMap {
    std::string file, format;
    std::optional<tables::MapGrid> grid;
    std::vector<MappedCurve> curves;  ///< in the order of their numbers
};

/// Fits every force curve of a file on the given threads; each is read, fitted and released. A damaged curve has its
/// reason and the others continue.
/// @throws FileError, FormatError as open_force_curves(); FormatError for a constant that neither the file nor
/// `constants` state; InvalidArgument for bodies and options that fit no tip; UndefinedDataError where no curve has a
/// result.
[[nodiscard]] ForceMap fit_force_map(const std::string& file, const tables::ForceCurveOptions& constants,
                                     const loops::LensAndCounterBody& bodies,
                                     const loops::ForceCurveFitOptions& options, parallel::Threads threads);

/// E*, E, W, pull-off force and energy loss on the map's grid, rows from the top, NaN where no curve gives them; of
/// several curves in a pixel the last is used.
/// @throws UndefinedDataError without a grid.
[[nodiscard]] std::vector<formats::QuantityMap> quantities_on_grid(const ForceMap& map);

/// One force curve of a file by its number, as open_loop() opens a file of one.
/// @throws as open_loop(); InvalidArgument for a number the file does not have.
[[nodiscard]] OpenedLoop open_force_curve(const std::string& file, long number,
                                          const tables::ForceCurveOptions& constants);

}  // namespace setae::study
