// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/loops/lens_radius.hpp"
#include "setae/output/json.hpp"

namespace setae::answers {

/// What `setae jkr lens` is told of a lens's section: columns of lengths, empty for the first two; the range of points
/// along x; the size of a pixel of pictures that do not state it.
struct LensRequest {
    std::string x, z, from, to, pixel;
};

/// A lens by its section.
struct Lens {
    std::string file;
    loops::Circle circle;
    std::optional<loops::Conic> conic;
    std::string no_conic;  ///< why
    std::vector<Alert> alerts;
    Index points = 0;
    double first = 0.0, last = 0.0;  ///< of the range along x [m]
};

/// Of a table of two lengths, a profilometer's trace, or a picture of the lens's side.
/// @throws FormatError for a table without two lengths; as the readers and loops::fit_circle().
[[nodiscard]] Lens lens_of(const std::string& file, const LensRequest& request);

/// "file", "n", "radius_of_curvature", "rms_residual", "centre", "range", "conic" and "alerts".
[[nodiscard]] output::Json to_json(const Lens& lens);

}  // namespace setae::answers
