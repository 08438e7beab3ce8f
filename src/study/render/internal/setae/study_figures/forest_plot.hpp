// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/figures/figure.hpp"
#include "setae/statistics/mixed_model.hpp"

namespace setae::study_figures {

struct ForestPlotOptions {
    std::string quantity = "value";  ///< quantity of the axis, typeset as figures::Axis::quantity
    /// unit of the axis, in the notation of setae; empty: that of the data with a prefix for the largest value
    std::string unit;
    double factor = 1.0;  ///< where the unit is given: values are multiplied by it
    double width_mm = 120.0;
    double interval_level = 0.95;  ///< level of the rows' error bars
};

/// Every replicate with its error bar, grouped by surface and outermost group, above the mean of its surface.
///
/// Rows are in the order of the surfaces, their groups and the data; excluded ones hollow, with the reason next to
/// them. Bars of rows: normal interval of their own standard error, none where it is unknown.  Means: diamonds with
/// their interval, the thin bar is the prediction interval; a hollow diamond is the mean with the excluded rows.
/// Height: 4.2 mm per line, within 40 … 500 mm. model: of these data.
/// @throws InvalidArgument where the model is not that of the data.
[[nodiscard]] figures::Figure forest_plot(const statistics::ReplicateData& data, const statistics::MixedModel& model,
                                          const ForestPlotOptions& options = {});

}  // namespace setae::study_figures
