// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/fields/describe.hpp"
#include "setae/fields/option.hpp"
#include "setae/loops/lens_radius.hpp"

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

}  // namespace setae::answers

template <>
struct setae::fields::Described<setae::loops::Conic> {
    using T = loops::Conic;
    static constexpr std::array rows_of_apex{
        field<&T::apex_x>("x", "coordinate along x"),
        field<&T::apex_z>("z", "coordinate along z"),
        made<T>("unit", "unit of both coordinates", [](const T&) { return std::string_view("m"); }),
    };
    static constexpr Description apex{"", "apex of the conic", rows_of_apex};
    static constexpr std::array rows{
        part<T>("apex", "apex of the conic", apex),
        field<&T::probability>("probability_of_a_sphere",
                               "probability that a sphere shows a deviation at least as large by chance"),
        quantity<&T::radius>("radius_of_curvature", "R", "m", "radius of curvature R at the apex"),
        quantity<&T::conic_constant>("conic_constant", "k", "1", "conic constant; 0 for a sphere"),
        quantity<&T::departure>("departure_from_the_apex_sphere", "", "m",
                                "largest deviation from the sphere at the apex"),
        quantity<&T::rms_residual>("rms_residual", "rms", "m", "root mean square of the residuals")
            .as("rms_residual_of_lengths"),
    };
    static constexpr Description description{"", "conic through the points", rows};
};
static_assert(setae::fields::complete<setae::loops::Conic>);

template <>
struct setae::fields::Described<setae::answers::Lens> {
    using T = answers::Lens;
    static constexpr std::array rows_of_centre{
        made<T>("x", "coordinate along x", [](const T& of) { return of.circle.centre_x; }),
        made<T>("z", "coordinate along z", [](const T& of) { return of.circle.centre_y; }),
        made<T>("unit", "unit of both coordinates", [](const T&) { return std::string_view("m"); }),
    };
    static constexpr Description centre{"", "centre of the circle", rows_of_centre};
    static constexpr std::array rows_of_range{
        field<&T::first>("from", "first point"),
        field<&T::last>("to", "last point"),
        made<T>("unit", "unit of both ends", [](const T&) { return std::string_view("m"); }),
    };
    static constexpr Description range{"", "range of the fitted points", rows_of_range};
    static constexpr std::array rows{
        field<&T::file>("file", "name of the file as it was given"),
        field<&T::points>("n", "number of points in the file"),
        made<T>("radius_of_curvature", "R", "m", "radius of the circle through the points",
                [](const T& of) { return of.circle.radius; }),
        made<T>("rms_residual", "rms", "m", "root mean square distance of the points from the circle",
                [](const T& of) { return of.circle.rms_residual; })
            .as("rms_residual_of_lengths"),
        part<T>("centre", "centre of the circle", centre),
        part<T>("range", "range of the fitted points along x", range),
        field<&T::conic>("conic", "conic through the points; null where it cannot be determined").or_null(),
        made<T>("no_conic", "reason for which the conic cannot be determined",
                [](const T& of) { return of.conic ? std::nullopt : std::optional(of.no_conic); }),
        field<&T::alerts>("alerts", "warnings"),
        inner<&T::circle>(),
        inner<&T::no_conic>(),
    };
    static constexpr Description description{"", "shape of a lens", rows};
};
static_assert(setae::fields::complete<setae::answers::Lens>);

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
