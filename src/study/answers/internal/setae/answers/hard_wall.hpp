// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "setae/answers/contact_problem.hpp"
#include "setae/fields/option.hpp"
#include "setae/half_space/hard_wall.hpp"

namespace setae::answers {

/// Request of `setae contact solve` without the surface; see docs/concepts/half-space.md.
struct HardWallRequest : BodyRequest {
    std::string pressure, displacement, mean_gap;  ///< one of them
    std::string stage_stiffness;                   ///< with adhesion only
    std::string hardness;                          ///< empty: the body stays elastic
    bool free = false;
    double tolerance = 1e-8;

    /// @throws InvalidArgument where not one control is given, or a malformed one.
    [[nodiscard]] half_space::Control control() const;
    /// @throws as body() and control(): missing values, before heights are read.
    void require_complete() const;
};

/// A rigid rough surface pressed on an elastic body.
struct HardWallAnswer {
    std::string file;
    half_space::HardWall problem;
    half_space::HardWallContact contact;
    double stiffness = 0.0;  ///< dp/du [Pa/m]
    std::vector<Quantity> quantities;
    std::vector<Alert> alerts;
};

/// The contact of a map or, as a contact of 1 m length, of a line. @throws InvalidArgument for a profile, undefined
/// heights, as HardWallRequest and half_space::solve().
[[nodiscard]] HardWallAnswer hard_wall(const std::string& file, const topography::Measurement& measurement,
                                       const HardWallRequest& request, parallel::Threads threads = {},
                                       const std::function<void(const half_space::SolveProgress&)>& progress = {});

}  // namespace setae::answers

template <>
struct setae::fields::Asked<setae::answers::HardWallRequest> {
    using R = answers::HardWallRequest;
    static constexpr std::array options{
        option<&R::pressure>("pressure", "mean pressure over the map")
            .of(non_negative(dimension::pressure))
            .such_as("10 MPa"),
        option<&R::displacement>("displacement", "approach from first touch").of(dimension::length).such_as("5 nm"),
        option<&R::stage_stiffness>("stage_stiffness", "stiffness of the stage that is displaced, with adhesion only")
            .of(positive(dimension::stiffness))
            .such_as("10 N/m"),
        option<&R::mean_gap>("mean_gap", "mean gap over the map").of(positive(dimension::length)).such_as("2 nm"),
        option<&R::free>("free", "nothing touches beyond the map; without it the map repeats itself"),
        option<&R::hardness>("hardness", "pressure at which the body flows")
            .of(positive(dimension::pressure))
            .such_as("1 GPa")
            .or_else("the body stays elastic"),
        option<&R::tolerance>("tolerance", "largest relative duality gap of a converged contact")
            .within(domain::positive)
            .default_shown()
            .advanced(),
    };
};
