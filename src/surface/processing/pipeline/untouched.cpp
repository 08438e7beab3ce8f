// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/untouched.hpp"

#include <algorithm>
#include <variant>

#include "setae/core/constants.hpp"

namespace setae::processing {
namespace {

/// Longest and shortest waves that pass a filter, over its cutoff.
struct Reach {
    double long_waves, short_waves;
};

constexpr Reach gaussian{11.8, 1.0 / 2.77}, second_order{4.1, 0.475}, spline{3.76, 1.0 / 3.76},
    tense_spline{14.1, 1.0 / 14.1};
constexpr double interpolated_end = 0.35;  ///< of q times the step, at which averages and straight lines keep 99 %

class Visitor {
public:
    explicit Visitor(double step) : step_(step) {}

    void operator()(const LevelPlane&) { take_degree(1); }
    void operator()(const LevelFacet&) { take_degree(1); }
    void operator()(const LevelPolynomial& step) { take_degree(std::min(step.degree, step.degree_x)); }
    void operator()(const LevelLines& step) {
        if (step.direction == Direction::x) take_degree(step.degree);
    }
    void operator()(const AlignRows& step) {
        if (step.direction == Direction::x && step.method == RowAlignment::polynomial) take_degree(step.degree);
    }
    void operator()(const GaussianFilter& step) { filter(step.cutoff, step.keep, gaussian); }
    void operator()(const RobustGaussianFilter& step) {
        filter(step.cutoff, step.keep, step.order == 2 ? second_order : gaussian);
    }
    void operator()(const SplineFilter& step) {
        filter(step.cutoff, step.keep, step.tension > 0.0 ? tense_spline : spline);
    }
    void operator()(const FourierCut& step) {
        if (step.longest) raise(2.0 * pi / *step.longest);
        if (step.shortest) lower(2.0 * pi / *step.shortest);
    }
    void operator()(const Resample& step) {
        lower(interpolated_end / std::max(step_, step.pixel_size.value_or(step_)));
    }
    void operator()(const Rotate&) { lower(interpolated_end / step_); }
    template <class Other>
    void operator()(const Other&) {}

    Untouched result;

private:
    void take_degree(Index degree) { result.trend_degree = std::max(result.trend_degree, degree); }
    void raise(double q) { result.band.lower = std::max(result.band.lower, q); }
    void lower(double q) { result.band.upper = std::min(result.band.upper, q); }
    void filter(double cutoff, Kept keep, const Reach& reach) {
        if (keep == Kept::long_waves) lower(2.0 * pi / (reach.long_waves * cutoff));
        else raise(2.0 * pi / (reach.short_waves * cutoff));
    }

    double step_;
};

}  // namespace

Untouched untouched(const Pipeline& pipeline, double step) {
    Visitor visitor(step);
    for (const auto& entry : pipeline.entries)
        if (entry.on) std::visit(visitor, entry.step);
    return visitor.result;
}

}  // namespace setae::processing
