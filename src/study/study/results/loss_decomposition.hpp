// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "hysteresis_pairs.hpp"

namespace setae::study {

/// A pair, and the model of its energy budget.
struct PairModel {
    const PreparedPair& pair;
    hysteresis::FittedModel fitted;
    adhesion::ModelScatter scatter;  ///< scatter of pairs about the model
    bool ranked = false;             ///< false: the model is assumed, and works of retraction are not compared with it
};

struct DecomposedLosses {
    std::vector<Outcome<LossDecomposition>> pairs;  ///< in their order
    Outcome<JointLossFit> joint;
};

/// Energy budget of every loop, then one fit of all: inputs (E*, W_int, rate dependence of the tip, spectra, lenses),
/// the parameters of the models and the scatter of works about them are adjusted to the measured E_loss and W_ret. The
/// parameters of models may vary within five of the standard errors of the ranking. The additional scatter of energies
/// is that of maximum likelihood.
[[nodiscard]] DecomposedLosses decomposed_losses(const std::vector<PairModel>& pairs);

}  // namespace setae::study
