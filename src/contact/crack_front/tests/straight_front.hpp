// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include <fmt/format.h>

#include "front_equation.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/crack_front/circular_front.hpp"

namespace setae::crack_front {

/// A straight front, limit of a circle large against everything along it.
struct StraightFrontOptions {
    double width = 0.0;      ///< L_z [m], > 0: lines are width/lines apart
    double restoring = 0.0;  ///< q_κ [1/m] of the spring that drives it; 0: π/L_z, G_J'/G_J of a circle of 2πa = L_z
    EquilibriumMethod method = EquilibriumMethod::trust_region;
    double tolerance = 1e-9;      ///< of the largest |residual| over W
    int max_iterations = 100000;  ///< of one equilibrium
    double largest_move = 0.5;    ///< of a point in one step of the trust region, in spacings of the field
};

/// A front x(z) on parallels, which its spring pulls to x_d.
///
///   W q_κ (x_j − x_d) + W (K x)_j = w(x_j, z_j) − W,   K: x̃_q → |q| x̃_q
///
/// The apparent work of adhesion is what the spring leaves, W (1 + q_κ (⟨x⟩ − x_d)) = ⟨w⟩ along the front. The field
/// repeats itself in both directions.
/// Source: Gao, Rice, J. Appl. Mech. 56 (1989) 828 (first-order elasticity of a front).
class StraightFront {
public:
    /// @throws InvalidArgument for a field, width or spring outside its domain.
    StraightFront(const WorkField& field, const StraightFrontOptions& options);
    ~StraightFront();
    StraightFront(StraightFront&&) noexcept;
    StraightFront& operator=(StraightFront&&) noexcept;

    /// x(z_j) [m]; straight at 0 to begin with.
    [[nodiscard]] const Array1D& front() const;

    struct State {
        double drive = 0.0;          ///< x_d [m]
        double position = 0.0;       ///< ⟨x⟩ [m]
        double roughness = 0.0;      ///< rms of x − ⟨x⟩ [m]
        double apparent_work = 0.0;  ///< [J/m²]
        double residual = 0.0;       ///< largest, over W
        int iterations = 0;
        bool converged = false;
    };
    State drive_to(double position);

private:
    class Work;
    std::unique_ptr<Work> work_;
};

/// Works with which a straight front grows and recedes in steady motion.
struct FrontWorks {
    double approach = 0.0;                                                  ///< W_appr [J/m²]
    double retraction = 0.0;                                                ///< W_ret [J/m²]
    double approach_standard_error = 0.0, retraction_standard_error = 0.0;  ///< from eight stretches of the way [J/m²]
    bool converged = false;

    /// k of W_ret − W_appr = 2k U_el/A. @param stored_energy U_el/A [J/m²].
    [[nodiscard]] double pinning_coefficient(double stored_energy) const {
        return 0.5 * (retraction - approach) / stored_energy;
    }
};

namespace straight_front_detail {

inline Array2D works_of(const WorkField& field) {
    require(field);
    return field.works;
}

/// Mean over stretches of a way, and how the means of the stretches scatter.
struct StretchMean {
    double value = 0.0, standard_error = 0.0;
};

inline StretchMean mean_of_stretches(const std::vector<double>& values) {
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

}  // namespace straight_front_detail

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
          pinning_(straight_front_detail::works_of(field), field.points, true),
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
                                  .max_iterations = options_.max_iterations,
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

inline StraightFront::StraightFront(const WorkField& field, const StraightFrontOptions& options)
    : work_(std::make_unique<Work>(field, options)) {}
inline StraightFront::~StraightFront() = default;
inline StraightFront::StraightFront(StraightFront&&) noexcept = default;
inline StraightFront& StraightFront::operator=(StraightFront&&) noexcept = default;

inline const Array1D& StraightFront::front() const { return work_->front; }
inline StraightFront::State StraightFront::drive_to(double position) { return work_->drive_to(position); }

/// Drives a front over the field once and back, x_d in steps of `step` spacings, quasi-statically, and averages the
/// apparent work over the second half of the way of each.
/// @throws InvalidArgument as StraightFront does, and for a step that is not positive.
inline FrontWorks straight_front_works(const WorkField& field, const StraightFrontOptions& options, double step = 0.5) {
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
    const auto grown = straight_front_detail::mean_of_stretches(approach),
               receded = straight_front_detail::mean_of_stretches(retraction);
    works.approach = grown.value;
    works.approach_standard_error = grown.standard_error;
    works.retraction = receded.value;
    works.retraction_standard_error = receded.standard_error;
    return works;
}

}  // namespace setae::crack_front
