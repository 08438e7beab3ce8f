// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/core/units.hpp"
#include "setae/fields/describe.hpp"
#include "setae/fields/option.hpp"
#include "setae/topography/blind_tip.hpp"
#include "setae/topography/certainty.hpp"

namespace setae::answers {

/// Request of `setae tip` for a map.
struct BlindTipRequest {
    std::string threshold;
    Index points = 21;
    int rounds = 100;

    /// @throws InvalidArgument for a malformed length.
    [[nodiscard]] topography::BlindTipOptions options(parallel::Threads threads = {}) const;
};

/// The bluntest tip that is compatible with a map, and the resulting certainty of the surface.
struct BlindTipAnswer {
    std::string file;
    topography::BlindTip blind;
    topography::HeightMap tip;      ///< apex up
    topography::HeightMap surface;  ///< where it is certain, undefined elsewhere
    std::vector<Quantity> quantities;
    std::vector<Alert> alerts;
};

/// @throws InvalidArgument for a line; as topography::blind_tip() and certainty_map().
[[nodiscard]] BlindTipAnswer blind_tip(const std::string& file, const topography::Measurement& measurement,
                                       const BlindTipRequest& request, parallel::Threads threads = {});

}  // namespace setae::answers

template <>
struct setae::fields::Described<setae::answers::BlindTipAnswer> {
    using T = answers::BlindTipAnswer;
    static constexpr std::array rows_of_tip{
        made<T>("pixel_size", "width and height of a pixel",
                [](const T& of) -> const auto& { return of.blind.tip.pixel_size; })
            .in_unit("m"),
        made<T>("unit", "unit of pixel size and heights", [](const T&) { return std::string_view("m"); }),
        made<T>("heights", "heights of the tip below the apex, one list per x; `infinity` outside the tip",
                [](const T& of) { return Eigen::MatrixXd(of.blind.tip.heights.matrix()); })
            .in_unit("m"),
    };
    static constexpr Description heights_of_tip{"", "heights of the tip", rows_of_tip};
    static constexpr std::array rows{
        field<&T::file>("file", "name of the file as it was given"),
        made<T>("rounds", "number of passes over the map", [](const T& of) { return of.blind.rounds; }),
        made<T>("converged", "whether the last pass changed nothing", [](const T& of) { return of.blind.converged; }),
        field<&T::quantities>("quantities", "radius and height of the tip, and share of the surface that is certain"),
        part<T>("tip", "heights of the tip", heights_of_tip),
        field<&T::alerts>("alerts", "warnings"),
        inner<&T::blind>(),
        inner<&T::tip>(),
        inner<&T::surface>(),
    };
    static constexpr Description description{"", "tip shape determined from a scan", rows};
};
static_assert(setae::fields::complete<setae::answers::BlindTipAnswer>);

template <>
struct setae::fields::Asked<setae::answers::BlindTipRequest> {
    using R = answers::BlindTipRequest;
    static constexpr std::array options{
        option<&R::points>("points", "extent of the estimated tip in pixels, an odd number").default_shown(),
        option<&R::threshold>("threshold", "height by which the map must demand a sharper tip, about twice the noise")
            .of(non_negative(dimension::length))
            .such_as("0.2 nm")
            .or_else("0"),
        option<&R::rounds>("rounds", "largest number of passes over the map").default_shown().advanced(),
    };
};
