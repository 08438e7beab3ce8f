// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/crack_front/straight_front.hpp"

#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "front_equation.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::crack_front {
namespace {

Array2D works_of(const WorkField& field) {
    require(field);
    return field.works;
}

/// Mean over stretches of a way, and how the means of the stretches scatter.
struct StretchMean {
    double value = 0.0, standard_error = 0.0;
};

StretchMean mean_of_stretches(const std::vector<double>& values) {
    constexpr std::size_t stretches = 8;
    std::array<double, stretches> means{};
    const std::size_t length = std::max<std::size_t>(values.size() / stretches, 1);
    for (std::size_t s = 0; s < stretches; ++s)
        for (std::size_t i = 0; i < length; ++i)
            means[s] += values[std::min(s * length + i, values.size() - 1)] / static_cast<double>(length);
    StretchMean mean;
    for (const double m : means) mean.value += m / stretches;
    for (const double m : means) mean.standard_error += (m - mean.value) * (m - mean.value);
    mean.standard_error = std::sqrt(mean.standard_error / (stretches * (stretches - 1)));
    return mean;
}

}  // namespace

/// Residuals are G − w [J/m²], with G what the spring and the front's waves leave of W.
class StraightEquation final : public FrontEquation {
public:
    StraightEquation(const PinningLines& pinning, LineElasticity& elasticity, double mean_work, double restoring)
        : FrontEquation(pinning, elasticity), mean_work_(mean_work), restoring_(restoring) {}

    void drive_to(double position) { drive_ = position; }

private:
    void elastic_part(const Array1D& front, const Array1D& bent, Balance& balance) override {
        balance.residual = mean_work_ * (1.0 + restoring_ * (front - drive_) + bent);
        balance.stiffness.setConstant(front.size(), mean_work_ * restoring_);
        balance.kernel = mean_work_;
    }

    double mean_work_, restoring_, drive_ = 0.0;
};

class StraightFront::Work {
public:
    Work(const WorkField& field, const StraightFrontOptions& options)
        : options_(options),
          mean_work_(field.mean_work),
          restoring_(options.restoring > 0.0 ? options.restoring : pi / options.width),
          pinning_(works_of(field), field.points, true),
          elasticity_(field.lines(), 2.0 * pi / options.width),
          equation_(pinning_, elasticity_, field.mean_work, restoring_),
          front(Array1D::Zero(field.lines())) {
        if (!(options.width > 0.0 && options.restoring >= 0.0))
            throw InvalidArgument(fmt::format("a front of {} m on a spring of {} 1/m; expected a width above 0",
                                              options.width, options.restoring));
    }

    State drive_to(double position) {
        equation_.drive_to(position);
        const SearchLimits limits{.tolerance = options_.tolerance * mean_work_,
                                  .most_iterations = options_.most_iterations,
                                  .largest_move = options_.largest_move * pinning_.points().spacing};
        const auto found = options_.method == EquilibriumMethod::rosso_krauth ? rosso_krauth(equation_, front, limits)
                                                                              : trust_region(equation_, front, limits);
        const double mean = front.mean();
        return {.drive = position,
                .position = mean,
                .roughness = std::sqrt((front - mean).square().mean()),
                .apparent_work = mean_work_ * (1.0 + restoring_ * (mean - position)),
                .residual = found.residual / mean_work_,
                .iterations = found.iterations,
                .converged = found.converged};
    }

private:
    StraightFrontOptions options_;
    double mean_work_, restoring_;
    PinningLines pinning_;
    LineElasticity elasticity_;
    StraightEquation equation_;

public:
    Array1D front;
};

StraightFront::StraightFront(const WorkField& field, const StraightFrontOptions& options)
    : work_(std::make_unique<Work>(field, options)) {}
StraightFront::~StraightFront() = default;
StraightFront::StraightFront(StraightFront&&) noexcept = default;
StraightFront& StraightFront::operator=(StraightFront&&) noexcept = default;

const Array1D& StraightFront::front() const { return work_->front; }
StraightFront::State StraightFront::drive_to(double position) { return work_->drive_to(position); }

FrontWorks straight_front_works(const WorkField& field, const StraightFrontOptions& options, double step) {
    if (!(step > 0.0)) throw InvalidArgument(fmt::format("steps of {} spacings; expected more than 0", step));
    StraightFront front(field, options);
    const double length = step * field.points.spacing;
    const double way = field.points.spacing * static_cast<double>(field.points.count);
    FrontWorks works{.converged = true};
    std::vector<double> approach, retraction;
    double drive = 0.0, position = 0.0;
    // the spring is stretched first: what counts is where the front is
    const auto go = [&](double direction, std::vector<double>& apparent) {
        drive += direction * length;
        const auto state = front.drive_to(drive);
        position = state.position;
        works.converged = works.converged && state.converged;
        if (direction * (position - 0.5 * way) > 0.0) apparent.push_back(state.apparent_work);
    };
    while (position < way) go(1.0, approach);
    while (position > 0.0) go(-1.0, retraction);
    const auto grown = mean_of_stretches(approach), receded = mean_of_stretches(retraction);
    works.approach = grown.value;
    works.approach_standard_error = grown.standard_error;
    works.retraction = receded.value;
    works.retraction_standard_error = receded.standard_error;
    return works;
}

}  // namespace setae::crack_front
