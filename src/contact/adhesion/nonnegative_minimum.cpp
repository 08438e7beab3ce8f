// SPDX-License-Identifier: GPL-3.0-or-later
#include "nonnegative_minimum.hpp"

#include <algorithm>
#include <vector>

#include <Eigen/Cholesky>

namespace setae::adhesion {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// The minimum over the free parameters, with the others at 0.
VectorXd minimum_of_free(const MatrixXd& N, const VectorXd& b, const std::vector<Index>& free) {
    if (free.empty()) return VectorXd::Zero(b.size());
    const VectorXd inner = MatrixXd(N(free, free)).llt().solve(VectorXd(b(free)));
    VectorXd all = VectorXd::Zero(b.size());
    all(free) = inner;
    return all;
}

}  // namespace

VectorXd nonnegative_minimum(const MatrixXd& N, const VectorXd& b) {
    constexpr double rounding = 1e-12;
    const VectorXd scale = N.diagonal().cwiseSqrt().cwiseInverse();
    const MatrixXd M = scale.asDiagonal() * N * scale.asDiagonal();
    const VectorXd c = scale.cwiseProduct(b);
    const double least = rounding * c.cwiseAbs().maxCoeff();
    std::vector<Index> free;
    VectorXd x = VectorXd::Zero(b.size());
    for (Index step = 0; step < 10 * b.size(); ++step) {
        VectorXd gain = c - M * x;
        for (const auto k : free) gain[k] = 0.0;
        Index best = 0;
        if (!(gain.maxCoeff(&best) > least)) break;
        free.push_back(best);
        VectorXd found = minimum_of_free(M, c, free);
        while (!free.empty() && found(free).minCoeff() <= 0.0) {
            double share = 1.0;
            for (const auto k : free)
                if (found[k] <= 0.0) share = std::min(share, x[k] / (x[k] - found[k]));
            x += share * (found - x);
            std::erase_if(free, [&](Index k) { return x[k] <= rounding * x.maxCoeff() && found[k] <= 0.0; });
            for (Index k = 0; k < x.size(); ++k)
                if (std::find(free.begin(), free.end(), k) == free.end()) x[k] = 0.0;
            found = minimum_of_free(M, c, free);
        }
        x = found;
    }
    return scale.cwiseProduct(x);
}

}  // namespace setae::adhesion
