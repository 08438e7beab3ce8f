// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Cholesky>

#include "setae/adhesion/generalised_fit.hpp"

namespace setae::adhesion {

/// The weights of a fit, held while its pairs move.
class GeneralisedWeights {
public:
    GeneralisedWeights(const std::vector<PairPoint>& pairs, const GeneralisedFit& fit);

    /// W of as many pairs by these weights.
    [[nodiscard]] double work_of(const std::vector<PairPoint>& pairs) const;

private:
    Eigen::LLT<Eigen::MatrixXd> factor_;
    double start_;
};

}  // namespace setae::adhesion
