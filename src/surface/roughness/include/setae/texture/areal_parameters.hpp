// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/texture/functional_parameters.hpp"
#include "setae/texture/texture_parameter.hpp"

namespace setae::texture {

/// Filters in front of parameters: nesting indices of Gaussian filters [m]; absent = not applied.
struct Filters {
    std::optional<double> s_filter;  ///< takes waves shorter than this out: S-filter, λs
    std::optional<double> l_filter;  ///< takes waves longer than this out: L-filter, λc
};

struct ArealOptions {
    Filters filters;
    MaterialRatios ratios;
    Between between = Between::linear;  ///< of the functional parameters
    double threshold = 0.2;             ///< s of Sal and Str
    double material_height = 0.0;       ///< c of Smr(c), over the mean [m]
    double material_ratio = 0.5;        ///< p of Smc(p)
    std::vector<std::string> only;  ///< symbols of the table; what no other parameter needs is not computed; empty: all
};

/// All parameters of ISO 25178-2:2021 of a map: height, spatial, hybrid, functional, volume, feature.
///
/// The map is taken as it is, about its mean: remove form first. Parameters without a value are NaN with an alert. Sq,
/// Sa, Ssk and Sku have standard errors from the map's own autocorrelation, which hold for Gaussian heights. Filters
/// are Gaussian, fitted to a plane at edges.
/// @throws InvalidArgument for a line; UndefinedDataError for a map without a pixel of four defined corners.
[[nodiscard]] std::vector<TextureParameter> areal_parameters(const MeasurementView& measurement,
                                                             const ArealOptions& options = {},
                                                             parallel::Threads threads = {});

}  // namespace setae::texture
