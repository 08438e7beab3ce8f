// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/texture/functional_parameters.hpp"
#include "setae/texture/texture_parameter.hpp"

namespace setae::texture {

/// Filters before parameters: nesting indices of Gaussian filters [m]; absent = not applied.
struct Filters {
    std::optional<double> s_filter;  ///< removes shorter waves: S-filter, λs
    std::optional<double> l_filter;  ///< removes longer waves: L-filter, λc
};

struct ArealOptions {
    Filters filters;
    MaterialRatios ratios;
    Between between = Between::linear;  ///< of the functional parameters
    double threshold = 0.2;             ///< s of Sal and Str
    double material_height = 0.0;       ///< c of Smr(c), above the mean [m]
    double material_ratio = 0.5;        ///< p of Smc(p)
    std::vector<std::string> only;  ///< symbols of the table; only these parameters and those they need are computed;
                                    ///< empty: all
};

/// All parameters of ISO 25178-2:2021 of a map: height, spatial, hybrid, functional, volume, feature.
///
/// Only the mean of the map is removed: remove form first. Parameters without a value are NaN with a warning. Sq, Sa,
/// Ssk and Sku have standard errors from the autocorrelation of the map, valid for Gaussian heights. Filters are
/// Gaussian, fitted to a plane at edges.
/// @throws InvalidArgument for a line; UndefinedDataError for a map without a pixel of four defined corners.
[[nodiscard]] std::vector<TextureParameter> areal_parameters(const MeasurementView& measurement,
                                                             const ArealOptions& options = {},
                                                             parallel::Threads threads = {});

}  // namespace setae::texture
