// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_arguments.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"

namespace setae::processing {
namespace {

struct Extent {
    double pixel_size;  ///< the larger one
    double size;        ///< the smaller one
};

Extent extent_of(const topography::Measurement& measurement) {
    if (const auto* map = std::get_if<topography::HeightMap>(&measurement))
        return {std::max(map->pixel_size()[0], map->pixel_size()[1]), std::min(map->size[0], map->size[1])};
    const auto& scan = std::get<topography::LineScan>(measurement);
    return {scan.pixel_size(), scan.size};
}

}  // namespace

void require_cutoff(double cutoff, std::string_view filter, const topography::Metadata& metadata) {
    if (!(cutoff > 0.0) || !std::isfinite(cutoff))
        throw InvalidArgument(fmt::format("{}: {} with a cutoff of {} m; expected a positive wavelength",
                                          topography::label(metadata), filter, cutoff));
}

void refuse_profile(std::string_view step, const topography::Profile& profile) {
    throw InvalidArgument(
        fmt::format("{}: {} needs equally spaced points, and this is a polyline of {} points; resample it first "
                    "(step resample)",
                    topography::label(profile.metadata), step, profile.positions.size()));
}

StepRecord filter_record(std::string_view step, double cutoff, const topography::Measurement& measurement) {
    const topography::Metadata& metadata = topography::metadata(measurement);
    const auto [pixel_size, size] = extent_of(measurement);
    StepRecord record{.step = std::string(step)};
    record.numbers.push_back({.quantity = "cutoff_wavelength",
                              .symbol = "λc",
                              .estimate = {.value = cutoff, .standard_error = 0.0},
                              .unit = "m"});
    if (cutoff < 3.0 * pixel_size)
        record.alerts.push_back(
            {"FILTER_CUTOFF", topography::label(metadata),
             fmt::format(
                 "the cutoff, {}, is {:.2g} pixels long: the filter removes little, and its transmission is not "
                 "that of the standard",
                 format_value(cutoff, "m"), cutoff / pixel_size),
             "choose a cutoff of at least 5 pixels"});
    if (cutoff > size)
        record.alerts.push_back(
            {"FILTER_CUTOFF", topography::label(metadata),
             fmt::format("the cutoff, {}, is longer than the data, {}: the filter reaches beyond an end of the data at "
                         "every point",
                         format_value(cutoff, "m"), format_value(size, "m")),
             "choose a shorter cutoff, or subtract a polynomial instead"});
    return record;
}

}  // namespace setae::processing
