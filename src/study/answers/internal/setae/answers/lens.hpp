// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/fields/option.hpp"
#include "setae/loops/lens_radius.hpp"
#include "setae/output/json.hpp"

namespace setae::answers {

/// Request of `setae jkr lens`: section of a lens.
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
    double first = 0.0, last = 0.0;  ///< range along x [m]
};

/// The lens from a table of two lengths, a profilometer's trace, or a picture of its silhouette.
/// @throws FormatError for a table without two lengths; as the readers and loops::fit_circle().
[[nodiscard]] Lens lens_of(const std::string& file, const LensRequest& request);

/// "file", "n", "radius_of_curvature", "rms_residual", "centre", "range", "conic" and "alerts".
[[nodiscard]] output::Json to_json(const Lens& lens);

}  // namespace setae::answers

template <>
struct setae::fields::Asked<setae::answers::LensRequest> {
    using R = answers::LensRequest;
    static constexpr std::array options{
        option<&R::x>("x", "column of positions along the lens").or_else("the first column of lengths"),
        option<&R::z>("z", "column of heights").or_else("the second column of lengths"),
        option<&R::pixel>("pixel", "size of a pixel in pictures that do not state it")
            .of(positive(dimension::length))
            .such_as("2.05 um"),
        option<&R::from>("from", "start of the range along the lens; points before are left out")
            .of(dimension::length)
            .such_as("-0.2 mm")
            .in_python("start"),
        option<&R::to>("to", "end of the range along the lens; points beyond are left out")
            .of(dimension::length)
            .such_as("0.2 mm")
            .in_python("stop"),
    };
};
