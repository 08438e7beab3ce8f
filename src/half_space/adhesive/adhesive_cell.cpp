// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/half_space/adhesive_cell.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "adhesive/face_model.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::half_space {
namespace {

const ArrayView2D& checked(const ArrayView2D& heights, const Grid& grid, const Body& body, const Interaction& law) {
    require(grid);
    require(body);
    require(law, body, grid);
    require_shape(heights, grid, "heights");
    if (!heights.isFinite().all())
        throw UndefinedDataError("heights of a cell are undefined at some points; fill them first");
    return heights;
}

constexpr double tangent_accuracy = 0.03;  ///< of the tension's change along it

}  // namespace

class AdhesiveCell::Work {
public:
    Work(const ArrayView2D& heights, const Grid& grid, const Body& body, const Interaction& law,
         const AdhesiveOptions& options, parallel::Threads threads)
        : law_(law),
          options_(options),
          elastic_(grid, body, Edges::periodic, threads),
          heights_(checked(heights, grid, body, law)),
          stiffness_(stiffness_of_waves(elastic_)),
          model_(heights_, elastic_, {law.greatest_tension(), law.range}, threads),
          rows_(heights_, threads),
          points_(static_cast<double>(heights_.size())),
          radius_(2.0 * law.range) {
        for (auto* place : {&here_, &trial_}) *place = {heights_, heights_, heights_, heights_, heights_};
        for (auto* map : {&gradient_, &step_, &stiff_step_, &tangent_, &stiff_tangent_})
            *map = Array2D::Zero(heights_.rows(), heights_.cols());
        face_ = MapOf<float>::Zero(heights_.rows(), heights_.cols());
        rigid_ = heights_;
        apply_stiffness(heights_, rigid_);
        conformal_energy_ =
            0.5 * rows_.sum([&](Index i) { return (row(heights_, i) * row(rigid_, i)).sum(); }) / points_;
    }

    void begin_at(double mean_gap) {
        const double mean_height = heights_.mean();
        here_.gaps = mean_gap - (heights_ - mean_height);
        move_to_mean(here_, mean_gap, 0.0);
        refresh();
        has_tangent_ = false;
    }

    void begin_with(const ArrayView2D& gaps) {
        require_shape(gaps, elastic_.grid(), "gaps");
        if (!(gaps >= 0.0).all()) throw InvalidArgument("gaps of a cell are below 0 or undefined; expected >= 0");
        here_.gaps = gaps;
        refresh();
        has_tangent_ = false;
    }

    AdhesiveState solve(const AdhesiveControl& control);
    Tangent find_tangent();
    void follow_tangent(double change);

    void keep() {
        kept_ = here_;
        kept_tangent_ = tangent_, kept_stiff_tangent_ = stiff_tangent_;
        kept_has_tangent_ = has_tangent_;
    }
    void restore() {
        here_ = kept_;
        tangent_ = kept_tangent_, stiff_tangent_ = kept_stiff_tangent_;
        has_tangent_ = kept_has_tangent_;
    }

    [[nodiscard]] const Grid& grid() const { return elastic_.grid(); }
    [[nodiscard]] const Interaction& interaction() const { return law_; }
    [[nodiscard]] const Array2D& gaps() const { return here_.gaps; }
    [[nodiscard]] Array2D pressures() const { return here_.stiff - tension_; }
    [[nodiscard]] double conformal_energy() const { return conformal_energy_; }
    [[nodiscard]] double felt_gap() const {
        const double reach = law_.law == AttractionLaw::dugdale ? 0.9 : 2.5;
        return heights_.maxCoeff() - heights_.mean() + reach * law_.range;
    }
    [[nodiscard]] double far_gap() const {
        const double reach = law_.law == AttractionLaw::lennard_jones ? 15.0 : 5.0;
        const double longest = std::max(grid().nx > 1 ? grid().size_x : 0.0, grid().ny > 1 ? grid().size_y : 0.0);
        return std::max(heights_.maxCoeff() - heights_.mean() + reach * law_.range,
                        1.4 * std::sqrt(law_.work_of_adhesion * longest / elastic_.body().contact_modulus));
    }

private:
    /// A state, and what follows from its gaps.
    struct Place {
        Array2D gaps;     ///< g
        Array2D stiff;    ///< K (g + h)
        Array2D energy;   ///< V
        Array2D tension;  ///< V'
        Array2D slope;    ///< V''
        double mean = 0.0;
    };

    [[nodiscard]] std::int64_t all_transforms() const { return transforms_ + model_.transforms(); }
    void apply_stiffness(const Array2D& from, Array2D& to) {
        elastic_.apply(
            stiffness_, [&](Index i, double* line) { Row(line, from.cols()) = row(from, i); },
            [&](Index i, const double* line) { row(to, i) = ConstRow(line, to.cols()); });
        ++transforms_;
    }
    /// Everything of the present gaps anew.
    void refresh() {
        apply_stiffness(here_.gaps, here_.stiff);
        here_.stiff += rigid_;
        attract(here_);
    }
    void attract_row(Place& place, Index i) const {
        attraction(place.gaps.cols(), row(place.gaps, i).data(), law_, row(place.energy, i).data(),
                   row(place.tension, i).data(), row(place.slope, i).data());
    }
    void attract(Place& place) {
        place.mean = rows_.sum([&](Index i) {
            attract_row(place, i);
            return row(place.gaps, i).sum();
        }) / points_;
    }
    /// Shifts gaps so that, cut at 0, their mean is as given; `shift` is about by how much.
    void move_to_mean(Place& place, double mean, double shift);
    /// From `from` to `trial_`, whose gaps are set: K of the difference, attraction, change of the energy.
    double energy_to_trial(bool stiff_known);

    [[nodiscard]] bool mean_held() const { return std::holds_alternative<HeldGap>(control_); }
    /// Φ' and Φ'' of what holds the mean: E + Φ(⟨g⟩) is lowered.
    [[nodiscard]] double control_tension(double mean) const {
        if (const auto* load = std::get_if<DeadLoad>(&control_)) return -load->tension;
        if (const auto* stage = std::get_if<Stage>(&control_)) return stage->stiffness * (mean - stage->position);
        return 0.0;
    }
    [[nodiscard]] double control_stiffness() const {
        const auto* stage = std::get_if<Stage>(&control_);
        return stage ? stage->stiffness : 0.0;
    }
    /// Change of Φ.
    [[nodiscard]] double control_energy(double from, double to) const {
        return 0.5 * (control_tension(from) + control_tension(to)) * (to - from);
    }

    /// Gradient, its value mu_ on free points, and how far the state is from equilibrium [Pa].
    double residual();
    bool gradient_step();
    bool newton_step(double residual);
    /// Steps until what is left is as wanted, there is none, or there were too many; what is left.
    double approach_equilibrium(double left, double wanted, int& iterations);
    void take_trial() { std::swap(here_, trial_); }
    AdhesiveState state(double residual, int iterations, std::int64_t transforms);

    Interaction law_;
    AdhesiveOptions options_;
    ElasticOperator elastic_;
    Array2D heights_, rigid_;
    fourier::Multiplier stiffness_;
    FaceModel model_;
    std::int64_t transforms_ = 0;  ///< of its own
    RowPasses rows_;
    double points_, radius_;
    double conformal_energy_ = 0.0, multiplier_ = 0.0, tension_ = 0.0;
    AdhesiveControl control_;
    Place here_, trial_, kept_;
    Array2D gradient_, step_, stiff_step_;
    MapOf<float> face_;
    Array2D tangent_, stiff_tangent_, kept_tangent_, kept_stiff_tangent_;
    bool has_tangent_ = false, kept_has_tangent_ = false;
};

void AdhesiveCell::Work::move_to_mean(Place& place, double mean, double shift) {
    if (mean == 0.0) return void(place.gaps.setZero());
    // Newton on a convex function, piecewise linear: from the right it falls onto the root
    const double close = 1e-14 * std::max(mean, law_.range);
    for (int round = 0; round < 100; ++round) {
        const auto sums = rows_.numbers<2>([&](Index i) {
            const auto g = row(place.gaps, i);
            return std::array{(g + shift).max(0.0).sum(), static_cast<double>((g > -shift).count())};
        });
        const double excess = sums.sum(0) / points_ - mean, count = sums.sum(1);
        if (std::abs(excess) <= close) break;
        shift = count > 0.0 ? shift - excess * points_ / count : shift - excess;
    }
    rows_.each([&](Index i) { row(place.gaps, i) = (row(place.gaps, i) + shift).max(0.0); });
}

double AdhesiveCell::Work::residual() {
    const double of_control = control_tension(here_.mean);
    const auto numbers = rows_.numbers<3>([&](Index i) {
        auto G = row(gradient_, i);
        G = row(here_.stiff, i) + row(here_.tension, i) + of_control;
        const auto g = row(here_.gaps, i);
        double sum = 0.0, count = 0.0;
        for (Index j = 0; j < g.size(); ++j) {
            const double free = g[j] > 0.0 ? 1.0 : 0.0;
            sum += free * G[j];
            count += free;
        }
        return std::array{sum, count, G.minCoeff()};
    });
    const double free = numbers.sum(1);
    multiplier_ = !mean_held() ? 0.0 : free > 0.0 ? numbers.sum(0) / free : numbers.least(2);
    const double stiffest = elastic_.greatest_stiffness();
    return rows_.largest(
        [&](Index i) { return (row(gradient_, i) - multiplier_).min(stiffest * row(here_.gaps, i)).abs().maxCoeff(); });
}

double AdhesiveCell::Work::energy_to_trial(bool stiff_known) {
    RowSums<2> sums(here_.gaps.rows());
    const auto compare = [&](Index i) {
        attract_row(trial_, i);
        const auto g = row(trial_.gaps, i);
        sums.store(i, {(0.5 * (g - row(here_.gaps, i)) * (row(trial_.stiff, i) + row(here_.stiff, i)) +
                        (row(trial_.energy, i) - row(here_.energy, i)))
                           .sum(),
                       g.sum()});
    };
    if (stiff_known) {
        rows_.each(compare);
    } else {
        elastic_.apply(
            stiffness_,
            [&](Index i, double* line) { Row(line, here_.gaps.cols()) = row(trial_.gaps, i) - row(here_.gaps, i); },
            [&](Index i, const double* line) {
                row(trial_.stiff, i) = row(here_.stiff, i) + ConstRow(line, here_.gaps.cols());
                compare(i);
            });
        ++transforms_;
    }
    trial_.mean = sums.sum(1) / points_;
    return sums.sum(0) / points_ + control_energy(here_.mean, trial_.mean);
}

bool AdhesiveCell::Work::gradient_step() {
    const double length = 1.0 / (elastic_.greatest_stiffness() + control_stiffness());
    rows_.each([&](Index i) { row(trial_.gaps, i) = row(here_.gaps, i) - length * row(gradient_, i); });
    if (mean_held()) move_to_mean(trial_, here_.mean, length * multiplier_);
    else rows_.each([&](Index i) { row(trial_.gaps, i) = row(trial_.gaps, i).max(0.0); });
    const bool lower = energy_to_trial(false) <= 1e-14 * law_.work_of_adhesion;
    if (lower) take_trial();
    return lower;
}

bool AdhesiveCell::Work::newton_step(double residual) {
    const auto sums = rows_.numbers<2>([&](Index i) {
        auto face = row(face_, i);
        face = (row(here_.gaps, i) > 0.0 || row(gradient_, i) < multiplier_).cast<float>();
        return std::array{static_cast<double>(face.sum()),
                          (face.cast<double>() * (row(gradient_, i) - multiplier_)).square().sum()};
    });
    const double forcing = std::min(0.1, std::sqrt(residual / law_.greatest_tension()));
    const double tolerance = forcing * std::sqrt(sums.sum(1) / std::max(1.0, sums.sum(0)));
    const auto outcome = model_.minimise({.gradient = gradient_,
                                          .slopes = here_.slope,
                                          .face = face_,
                                          .mean_held = mean_held(),
                                          .control_stiffness = control_stiffness(),
                                          .radius = radius_,
                                          .tolerance = tolerance},
                                         step_, stiff_step_);
    double length = 1.0;
    for (int attempt = 0; attempt < 7; ++attempt, length *= 0.3) {
        const double least = -rows_.largest([&](Index i) {
            auto g = row(trial_.gaps, i);
            g = row(here_.gaps, i) + length * row(step_, i);
            return -g.minCoeff();
        });
        const bool cut = least < 0.0;
        if (!cut) {
            rows_.each([&](Index i) { row(trial_.stiff, i) = row(here_.stiff, i) + length * row(stiff_step_, i); });
        } else if (mean_held()) {
            move_to_mean(trial_, here_.mean, 0.0);
        } else {
            rows_.each([&](Index i) { row(trial_.gaps, i) = row(trial_.gaps, i).max(0.0); });
        }
        if (energy_to_trial(!cut) <= 1e-14 * law_.work_of_adhesion) {
            take_trial();
            if (attempt == 0 && (outcome.at_radius || outcome.curves_down))
                radius_ = std::min(2.0 * radius_, 8.0 * law_.range);
            return true;
        }
        radius_ = std::max(0.3 * radius_, 1e-3 * law_.range);
    }
    return false;
}

AdhesiveState AdhesiveCell::Work::state(double residual, int iterations, std::int64_t transforms) {
    AdhesiveState result{.mean_gap = here_.mean,
                         .tension = multiplier_,
                         .residual = residual / law_.greatest_tension(),
                         .iterations = iterations,
                         .transforms = transforms};
    if (const auto* held = std::get_if<HeldGap>(&control_)) result.mean_gap = held->mean_gap;
    if (const auto* load = std::get_if<DeadLoad>(&control_)) result.tension = load->tension;
    if (std::holds_alternative<Stage>(control_)) result.tension = -control_tension(here_.mean);
    tension_ = result.tension;
    result.converged = result.residual <= options_.tolerance;
    result.elastic_energy = 0.5 * rows_.sum([&](Index i) {
        return ((row(here_.gaps, i) + row(heights_, i)) * row(here_.stiff, i)).sum();
    }) / points_;
    result.adhesive_energy = rows_.sum([&](Index i) { return row(here_.energy, i).sum(); }) / points_;
    result.area_fraction =
        rows_.sum([&](Index i) { return static_cast<double>((row(here_.gaps, i) == 0.0).count()); }) / points_;
    return result;
}

double AdhesiveCell::Work::approach_equilibrium(double left, double wanted, int& iterations) {
    while (left > wanted && iterations < options_.most_iterations) {
        ++iterations;
        bool moved = gradient_step();
        if (moved) left = residual();
        if (left <= wanted) break;
        moved = newton_step(left) || moved;
        if (!moved) break;
        left = residual();
    }
    return left;
}

AdhesiveState AdhesiveCell::Work::solve(const AdhesiveControl& control) {
    const auto transforms = all_transforms();
    control_ = control;
    if (const auto* held = std::get_if<HeldGap>(&control)) {
        if (!(held->mean_gap >= 0.0))
            throw InvalidArgument(fmt::format("mean gap is {} m, expected >= 0", held->mean_gap));
        if (std::abs(here_.mean - held->mean_gap) > 1e-14 * std::max(here_.mean, law_.range))
            move_to_mean(here_, held->mean_gap, held->mean_gap - here_.mean);
    }
    if (const auto* stage = std::get_if<Stage>(&control); stage && !(stage->stiffness > 0.0))
        throw InvalidArgument(fmt::format("stiffness of the stage is {} Pa/m, expected > 0", stage->stiffness));
    refresh();
    radius_ = 2.0 * law_.range;
    const double wanted = options_.tolerance * law_.greatest_tension();
    double left = residual();
    int iterations = 0, before = -1;
    // Newton steps leave stresses the rounding of float: equilibrium is what it is with stresses found anew
    while (left > wanted && iterations < options_.most_iterations && iterations > before) {
        before = iterations;
        left = approach_equilibrium(left, wanted, iterations);
        refresh();
        left = residual();
    }
    return state(left, iterations, all_transforms() - transforms);
}

AdhesiveCell::Tangent AdhesiveCell::Work::find_tangent() {
    const double free = rows_.sum([&](Index i) {
        row(face_, i) = (row(here_.gaps, i) > 0.0).cast<float>();
        return static_cast<double>(row(face_, i).sum());
    });
    const bool warm = has_tangent_;
    has_tangent_ = false;
    if (free == 0.0) return {.largest = points_};
    double sum =
        warm ? rows_.sum([&](Index i) { return (row(tangent_, i) * row(face_, i).cast<double>()).sum(); }) : 0.0;
    const bool start_warm = sum > 0.5 * points_;
    rows_.each([&](Index i) {
        const auto face = row(face_, i).cast<double>();
        if (start_warm) row(tangent_, i) *= face * (points_ / sum);
        else row(tangent_, i) = face * (points_ / free);
    });
    apply_stiffness(tangent_, stiff_tangent_);
    // of a mean gap that changes by ρ
    rows_.each([&](Index i) {
        row(gradient_, i) = law_.range * (row(stiff_tangent_, i) + row(here_.slope, i) * row(tangent_, i));
    });
    // V'' is 0 of constant tension: what the longest wave answers is the least that counts
    const double least = elastic_.least_stiffness();
    const double power = rows_.sum(
        [&](Index i) { return ((row(here_.slope, i).square() + least * least) * row(tangent_, i).square()).sum(); });
    const auto outcome = model_.minimise({.gradient = gradient_,
                                          .slopes = here_.slope,
                                          .face = face_,
                                          .radius = std::numeric_limits<double>::infinity(),
                                          .tolerance = tangent_accuracy * law_.range * std::sqrt(power / free)},
                                         step_, stiff_step_);
    if (outcome.curves_down) return {.largest = points_ / free};
    rows_.each([&](Index i) {
        row(tangent_, i) += row(step_, i) / law_.range;
        row(stiff_tangent_, i) += row(stiff_step_, i) / law_.range;
    });
    has_tangent_ = true;
    Tangent result{.stable = true};
    result.largest = rows_.largest([&](Index i) { return row(tangent_, i).abs().maxCoeff(); });
    result.tension_slope = rows_.sum([&](Index i) {
        return (row(tangent_, i) * (row(stiff_tangent_, i) + row(here_.slope, i) * row(tangent_, i))).sum();
    }) / points_;
    return result;
}

void AdhesiveCell::Work::follow_tangent(double change) {
    const double mean = std::max(0.0, here_.mean + change);
    if (has_tangent_) {
        here_.gaps += change * tangent_;
    } else if ((here_.gaps > 0.0).any()) {
        here_.gaps = (here_.gaps > 0.0).select(here_.gaps + change, 0.0);
    } else {
        // out of full contact the least pressed points open
        here_.gaps -= (here_.stiff + here_.tension) / elastic_.greatest_stiffness();
    }
    move_to_mean(here_, mean, 0.0);
    here_.mean = mean;
}

AdhesiveCell::AdhesiveCell(const ArrayView2D& heights, const Grid& grid, const Body& body,
                           const Interaction& interaction, const AdhesiveOptions& options, parallel::Threads threads)
    : work_(std::make_unique<Work>(heights, grid, body, interaction, options, threads)) {
    begin_at(far_gap());
}
AdhesiveCell::~AdhesiveCell() = default;
AdhesiveCell::AdhesiveCell(AdhesiveCell&&) noexcept = default;
AdhesiveCell& AdhesiveCell::operator=(AdhesiveCell&&) noexcept = default;

const Grid& AdhesiveCell::grid() const { return work_->grid(); }
const Interaction& AdhesiveCell::interaction() const { return work_->interaction(); }
const Array2D& AdhesiveCell::gaps() const { return work_->gaps(); }
Array2D AdhesiveCell::pressures() const { return work_->pressures(); }
double AdhesiveCell::felt_gap() const { return work_->felt_gap(); }
double AdhesiveCell::conformal_energy() const { return work_->conformal_energy(); }
double AdhesiveCell::far_gap() const { return work_->far_gap(); }
void AdhesiveCell::begin_at(double mean_gap) { work_->begin_at(mean_gap); }
void AdhesiveCell::begin_with(const ArrayView2D& gaps) { work_->begin_with(gaps); }
AdhesiveState AdhesiveCell::solve(const AdhesiveControl& control) { return work_->solve(control); }
AdhesiveCell::Tangent AdhesiveCell::find_tangent() { return work_->find_tangent(); }
void AdhesiveCell::follow_tangent(double mean_gap_change) { work_->follow_tangent(mean_gap_change); }
void AdhesiveCell::keep() { work_->keep(); }
void AdhesiveCell::restore() { work_->restore(); }

AdhesiveState from_far(AdhesiveCell& cell, const AdhesiveControl& control) {
    const auto* held = std::get_if<HeldGap>(&control);
    cell.begin_at(held ? std::max(held->mean_gap, cell.felt_gap()) : cell.felt_gap());
    return cell.solve(control);
}

}  // namespace setae::half_space
