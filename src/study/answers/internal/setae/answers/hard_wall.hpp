// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "setae/answers/contact_problem.hpp"
#include "setae/half_space/hard_wall.hpp"

namespace setae::answers {

/// What `setae contact solve` is told beside the surface; see docs/concepts/half-space.md.
struct HardWallRequest : BodyRequest {
    std::string pressure, displacement, mean_gap;  ///< one of them
    std::string stage_stiffness;                   ///< "10 N/m" of a stage that is displaced; with adhesion
    std::string hardness;                          ///< "1 GPa"
    bool free = false;                             ///< nothing touches beyond the map
    double tolerance = 1e-8;                       ///< of the duality gap

    /// @throws InvalidArgument where not one control is given, or a malformed one.
    [[nodiscard]] half_space::Control control() const;
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
