// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/fields/option.hpp"
#include "setae/fields/row.hpp"
#include "setae/half_space/body.hpp"
#include "setae/half_space/grid.hpp"
#include "setae/half_space/interaction.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::answers {

/// The elastic body of every contact command: a half-space, or a layer on a rigid base.
struct BodyRequest {
    std::string contact_modulus;
    std::string layer;  ///< empty: a half-space
    std::optional<double> poisson_ratio;
    bool bonded = false, frictionless = false;

    /// @throws InvalidArgument for no modulus, a layer without its base or Poisson ratio, these without a layer.
    [[nodiscard]] half_space::Body body() const;
};

/// The attraction between the surfaces.
struct InteractionRequest {
    std::string work_of_adhesion, range;
    std::string law = "exponential";

    [[nodiscard]] bool given() const { return !work_of_adhesion.empty() || !range.empty(); }
    /// @throws InvalidArgument where one of work and range is missing.
    [[nodiscard]] half_space::Interaction interaction() const;
};

/// A surface in contact.
struct TouchingSurface {
    half_space::Grid grid;
    Array2D heights;    ///< [m]
    bool line = false;  ///< a contact 1 m long
};

/// The surface of a map or a line. file: for messages. @throws InvalidArgument for a profile and undefined heights.
[[nodiscard]] TouchingSurface touching_surface(const std::string& file, const topography::Measurement& measurement);

/// Units by name of quantities, and of numbers that rows describe.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> units_by_name(
    const std::vector<Quantity>& quantities, std::initializer_list<const fields::Description*> numbers = {});

/// A grid on which edges are caught by more than a per cent (half_space::resolution_of).
[[nodiscard]] std::vector<Alert> alerts_of_grid(const std::string& file, const half_space::Interaction& interaction,
                                                const half_space::Body& body, const half_space::Grid& grid);

}  // namespace setae::answers

template <>
struct setae::fields::Asked<setae::answers::BodyRequest> {
    using R = answers::BodyRequest;
    static constexpr std::array options{
        option<&R::contact_modulus>("contact_modulus", "contact modulus E* = E/(1 - nu^2) of the soft body")
            .of(positive(dimension::pressure))
            .such_as("1 GPa")
            .required(),
        option<&R::layer>("layer", "thickness of an elastic layer on a rigid base")
            .of(positive(dimension::length))
            .such_as("1 um")
            .or_else("a half-space"),
        option<&R::bonded>("bonded", "the layer sticks to its base"),
        option<&R::frictionless>("frictionless", "the layer slides on its base"),
        option<&R::poisson_ratio>("poisson_ratio", "Poisson ratio of the layer, from 0 to 0.5")
            .within(domain::poisson_ratio)
            .short_name("nu")
            .in_python("nu"),
    };
};

template <>
struct setae::fields::Asked<setae::answers::InteractionRequest> {
    using R = answers::InteractionRequest;
    static constexpr std::array<std::string_view, 4> laws{"exponential", "cubic", "dugdale", "lennard_jones"};
    static constexpr std::array options{
        option<&R::work_of_adhesion>("work_of_adhesion", "work of adhesion per unit area in contact")
            .of(positive(dimension::surface_energy))
            .such_as("50 mJ/m2")
            .short_name("w")
            .in_python("W_int"),
        option<&R::range>("range",
                          "range of the attraction: its greatest tension is the work of adhesion over the range")
            .of(positive(dimension::length))
            .such_as("0.3 nm"),
        option<&R::law>("law", "decay of the attraction with the gap").one_of(laws).default_shown(),
    };
};
