// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "model_problem.hpp"

namespace setae::loops {

/// A branch made ready for a fit: the problem, the slots that move, and the values of those that do not.
struct PreparedFit {
    BranchProblem problem;
    BranchProblem trial;  ///< few of the samples, without weights to renew: for the search of a start
    ChannelNoise noise;
    std::vector<Index> free;  ///< slots of FitParameters
    FitParameters given = FitParameters::Zero();

    [[nodiscard]] bool is_free(Index slot) const;
    void hold(Index slot, double value);
};

/// Checks data and options and reads unknown noise from the samples. @throws as fit_model.
[[nodiscard]] PreparedFit prepare(const BranchData& data, const LensAndCounterBody& bodies,
                                  const ModelFitOptions& options);

/// Parameters near the least squares. @throws UndefinedDataError where none is found.
[[nodiscard]] FitParameters find_start(const PreparedFit& fit, const BranchData& data);

struct FitSolution {
    FitParameters at;
    LeastSquaresSolution least_squares;  ///< solution in the free slots
};

/// Least squares from a start, weights renewed until they settle.
[[nodiscard]] FitSolution solve(PreparedFit& fit, const FitParameters& start);

/// Whether a curve can be computed for a set of parameters.
[[nodiscard]] bool drawable(const FitParameters& at);

}  // namespace setae::loops
