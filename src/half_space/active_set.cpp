// SPDX-License-Identifier: GPL-3.0-or-later
#include "active_set.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "setae/core/extent.hpp"

namespace setae::half_space {
namespace {

/// By how much a set's residual is to fall before the set is guessed anew, and after how many iterations at most.
constexpr double residual_reduction = 0.25;
constexpr Index most_per_set = 16;
/// A new set whose gap is not smaller than this times the last one's was guessed too boldly.
constexpr double progress_ratio = 0.7;
/// Sets without a new best gap before the solution counts as stuck.
constexpr Index patience = 100;
/// Rounding of displacements, relative to heights and to what the mean pressure does to the longest wave.
constexpr double rounding = 1e-13;

}  // namespace

ActiveSetSolver::ActiveSetSolver(ElasticOperator& response, const fourier::Multiplier& compliance,
                                 ElasticOperator& stiffness, const Array2D& heights, const Target& target,
                                 parallel::Threads threads)
    : response_(response),
      compliance_(compliance),
      preconditioner_(stiffness),
      stiffness_(stiffness.multiplier([least = stiffness.least_stiffness()](double k) {
          return k > 0.0 && std::isfinite(k) ? k : std::max(least, std::numeric_limits<double>::min());
      })),
      heights_(heights),
      target_(target),
      rows_(heights, threads),
      p_(heights.rows(), heights.cols()),
      v_(heights.rows(), heights.cols()),
      t_(Array2D::Zero(heights.rows(), heights.cols())),
      w_(heights.rows(), heights.cols()),
      set_(extent(heights.size()), 0),
      highest_(heights.abs().maxCoeff()) {}

/// p − step t between 0 and the hardness.
void ActiveSetSolver::cut_pressures(double step) {
    const double hardness = target_.hardness;
    rows_.each([&](Index i) {
        double* p = p_.data() + i * p_.cols();
        const double* t = t_.data() + i * p_.cols();
        for (Index j = 0; j < p_.cols(); ++j) p[j] = std::min(hardness, std::max(0.0, p[j] - step * t[j]));
    });
    if (target_.mean_pressure) carry_load();
}

/// Scales the pressures that do not flow until they carry the load.
void ActiveSetSolver::carry_load() {
    const double load = *target_.mean_pressure * static_cast<double>(p_.size()), hardness = target_.hardness;
    constexpr int most_rounds = 100;  // one is enough where nothing flows
    for (int round = 0; round < most_rounds; ++round) {
        const auto sums = rows_.numbers<3>([&](Index i) {
            double elastic = 0.0, flowing = 0.0, places = 0.0;
            for (Index j = 0; j < p_.cols(); ++j) {
                const double p = p_(i, j);
                (p < hardness ? elastic : flowing) += p;
                places += p < hardness ? 1.0 : 0.0;
            }
            return std::array{elastic, flowing, places};
        });
        const double elastic = sums.sum(0), rest = load - sums.sum(1);
        if (std::abs(rest - elastic) <= 1e-15 * load) return;
        const double factor = elastic > 0.0 ? rest / elastic : 1.0;
        const double share = elastic > 0.0 ? 0.0 : rest / std::max(1.0, sums.sum(2));
        rows_.each([&](Index i) {
            for (Index j = 0; j < p_.cols(); ++j)
                if (p_(i, j) < hardness) p_(i, j) = std::min(hardness, p_(i, j) * factor + share);
        });
        if (std::isinf(hardness)) return;
    }
}

/// v = G p − h, and what the certificate needs of it.
void ActiveSetSolver::respond() {
    const Index ny = p_.cols();
    RowSums<6> sums(p_.rows());
    response_.apply(
        compliance_, [&](Index i, double* line) { std::copy_n(p_.data() + i * ny, ny, line); },
        [&](Index i, const double* line) {
            const double *p = p_.data() + i * ny, *h = heights_.data() + i * ny;
            double* v = v_.data() + i * ny;
            double load = 0.0, work = 0.0, height_work = 0.0, contact = 0.0, points = 0.0;
            double least = std::numeric_limits<double>::infinity();
            for (Index j = 0; j < ny; ++j) {
                const double value = line[j] - h[j];
                const double elastic = p[j] > 0.0 && p[j] < target_.hardness ? 1.0 : 0.0;
                v[j] = value;
                load += p[j];
                work += p[j] * value;
                height_work += p[j] * h[j];
                contact += elastic * value;
                points += elastic;
                least = std::min(least, value);
            }
            sums.store(i, {load, work, height_work, contact, points, least});
        });
    ++pairs_;
    load_ = sums.sum(0);
    work_ = sums.sum(1);
    elastic_work_ = work_ + sums.sum(2);
    least_ = sums.least(5);
    if (!target_.mean_pressure) level_ = target_.level;
    else level_ = sums.sum(4) > 0.0 ? -sums.sum(3) / sums.sum(4) : -work_ / load_;
    certify();
}

void ActiveSetSolver::certify() {
    const double points = static_cast<double>(p_.size()), mean = load_ / points;
    certificate_ = {.penetration = std::max(0.0, -(least_ + level_))};
    if (target_.mean_pressure) certificate_.load_error = std::abs(mean / *target_.mean_pressure - 1.0);
    if (!(load_ > 0.0)) return;
    const double softest = std::max(preconditioner_.least_stiffness(), std::numeric_limits<double>::min());
    const double displacement = std::max(elastic_work_ / load_, rounding * (mean / softest + highest_));
    double excess = work_ - load_ * least_;
    if (std::isfinite(target_.hardness)) excess = work_ + load_ * level_ - target_.hardness * overlap_without_flow();
    certificate_.duality_gap = excess / (load_ * displacement);
    if (!target_.mean_pressure) certificate_.level_error = std::abs(work_ / load_ + level_) / displacement;
}

/// Σ min(g, 0), while the penetration is set to that of points that do not flow.
double ActiveSetSolver::overlap_without_flow() {
    const auto sums = rows_.numbers<2>([&](Index i) {
        double overlap = 0.0, least = 0.0;
        for (Index j = 0; j < p_.cols(); ++j) {
            const double g = std::min(0.0, v_(i, j) + level_);
            overlap += g;
            if (p_(i, j) < target_.hardness) least = std::min(least, g);
        }
        return std::array{overlap, least};
    });
    certificate_.penetration = -sums.least(1);
    return sums.sum(0);
}

/// Points pressed or, unless careful, overlapping; not those that flow and would have more.
ActiveSetSolver::Residual ActiveSetSolver::choose_set(bool careful) {
    const Index ny = p_.cols();
    const double hardness = target_.hardness;
    const auto sums = rows_.numbers<3>([&](Index i) {
        const double *p = p_.data() + i * ny, *v = v_.data() + i * ny;
        std::uint8_t* set = set_.data() + i * ny;
        double points = 0.0, sum = 0.0, square = 0.0;
        for (Index j = 0; j < ny; ++j) {
            const double g = v[j] + level_;
            const bool pressed = p[j] > 0.0 || (!careful && g < 0.0);
            const bool flows = p[j] >= hardness && (careful || g <= 0.0);
            const double inside = pressed && !flows ? 1.0 : 0.0;
            set[j] = pressed && !flows ? 1 : 0;
            points += inside;
            sum += inside * g;
            square += inside * g * g;
        }
        return std::array{points, sum, square};
    });
    Residual residual{.points = sums.sum(0), .level = level_, .square = sums.sum(2)};
    if (target_.mean_pressure && residual.points > 0.0) {
        const double mean = sums.sum(1) / residual.points;
        residual.level -= mean;
        residual.square = std::max(0.0, residual.square - residual.points * mean * mean);
    }
    return residual;
}

/// w = z, the preconditioned residual on the set, after what is left of the last step; sums of z and of w before.
ActiveSetSolver::Preconditioned ActiveSetSolver::precondition(double step, double level) {
    const Index ny = p_.cols();
    RowSums<3> sums(p_.rows());
    preconditioner_.apply(
        stiffness_,
        [&](Index i, double* line) {
            double *p = p_.data() + i * ny, *v = v_.data() + i * ny;
            const double *t = t_.data() + i * ny, *w = w_.data() + i * ny;
            const std::uint8_t* set = set_.data() + i * ny;
            if (step != 0.0)
                for (Index j = 0; j < ny; ++j) {
                    p[j] -= step * t[j];
                    v[j] -= step * w[j];
                }
            for (Index j = 0; j < ny; ++j) line[j] = set[j] != 0 ? v[j] + level : 0.0;
        },
        [&](Index i, const double* line) {
            double* w = w_.data() + i * ny;
            const std::uint8_t* set = set_.data() + i * ny;
            double sum = 0.0, coupling = 0.0, response = 0.0;
            for (Index j = 0; j < ny; ++j) {
                const double z = set[j] != 0 ? line[j] : 0.0;
                sum += z;
                coupling += z * w[j];
                response += set[j] != 0 ? w[j] : 0.0;
                w[j] = z;
            }
            sums.store(i, {sum, coupling, response});
        });
    ++pairs_;
    return {.sum = sums.sum(0), .coupling = sums.sum(1), .response = sums.sum(2)};
}

/// t = w − mean + memory t on the set, w = G t, and the sums of it.
ActiveSetSolver::Response ActiveSetSolver::respond_to_direction(double mean, double memory, double level) {
    const Index ny = p_.cols();
    RowSums<4> sums(p_.rows());
    RowSums<2> direction(p_.rows());
    response_.apply(
        compliance_,
        [&](Index i, double* line) {
            const double *w = w_.data() + i * ny, *v = v_.data() + i * ny;
            double* t = t_.data() + i * ny;
            const std::uint8_t* set = set_.data() + i * ny;
            double sum = 0.0, slope = 0.0;
            for (Index j = 0; j < ny; ++j) {
                const double value = set[j] != 0 ? w[j] - mean + memory * t[j] : 0.0;
                t[j] = value;
                line[j] = value;
                sum += value;
                slope += value * (v[j] + level);
            }
            direction.store(i, {sum, slope});
        },
        [&](Index i, const double* line) {
            const double *v = v_.data() + i * ny, *t = t_.data() + i * ny;
            double* w = w_.data() + i * ny;
            const std::uint8_t* set = set_.data() + i * ny;
            double work = 0.0, sum = 0.0, square = 0.0, product = 0.0;
            for (Index j = 0; j < ny; ++j) {
                const double value = line[j], inside = set[j] != 0 ? value : 0.0;
                w[j] = value;
                work += t[j] * value;
                sum += inside;
                square += inside * value;
                product += inside * (v[j] + level);
            }
            sums.store(i, {work, sum, square, product});
        });
    ++pairs_;
    return {.work = sums.sum(0),
            .sum = sums.sum(1),
            .square = sums.sum(2),
            .product = sums.sum(3),
            .direction = direction.sum(0),
            .slope = direction.sum(1)};
}

/// Conjugate gradients on the set; the last step is not taken but returned. The first direction is made conjugate to
/// the last one of the set before, of which most points are still there: a sixth fewer iterations than from anew.
double ActiveSetSolver::reduce_residual(const Residual& start, Index most, bool remembers) {
    if (!(start.square > 0.0)) {
        t_.setZero();
        curvature_ = 0.0;
        return 0.0;
    }
    const bool centred = target_.mean_pressure.has_value();
    if (!remembers || !(curvature_ > 0.0)) {
        curvature_ = 0.0;
        t_.setZero();
        w_.setZero();
    }
    double step = 0.0, level = start.level, square = start.square;
    for (Index iteration = 0; iteration < most; ++iteration) {
        const Preconditioned z = precondition(step, level);
        const double mean_z = centred ? z.sum / start.points : 0.0;
        const double memory = curvature_ > 0.0 ? (mean_z * z.response - z.coupling) / curvature_ : 0.0;
        const Response response = respond_to_direction(mean_z, memory, level);
        const double mean = centred ? response.sum / start.points : 0.0;
        curvature_ = response.work - mean * response.direction;
        ++iterations_;
        if (!(curvature_ > 0.0)) return 0.0;
        step = response.slope / curvature_;
        square += step * (step * (response.square - mean * response.sum) - 2.0 * response.product);
        level += step * mean;
        if (!(square > residual_reduction * residual_reduction * start.square)) break;
    }
    return step;
}

/// The step of steepest descent along the gaps of points pressed or overlapping: how far the careful mode presses
/// points that overlap.
double ActiveSetSolver::activation_step() {
    const Index ny = p_.cols();
    const auto gap = [&](Index i, Index j) {
        const double g = v_(i, j) + level_;
        return p_(i, j) > 0.0 || g < 0.0 ? g : 0.0;
    };
    RowSums<1> squares(p_.rows());
    const double curvature = response_.quadratic_form(compliance_, [&](Index i, double* line) {
        double square = 0.0;
        for (Index j = 0; j < ny; ++j) {
            line[j] = gap(i, j);
            square += line[j] * line[j];
        }
        squares.store(i, {square});
    });
    ++pairs_;
    return curvature > 0.0 ? squares.sum() / curvature : 0.0;
}

void ActiveSetSolver::activate(double step) {
    rows_.each([&](Index i) {
        for (Index j = 0; j < p_.cols(); ++j) {
            const double g = v_(i, j) + level_;
            const bool overlaps = p_(i, j) <= 0.0 && g < 0.0, recovers = p_(i, j) >= target_.hardness && g > 0.0;
            if (overlaps || recovers) t_(i, j) = step * g;
        }
    });
}

SolveStatus ActiveSetSolver::solve(double tolerance, Index most_iterations,
                                   const std::function<void(const SolveProgress&)>& report) {
    Index most = most_per_set, without_progress = 0;
    double last = std::numeric_limits<double>::infinity(), best = last, step = 0.0;
    while (true) {
        cut_pressures(step);
        respond();
        const bool apart = !(load_ > 0.0), overlaps = certificate_.penetration > 0.0;
        const double error = !apart     ? std::max(certificate_.duality_gap, certificate_.level_error)
                             : overlaps ? std::numeric_limits<double>::infinity()
                                        : 0.0;
        if (report) report({.nx = p_.rows(), .ny = p_.cols(), .iterations = iterations_, .duality_gap = error});
        if (error <= tolerance) return SolveStatus::converged;
        without_progress = error < best ? 0 : without_progress + 1;
        best = std::min(best, error);
        if (iterations_ >= most_iterations || without_progress > patience) return SolveStatus::not_converged;
        most = error > progress_ratio * last ? most / 2 : std::min(most_per_set, std::max<Index>(1, 2 * most));
        const bool remembers = error <= progress_ratio * last;
        last = error;
        const bool careful = most == 0;
        const Residual residual = choose_set(careful);
        const double activation = careful ? activation_step() : 0.0;
        if (careful) {
            step = reduce_residual(residual, 1, false);
            if (step != 0.0) t_ *= step;
            curvature_ = 0.0;
            activate(activation);
            step = 1.0;
        } else {
            step = reduce_residual(residual, most, remembers);
        }
    }
}

}  // namespace setae::half_space
