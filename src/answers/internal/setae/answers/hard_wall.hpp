// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/half_space/hard_wall.hpp"
#include "setae/output/json.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::answers {

/// What `setae contact solve` is told beside the surface; see docs/theory/half-space.md.
struct HardWallRequest {
    std::string contact_modulus;                   ///< E* "1 GPa"
    std::string pressure, displacement, mean_gap;  ///< one of them
    std::string layer, hardness;                   ///< thickness "1 um" of a layer; "1 GPa"
    std::optional<double> poisson_ratio;           ///< of a layer
    bool free = false;                             ///< nothing touches beyond the map
    bool bonded = false, frictionless = false;     ///< how a layer lies on its base
    double tolerance = 1e-8;                       ///< of the duality gap

    /// @throws InvalidArgument where not one control is given, or a malformed one.
    [[nodiscard]] half_space::Control control() const;
    /// @throws InvalidArgument for no modulus, a layer without its base or Poisson ratio, these without a layer.
    [[nodiscard]] half_space::Body body() const;
    /// @throws as body() and control(): what is missing, before heights are read.
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

/// Of a map or, as a contact 1 m long, of a line. @throws InvalidArgument for a profile, undefined heights, as
/// HardWallRequest and half_space::solve().
[[nodiscard]] HardWallAnswer hard_wall(const std::string& file, const topography::Measurement& measurement,
                                       const HardWallRequest& request, parallel::Threads threads = {},
                                       const std::function<void(const half_space::SolveProgress&)>& progress = {});

/// Quantities by name, what is known of their accuracy, "file", "processing" and "alerts".
[[nodiscard]] output::Json to_json(const HardWallAnswer& answer, const std::vector<processing::StepRecord>& processing);

}  // namespace setae::answers
