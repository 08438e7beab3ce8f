// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/imaging/lens_outline.hpp"

#include <utility>

#include <fmt/format.h>

#include "files/picture.hpp"
#include "setae/bytes/source.hpp"
#include "setae/core/errors.hpp"
#include "setae/imaging/contour_trace.hpp"
#include "setae/imaging/micrograph.hpp"

namespace setae::imaging {

bool is_picture(const std::string& path) {
    constexpr std::size_t longest_signature = 32;
    return picture_kind(bytes::file_source(path).head(longest_signature)) != PictureKind::none;
}

LensOutline lens_outline(const std::string& picture, std::optional<double> pixel_size) {
    const auto micrograph = read_micrograph(picture);
    if (!pixel_size && micrograph.pixel_size) pixel_size = micrograph.pixel_size->x;
    if (!pixel_size)
        throw UndefinedDataError(fmt::format(
            "{}: the file states no pixel size; give `pixel`, such as \"2.0 um\" (setae jkr camera measures "
            "it)",
            picture));
    const auto trace = trace_contour(micrograph.pixels, {.smoothing_length = 0.0});
    if (trace.segments.empty())
        throw UndefinedDataError(picture + ": no edge of a lens is found in the picture; crop the picture to the lens");
    const auto& outline = trace.segments.front();
    const auto bottom = static_cast<double>(micrograph.pixels.rows() - 1);
    auto alerts = trace.alerts;
    // the side of the lens is irrelevant
    std::erase_if(alerts, [](const Alert& alert) { return alert.code == "VACUUM_ASSUMED"; });
    return {.x = *pixel_size * outline.x,
            .z = *pixel_size * (bottom - outline.y),
            .pixel_size = *pixel_size,
            .edge_width = *pixel_size * outline.edge_width,
            .alerts = std::move(alerts)};
}

}  // namespace setae::imaging
