// SPDX-License-Identifier: GPL-3.0-or-later
#include "fit_support.hpp"
#include "latent_fit.hpp"
#include "latent_start.hpp"

namespace setae::experiment {

JkrFit fit_joint(const BranchData& data, const LensAndCounterBody& bodies) {
    const latent::Points points = latent::points(data, bodies, {.displacement = true, .contact_radius = true});
    const latent::Fitted fitted = latent::fit(points, latent::linear_start(points));
    const latent::Across noise = latent::across(points, latent::projected(points, fitted.solution));
    JkrFit fit = latent::finished(fitted, noise, "joint");
    fit.residuals = noise.force;
    fit.depth_residuals = noise.depth;
    fit.residual_unit = "N";
    complete(fit, bodies, data.force.maxCoeff() - data.force.minCoeff());
    return fit;
}

}  // namespace setae::experiment
