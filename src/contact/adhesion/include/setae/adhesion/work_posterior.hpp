// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "setae/adhesion/balance_draws.hpp"
#include "setae/adhesion/generalised_fit.hpp"
#include "setae/core/arrays.hpp"

namespace setae::adhesion {

/// W as the pairs leave it: a probability over W, from which its value, its standard error and its interval are taken.
///
///   y = max(0, W r − o) + own noise + scatter,  p(W | y) ∝ ∫ p(y | W, inputs, scatter) p(inputs) p(scatter)
///
/// Slopes r and offsets o vary in their logarithms with the inputs they rest on, so that stored energies and true areas
/// stay positive. At every W of a grid the inputs are taken to where the pairs put them at this W (Gauss–Newton through
/// the floor), the balance is a straight line in them about there, and scatter of pairs, surfaces and elastomers is
/// integrated out (MarginalScatter). Samples drawn from that, weighted by the density of the pairs over that of the
/// straight line, put right what the line leaves out: floors and the skewness of what surfaces store. Flat prior in
/// W >= 0.
///
/// prior of the scatter: half-Cauchy of 0.4 of the median measured work, or of twice the rms residual of least squares
/// where that is less. Coverage of its 95 % intervals: docs/validation/estimators.md.
class WorkPosterior {
public:
    /// @throws InvalidArgument for fewer than two pairs; UndefinedDataError where no W explains the pairs better than
    /// every other.
    explicit WorkPosterior(const std::vector<PairPoint>& pairs);
    ~WorkPosterior();
    WorkPosterior(WorkPosterior&&) noexcept;
    WorkPosterior& operator=(WorkPosterior&&) noexcept;

    /// Median, standard deviation and the interval between the 2.5 and 97.5 % points; method "posterior".
    [[nodiscard]] const Estimate& work_of_adhesion() const { return work_; }
    /// Probability density [1/(J/m²)] over W [J/m²], ascending.
    [[nodiscard]] const Array1D& grid() const { return grid_; }
    [[nodiscard]] const Array1D& density() const { return density_; }
    /// ln p(y): of the measured values, W integrated over the grid [(J/m²)^(1 − n)].
    [[nodiscard]] double log_evidence() const { return log_evidence_; }
    /// At the median: square roots of the posterior means of τ², τ_s², τ_e².
    [[nodiscard]] const ModelScatter& scatter() const { return scatter_; }

    /// Draws of W, of all inputs and of the scatter, together as the pairs leave them, and max(0, balance) of `lines`
    /// there: inputs that the pairs refute are drawn seldom. A line with a `departure` departs by effects of the
    /// scatter; those of its surface and elastomer are the ones that pairs have. Same numbers for a seed on any
    /// machine.
    [[nodiscard]] BalanceDraws draw(const std::vector<PairPoint>& lines, int count, std::uint64_t seed) const;

private:
    class Balance;
    struct At;

    void find_grid();
    [[nodiscard]] Array1D log_densities_about(double likeliest);
    [[nodiscard]] At at(double work) const;
    /// ln of the density of the pairs by the straight line, and of what samples multiply it by.
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

/// The generalised fit at the posterior's W and scatter: what W rests on, input by input, in proportion to the weights
/// of the pairs there, so that its standard error is the posterior's and predictions know what they share with it.
[[nodiscard]] TracedValue traced_work(const WorkPosterior& posterior, const std::vector<PairPoint>& pairs);

}  // namespace setae::adhesion
