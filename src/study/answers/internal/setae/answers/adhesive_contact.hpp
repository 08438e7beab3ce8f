// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/answers/hard_wall.hpp"
#include "setae/half_space/adhesive_loop.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::answers {

/// Surfaces that attract each other, in the equilibrium met coming from far.
struct AdhesiveContactAnswer {
    std::string file;
    half_space::Body body;
    half_space::Interaction interaction;
    half_space::Grid grid;
    half_space::AdhesiveCell cell;
    half_space::AdhesiveState state;
    std::vector<Quantity> quantities;
    std::vector<Alert> alerts;
};

/// request: its control is a pressure, a mean gap or a displacement, of the body or of a stage with a stiffness; the
/// cell repeats itself.
/// @throws InvalidArgument for a hardness, free edges or a stage that is not displaced; otherwise as hard_wall() and
/// half_space::AdhesiveCell.
[[nodiscard]] AdhesiveContactAnswer adhesive_contact(const std::string& file,
                                                     const topography::Measurement& measurement,
                                                     const HardWallRequest& request,
                                                     const InteractionRequest& attraction,
                                                     parallel::Threads threads = {});

}  // namespace setae::answers
