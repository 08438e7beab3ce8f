// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/estimate.hpp"
#include "setae/loops/segments.hpp"

namespace setae::loops {

/// Stiffness of the machine from a contact so stiff that all of the stage's motion is the machine's own deflection.
struct MachineStiffness {
    Estimate stiffness;         ///< k = dF/d(stage) [N/m], both branches together
    Estimate loading;           ///< the same of each branch [N/m]
    Estimate unloading;         ///< NaN where the record has no retraction
    double hysteresis = 0.0;    ///< largest difference of the stage between the branches at one force, over the
                                ///< deflection; NaN without retraction
    double nonlinearity = 0.0;  ///< change of slope from the lower to the upper half of the forces, over the slope
    Index n = 0;
};

struct RigidContactOptions {
    double lowest_share = 0.2;          ///< of the largest force, below which the touching bodies still settle
    double largest_nonlinearity = 0.1;  ///< more of it is a soft contact, whose slope grows with the force
};

/// Machine stiffness from a loop on a rigid counter-body: the slope of force against stage (Huber's M-estimate:
/// outliers count little; noise of the stage is taken to be small) above `lowest_share` of the largest force, the mean
/// of both branches.
///
/// `loop.displacement` is the stage's position. The standard error holds the scatter of the residuals, correlated as
/// they are, and half the difference of the branches.
/// @throws UndefinedDataError where the slope grows with the force by more than `largest_nonlinearity`, as that of a
/// soft contact does, where there is no displacement, or fewer than 10 samples on the branch.
[[nodiscard]] MachineStiffness machine_stiffness_from_rigid_contact(const Loop& loop, const Segments& segments,
                                                                    Index contact = 0,
                                                                    const RigidContactOptions& options = {});

/// The same with the segments found first; of bodies that do not stick, all up to the largest force and from there on.
[[nodiscard]] MachineStiffness machine_stiffness_from_rigid_contact(const Loop& loop);

}  // namespace setae::loops
