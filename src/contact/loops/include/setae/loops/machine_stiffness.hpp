// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/estimate.hpp"
#include "setae/loops/segments.hpp"

namespace setae::loops {

/// Stiffness of the testing machine from a contact so stiff that all motion of the stage is deflection of the testing
/// machine.
struct MachineStiffness {
    Estimate stiffness;  ///< k = dF/d(stage) [N/m], both branches together
    Estimate loading;    ///< the stiffness of each branch [N/m]
    Estimate unloading;  ///< NaN where the record has no retraction
    /// largest difference of the stage between the branches at one force, divided by the deflection; NaN without
    /// retraction
    double hysteresis = 0.0;
    /// change of slope from the lower to the upper half of the forces, divided by the slope
    double nonlinearity = 0.0;
    Index n = 0;
};

struct RigidContactOptions {
    double lowest_share = 0.2;  ///< share of the largest force below which the bodies are still settling
    /// a larger value indicates a soft contact, whose slope increases with the force
    double largest_nonlinearity = 0.1;
};

/// Machine stiffness from a loop on a rigid counter-body: the slope of force against stage (Huber's M-estimate, robust
/// against outliers; noise of the stage is assumed small) above `lowest_share` of the largest force, the mean of both
/// branches.
///
/// `loop.displacement` is the stage's position. The standard error includes the scatter of the residuals with their
/// correlations, and half the difference of the branches.
/// @throws UndefinedDataError where the slope increases with the force by more than `largest_nonlinearity`, as that of
/// a soft contact does, where there is no displacement, or fewer than 10 samples on the branch.
[[nodiscard]] MachineStiffness machine_stiffness_from_rigid_contact(const Loop& loop, const Segments& segments,
                                                                    Index contact = 0,
                                                                    const RigidContactOptions& options = {});

/// The stiffness with the segments determined first; without adhesion, branches are separated at the largest force.
[[nodiscard]] MachineStiffness machine_stiffness_from_rigid_contact(const Loop& loop);

}  // namespace setae::loops
