// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "hysteresis_pairs.hpp"

namespace setae::study {

/// A pair, and the law by which its joules are told.
struct PairLaw {
    const PreparedPair& pair;
    hysteresis::FittedModel fitted;
    adhesion::ModelScatter scatter;  ///< of pairs about the law
    bool ranked = false;             ///< else the law is assumed: works of retraction are not held against it
};

struct DecomposedLosses {
    std::vector<Outcome<LossDecomposition>> pairs;  ///< in their order
    Outcome<JointLossFit> joint;
};

/// Every loop taken apart, then all of them in one fit: inputs (E*, W_int, the tip's law, spectra, lenses), the laws'
/// own numbers and the scatter of works about them move until E_loss and W_ret are what was measured. The numbers of
/// laws are free within five of the standard errors that the ranking left them. What energies scatter by beyond it is
/// as likely as can be.
[[nodiscard]] DecomposedLosses decomposed_losses(const std::vector<PairLaw>& pairs);

}  // namespace setae::study
