// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimator_survey.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "setae/adhesion/pair_fit.hpp"
#include "setae/adhesion/scatter_effects.hpp"
#include "setae/adhesion/work_posterior.hpp"
#include "setae/core/component_rows.hpp"
#include "setae/numerics/random_numbers.hpp"

namespace setae::reference {
namespace {

using adhesion::PairPoint;

constexpr double one_sigma = 0.6827, two_sigma = 0.95;

/// W between p/2 and 1 − p/2 of a posterior, p = 1 − level.
Interval interval_of_density(const adhesion::WorkPosterior& posterior, double level) {
    const auto& grid = posterior.grid();
    const auto& density = posterior.density();
    double below = 0.0;
    Interval found{grid[0], grid[grid.size() - 1], level};
    const double tail = 0.5 * (1.0 - level);
    for (Index k = 1; k < grid.size(); ++k) {
        const double piece = 0.5 * (density[k] + density[k - 1]) * (grid[k] - grid[k - 1]);
        const auto reaches = [&](double p) { return below < p && below + piece >= p; };
        const auto at = [&](double p) { return grid[k - 1] + (p - below) / piece * (grid[k] - grid[k - 1]); };
        if (reaches(tail)) found.lower = at(tail);
        if (reaches(1.0 - tail)) found.upper = at(1.0 - tail);
        below += piece;
    }
    return found;
}

/// One answer of one estimator.
struct Answer {
    double value = 0.0, standard_error = 0.0;
    Interval of_one_sigma, of_two_sigma;
};

std::optional<Answer> answer_of(const Estimate& estimate) {
    const auto narrow = interval_of(estimate, one_sigma), wide = interval_of(estimate, two_sigma);
    if (!narrow || !wide) return std::nullopt;
    return Answer{estimate.value, estimate.standard_error, *narrow, *wide};
}

Answer answer_of(const adhesion::WorkPosterior& posterior) {
    const auto& found = posterior.work_of_adhesion();
    return {found.value, found.standard_error, interval_of_density(posterior, one_sigma),
            interval_of_density(posterior, two_sigma)};
}

class Tally {
public:
    explicit Tally(std::string name) { survey_.estimator = std::move(name); }

    void add(const std::optional<Answer>& answer) {
        if (!answer) return;
        const double error = answer->value - true_work;
        sum_ += error;
        squares_ += error * error;
        stated_ += answer->standard_error * answer->standard_error;
        width_ += answer->of_two_sigma.upper - answer->of_two_sigma.lower;
        const auto covers = [](const Interval& i) { return i.lower <= true_work && true_work <= i.upper ? 1.0 : 0.0; };
        survey_.covered_68 += covers(answer->of_one_sigma);
        survey_.covered_95 += covers(answer->of_two_sigma);
        ++survey_.sets;
    }

    [[nodiscard]] EstimatorSurvey result() const {
        auto survey = survey_;
        const double n = std::max(1, survey.sets);
        survey.bias = sum_ / n;
        survey.deviation = std::sqrt(std::max(0.0, squares_ / n - survey.bias * survey.bias));
        survey.stated = std::sqrt(stated_ / n);
        survey.width = width_ / n;
        survey.covered_68 /= n;
        survey.covered_95 /= n;
        return survey;
    }

private:
    EstimatorSurvey survey_;
    double sum_ = 0.0, squares_ = 0.0, stated_ = 0.0, width_ = 0.0;
};

struct DrawnSet {
    std::vector<PairPoint> pairs;
    int floored = 0;  ///< pairs whose true balance is below 0
};

/// A number above 0 moves in its logarithm.
double moved(double value, double change) { return value > 0.0 ? value * std::exp(change / value) : value + change; }

DrawnSet drawn_set(const EstimatorDesign& design, std::uint64_t seed) {
    const numerics::RandomKey key{seed};
    const auto n = static_cast<Index>(design.pairs.size());
    std::vector<const Components*> inputs;
    for (const auto part : {&PairPoint::slope_inputs, &PairPoint::offset_inputs, &PairPoint::measured_inputs})
        for (const auto& pair : design.pairs) inputs.push_back(&(pair.*part));
    const Eigen::MatrixXd rows = component_rows(inputs);
    const Eigen::VectorXd changes =
        rows * numerics::normal_numbers(numerics::substream(key, 0), 0, rows.cols()).matrix();
    const Array1D noise = numerics::normal_numbers(numerics::substream(key, 1), 0, n);
    adhesion::ScatterEffects effects(design.scatter, numerics::substream(key, 2));
    DrawnSet drawn{design.pairs, 0};
    for (Index i = 0; i < n; ++i) {
        auto& pair = drawn.pairs[static_cast<std::size_t>(i)];
        const double balance = moved(pair.slope, changes[i]) * true_work - moved(pair.offset, changes[n + i]);
        if (balance < 0.0) ++drawn.floored;
        const double of_inputs = 1.0 + changes[2 * n + i] / pair.measured.value;
        const double work = (std::max(0.0, balance) + effects.of(pair.surface, pair.elastomer)) * of_inputs +
                            pair.measured.standard_error * noise[i];
        // relative errors remain those of the instrument
        pair.measured_inputs = combined({{std::max(0.0, work) / pair.measured.value, pair.measured_inputs}});
        pair.measured.value = std::max(0.0, work);
    }
    return drawn;
}

}  // namespace

std::vector<PairPoint> subset(const std::vector<PairPoint>& pairs, const std::vector<std::string>& surfaces,
                              const std::vector<std::string>& elastomers) {
    std::vector<PairPoint> chosen;
    std::ranges::copy_if(pairs, std::back_inserter(chosen), [&](const PairPoint& pair) {
        return std::ranges::find(surfaces, pair.surface) != surfaces.end() &&
               std::ranges::find(elastomers, pair.elastomer) != elastomers.end();
    });
    return chosen;
}

std::vector<PairPoint> drawn_pairs(const EstimatorDesign& design, std::uint64_t seed) {
    return drawn_set(design, seed).pairs;
}

std::vector<EstimatorSurvey> survey_estimators(const EstimatorDesign& design, int sets, std::uint64_t first_seed) {
    Tally posterior("posterior"), independent("least squares, pairs independent"),
        clustered("least squares, clustered errors"), moments("scatter by moments"),
        generalised("generalised least squares");
    int done = 0;
    for (std::uint64_t seed = first_seed; done < sets; ++seed) {
        const auto drawn = drawn_set(design, seed);
        if (design.floored >= 0 && drawn.floored != design.floored) continue;
        ++done;
        const auto fit = adhesion::fit_work_of_adhesion(drawn.pairs);
        posterior.add(answer_of(adhesion::WorkPosterior(drawn.pairs)));
        independent.add(answer_of(fit.work_of_adhesion));
        clustered.add(answer_of(fit.clustered));
        moments.add(fit.with_extra_scatter ? answer_of(fit.with_extra_scatter->work_of_adhesion) : std::nullopt);
        generalised.add(answer_of(fit.generalised.estimate()));
    }
    return {posterior.result(), independent.result(), clustered.result(), moments.result(), generalised.result()};
}

}  // namespace setae::reference
