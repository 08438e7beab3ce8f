// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/half_space/body.hpp"
#include "setae/half_space/grid.hpp"
#include "setae/half_space/interaction.hpp"
#include "setae/output/json.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::answers {

/// The elastic body, as verbs of contacts are told.
struct BodyRequest {
    std::string contact_modulus;                ///< E* "1 GPa"
    std::string layer;                          ///< thickness "1 um" of a layer on a rigid base; empty: a half-space
    std::optional<double> poisson_ratio;        ///< of a layer
    bool bonded = false, frictionless = false;  ///< how a layer lies on its base

    /// @throws InvalidArgument for no modulus, a layer without its base or Poisson ratio, these without a layer.
    [[nodiscard]] half_space::Body body() const;
};

/// The attraction between the surfaces.
struct InteractionRequest {
    std::string work_of_adhesion, range;  ///< "50 mJ/m2", "0.3 nm"
    std::string law = "exponential";      ///< "cubic", "dugdale", "lennard_jones"

    [[nodiscard]] bool given() const { return !work_of_adhesion.empty() || !range.empty(); }
    /// @throws InvalidArgument where one of work and range is missing.
    [[nodiscard]] half_space::Interaction interaction() const;
};

/// A surface that touches.
struct TouchingSurface {
    half_space::Grid grid;
    Array2D heights;    ///< [m]
    bool line = false;  ///< a contact 1 m long
};

/// Of a map or a line. file: for messages. @throws InvalidArgument for a profile and undefined heights.
[[nodiscard]] TouchingSurface touching_surface(const std::string& file, const topography::Measurement& measurement);

/// {"mean_gap": 1e-9, …, "units": {"mean_gap": "m", …}}.
[[nodiscard]] output::Json quantities_json(const std::vector<Quantity>& quantities);
/// Adds points, size and contact_modulus.
void add_problem(output::Json& json, const half_space::Grid& grid, const half_space::Body& body);
/// Adds what the attraction is and how the grid resolves it.
void add_interaction(output::Json& json, const half_space::Interaction& interaction, const half_space::Body& body,
                     const half_space::Grid& grid);
/// Adds the file, what was done to its heights, and alerts.
void add_input(output::Json& json, const std::string& file, const std::vector<processing::StepRecord>& processing,
               const std::vector<Alert>& alerts);

/// A grid on which edges are caught by more than a per cent (half_space::resolution_of).
[[nodiscard]] std::vector<Alert> alerts_of_grid(const std::string& file, const half_space::Interaction& interaction,
                                                const half_space::Body& body, const half_space::Grid& grid);

}  // namespace setae::answers
