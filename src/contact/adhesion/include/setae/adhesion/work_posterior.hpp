// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "setae/adhesion/balance_draws.hpp"
#include "setae/adhesion/generalised_fit.hpp"
#include "setae/core/arrays.hpp"

namespace setae::adhesion {

/// Posterior of W from the pairs: a probability over W, which gives its value, its standard error and its interval.
///
///   y = max(0, W r − o) + own noise + scatter,  p(W | y) ∝ ∫ p(y | W, inputs, scatter) p(inputs) p(scatter)
///
/// Logarithms of slopes r and offsets o vary linearly with their inputs, so that stored energies and true areas stay
/// positive. At every W of a grid the inputs move to their most probable values at this W (Gauss–Newton through the
/// floor), the balance is linearised about them, and the scatter of pairs, surfaces and elastomers is integrated out
/// (MarginalScatter). Samples of this distribution, weighted by the density of the pairs divided by the linearised
/// density, correct the linearisation: floors and the skewness of stored energies. Flat prior in W >= 0.
///
/// prior of the scatter: half-Cauchy of 0.4 of the median measured work, or of twice the rms residual of least squares
/// where that is less. Coverage of its 95 % intervals: docs/validation/estimators.md.
class WorkPosterior {
public:
    /// @throws InvalidArgument for fewer than two pairs; UndefinedDataError where the likelihood has no maximum over W.
    explicit WorkPosterior(const std::vector<PairPoint>& pairs);
    ~WorkPosterior();
    WorkPosterior(WorkPosterior&&) noexcept;
    WorkPosterior& operator=(WorkPosterior&&) noexcept;

    /// Median, standard deviation and the interval between the 2.5 and 97.5 % points; method "posterior".
    [[nodiscard]] const Estimate& work_of_adhesion() const { return work_; }
    /// Probability density [1/(J/m²)] over W [J/m²], ascending.
    [[nodiscard]] const Array1D& grid() const { return grid_; }
    [[nodiscard]] const Array1D& density() const { return density_; }
    /// ln p(y) of the measured values, with W integrated over the grid [(J/m²)^(1 − n)].
    [[nodiscard]] double log_evidence() const { return log_evidence_; }
    /// Scatter at the median of W: square roots of the posterior means of τ², τ_s², τ_e².
    [[nodiscard]] const ModelScatter& scatter() const { return scatter_; }

    /// Joint posterior draws of W, of all inputs and of the scatter, and max(0, balance) of `lines` there; inputs that
    /// contradict the pairs are drawn rarely. A line with a `departure` deviates by effects of the scatter; those of
    /// its surface and elastomer are the effects of the pairs. A seed gives equal numbers on all platforms.
    [[nodiscard]] BalanceDraws draw(const std::vector<PairPoint>& lines, int count, std::uint64_t seed) const;

private:
    class Balance;
    struct At;

    void find_grid();
    [[nodiscard]] Array1D log_densities_about(double likeliest);
    [[nodiscard]] At at(double work) const;
    /// ln of the linearised density of the pairs, and of the correction by samples.
    struct LogDensity {
        double straight = 0.0, correction = 0.0;
    };
    [[nodiscard]] LogDensity log_density(double work) const;

    std::unique_ptr<Balance> balance_;
    Array1D grid_, density_, cumulative_, correction_;
    Estimate work_;
    ModelScatter scatter_;
    double log_evidence_ = 0.0;
};

/// The generalised fit at the posterior's W and scatter: contributions of all inputs to W, in proportion to the weights
/// of the pairs there, scaled so that the standard error is that of the posterior and correlations with predictions are
/// kept.
[[nodiscard]] TracedValue traced_work(const WorkPosterior& posterior, const std::vector<PairPoint>& pairs);

}  // namespace setae::adhesion
