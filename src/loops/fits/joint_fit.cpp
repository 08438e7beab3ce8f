// SPDX-License-Identifier: GPL-3.0-or-later
#include "latent_routes.hpp"

namespace setae::loops {

JkrFit fit_joint(const BranchData& data, const LensAndCounterBody& bodies) {
    return latent::joint_route(data, bodies).fit;
}

}  // namespace setae::loops
