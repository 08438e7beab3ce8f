// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/half_space/adhesive_cell.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "adhesive/face_model.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/summation.hpp"
#include "setae/core/units.hpp"

namespace setae::half_space {
namespace {

const ArrayView2D& checked(const ArrayView2D& heights, const ElasticOperator& elastic, const Interaction& law) {
    require(law, elastic.body(), elastic.grid());
    require_shape(heights, elastic.grid(), elastic.slab(), "heights");
    if (elastic.slab().anywhere(!heights.isFinite().all()))
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
          elastic_(grid, body, Edges::periodic, threads, options.ranks),
          heights_(checked(heights, elastic_, law)),
          stiffness_(stiffness_of_waves(elastic_)),
          units_{.length = law.range, .pressure = law.greatest_tension()},
          model_(heights_, elastic_, units_, threads),
          rows_(elastic_.slab(), heights_.cols(), threads),
          points_(rows_.points()),
          mean_height_(rows_.sum([&](Index i) { return row(heights_, i).sum(); }) / points_),
          highest_(rows_.largest([&](Index i) { return row(heights_, i).maxCoeff(); })),
          radius_(2.0 * law.range) {
        face_ = MapOf<float>::Zero(heights_.rows(), heights_.cols());
        for (auto* place : {&here_, &trial_}) *place = {heights_, heights_, heights_, face_, heights_.col(0), 0.0, {}};
        for (auto* map : {&tangent_, &stiff_tangent_}) *map = Array2D::Zero(heights_.rows(), heights_.cols());
        rigid_ = heights_;
        apply_stiffness(heights_, rigid_);
        conformal_energy_ =
            0.5 * rows_.sum([&](Index i) { return (row(heights_, i) * row(rigid_, i)).sum(); }) / points_;
    }

    void begin_at(double mean_gap) {
        here_.gaps = mean_gap - (heights_ - mean_height_);
        move_to_mean(here_, mean_gap, 0.0);
        refresh();
        has_tangent_ = false;
    }

    void begin_with(const ArrayView2D& gaps) {
        require_shape(gaps, elastic_.grid(), elastic_.slab(), "gaps");
        if (elastic_.slab().anywhere(!(gaps >= 0.0).all()))
            throw InvalidArgument("gaps of a cell are below 0 or undefined; expected >= 0");
        here_.gaps = gaps;
        refresh();
        has_tangent_ = false;
    }

    AdhesiveState solve(const AdhesiveControl& control);
    Tangent find_tangent();
    void follow_tangent(double change);

    void keep() {
        kept_ = here_;
        kept_tangent_ = tangent_;
        kept_stiff_tangent_ = stiff_tangent_;
        kept_has_tangent_ = has_tangent_;
    }
    void restore() {
        here_ = kept_;
        tangent_ = kept_tangent_;
        stiff_tangent_ = kept_stiff_tangent_;
        has_tangent_ = kept_has_tangent_;
    }

    [[nodiscard]] const Grid& grid() const { return elastic_.grid(); }
    [[nodiscard]] const parallel::Slab& slab() const { return elastic_.slab(); }
    [[nodiscard]] const Interaction& interaction() const { return law_; }
    [[nodiscard]] const Array2D& gaps() const { return here_.gaps; }
    [[nodiscard]] Array2D pressures() const { return here_.stiff - tension_; }
    [[nodiscard]] double conformal_energy() const { return conformal_energy_; }
    [[nodiscard]] double touching_gap() const { return highest_ - mean_height_; }
    /// 1/k(0): compliance of the mean of the body, zero where it is blocked or not included [m/Pa].
    [[nodiscard]] double mean_compliance() const {
        return elastic_.mean_displacement() == MeanDisplacement::finite
                   ? 1.0 / half_space::stiffness(0.0, elastic_.body())
                   : 0.0;
    }
    [[nodiscard]] AdhesiveControl displaced(double displacement, std::optional<double> stage_stiffness) const {
        if (stage_stiffness && !(*stage_stiffness > 0.0))
            throw InvalidArgument(fmt::format("stiffness of the stage is {} Pa/m; expected > 0", *stage_stiffness));
        const double gap = touching_gap() - displacement,
                     compliance = mean_compliance() + (stage_stiffness ? 1.0 / *stage_stiffness : 0.0);
        if (compliance > 0.0) return Stage{.position = gap, .stiffness = 1.0 / compliance};
        if (!(gap >= 0.0))
            throw InvalidArgument(fmt::format("a displacement of {} is beyond full contact; expected less than {}",
                                              format_value(displacement, "m"), format_value(touching_gap(), "m")));
        return HeldGap{gap};
    }
    [[nodiscard]] double displacement(const AdhesiveState& state) const {
        return touching_gap() - state.mean_gap - state.tension * mean_compliance();
    }
    [[nodiscard]] double felt_gap() const {
        const double reach = law_.law == AttractionLaw::dugdale ? 0.9 : 2.5;
        return touching_gap() + reach * law_.range;
    }
    [[nodiscard]] double far_gap() const {
        const double reach = law_.law == AttractionLaw::lennard_jones ? 15.0 : 5.0;
        const double longest = std::max(grid().nx > 1 ? grid().size_x : 0.0, grid().ny > 1 ? grid().size_y : 0.0);
        return std::max(touching_gap() + reach * law_.range,
                        1.4 * std::sqrt(law_.work_of_adhesion * longest / elastic_.body().contact_modulus));
    }

private:
    /// A state, and quantities computed from its gaps.
    struct Place {
        Array2D gaps;        ///< g
        Array2D stiff;       ///< K (g + h)
        Array2D gradient;    ///< K (g + h) + V'
        MapOf<float> slope;  ///< V'' in the model's units
        Array1D energy;      ///< Σ V of each row
        double mean = 0.0;   ///< mean of g
        /// For the gradient at free gaps: its sum and number; its smallest value anywhere.
        struct {
            double sum = 0.0, count = 0.0, least = 0.0;
        } free;
    };

    [[nodiscard]] std::int64_t all_transforms() const { return transforms_ + model_.transforms(); }
    void apply_stiffness(const Array2D& from, Array2D& to) {
        elastic_.apply(
            stiffness_, [&](Index i, double* line) { Row(line, from.cols()) = row(from, i); },
            [&](Index i, const double* line) { row(to, i) = ConstRow(line, to.cols()); });
        ++transforms_;
    }
    /// Computes all quantities of the present gaps again.
    void refresh() {
        apply_stiffness(here_.gaps, here_.stiff);
        here_.stiff += rigid_;
        take_sums(here_, rows_.numbers<4>([&](Index i) { return sum_up(here_, i); }));
    }
    void attract_row(Place& place, Index i) const {
        place.energy[i] = attraction(place.gaps.cols(), row(place.gaps, i).data(), law_, row(place.gradient, i).data(),
                                     row(place.slope, i).data(), units_.pressure / units_.length);
    }
    /// V'' d of a row [Pa], d in m.
    [[nodiscard]] auto sloped(Index i, const auto& d) const {
        return (units_.pressure / units_.length) * row(here_.slope, i).template cast<double>() * d;
    }
    /// The gradient of a row from its gaps and stresses, and the sums for take_sums().
    std::array<double, 4> sum_up(Place& place, Index i) const {
        attract_row(place, i);
        const auto g = row(place.gaps, i);
        auto G = row(place.gradient, i);
        G += row(place.stiff, i);
        const auto free = above_zero(g);
        return {g.sum(), (free * G).sum(), free.sum(), G.minCoeff()};
    }
    void take_sums(Place& place, const RowSums<4>& sums) const {
        place.mean = sums.sum(0) / points_;
        place.free = {.sum = sums.sum(1), .count = sums.sum(2), .least = sums.least(3)};
    }
    /// Gaps above a level: Σ max(g, 0), and their number.
    static std::array<double, 2> above(const auto& gaps) { return {gaps.max(0.0).sum(), above_zero(gaps).sum()}; }
    /// Shifts gaps so that, cut at 0, they have the given mean; `shift` is the approximate shift, `shifted` the sums
    /// above 0 after it.
    void move_to_mean(Place& place, double mean, double shift, std::array<double, 2> shifted);
    void move_to_mean(Place& place, double mean, double shift) {
        const auto sums = rows_.numbers<2>([&](Index i) { return above(row(place.gaps, i) + shift); });
        move_to_mean(place, mean, shift, {sums.sum(0), sums.sum(1)});
    }
    /// Cuts the gaps of `trial_` at 0, with the mean where it is fixed; `over`: sums above 0.
    void cut_trial(std::array<double, 2> over) {
        if (mean_held()) move_to_mean(trial_, here_.mean, 0.0, over);
        else rows_.each([&](Index i) { row(trial_.gaps, i) = row(trial_.gaps, i).max(0.0); });
    }
    /// From here to `trial_`, whose gaps are set: K of the difference, attraction, change of the energy.
    double energy_to_trial(bool stiff_known);

    [[nodiscard]] bool mean_held() const { return std::holds_alternative<HeldGap>(control_); }
    /// Φ' and Φ'' of the control of the mean: E + Φ(⟨g⟩) is lowered.
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

    /// Level of the gradient, face, and how far the state is from equilibrium [Pa].
    double residual();
    bool gradient_step();
    bool newton_step(double residual);
    /// Steps until the remainder is as requested, or no step is possible, or the limit is reached; returns the
    /// remainder.
    double approach_equilibrium(double left, double wanted, int& iterations);
    void take_trial() { std::swap(here_, trial_); }
    AdhesiveState state(double residual, int iterations, std::int64_t transforms);

    Interaction law_;
    AdhesiveOptions options_;
    ElasticOperator elastic_;
    Array2D heights_, rigid_;
    fourier::Multiplier stiffness_;
    ModelUnits units_;
    FaceModel model_;
    std::int64_t transforms_ = 0;  ///< number of own transforms
    RowPasses rows_;
    double points_, mean_height_, highest_, radius_;
    double conformal_energy_ = 0.0, multiplier_ = 0.0, tension_ = 0.0;
    double level_ = 0.0;  ///< that the gradient is at where free, in equilibrium
    /// For points that are free or would become so: their number, and for the gradient minus its level the sum and that
    /// of squares.
    struct {
        double count = 0.0, gradient = 0.0, square = 0.0;
    } in_face_;
    AdhesiveControl control_;
    Place here_, trial_, kept_;
    MapOf<float> face_;
    Array2D tangent_, stiff_tangent_, kept_tangent_, kept_stiff_tangent_;
    bool has_tangent_ = false, kept_has_tangent_ = false;
};

void AdhesiveCell::Work::move_to_mean(Place& place, double mean, double shift, std::array<double, 2> shifted) {
    if (mean == 0.0) return void(place.gaps.setZero());
    // Newton on a convex function, piecewise linear: from the right it falls onto the root
    const double close = 1e-14 * std::max(mean, law_.range);
    for (int round = 0; round < 100; ++round) {
        const double excess = shifted[0] / points_ - mean, count = shifted[1];
        if (std::abs(excess) <= close) break;
        shift = count > 0.0 ? shift - excess * points_ / count : shift - excess;
        const auto sums = rows_.numbers<2>([&](Index i) { return above(row(place.gaps, i) + shift); });
        shifted = {sums.sum(0), sums.sum(1)};
    }
    rows_.each([&](Index i) { row(place.gaps, i) = (row(place.gaps, i) + shift).max(0.0); });
}

double AdhesiveCell::Work::residual() {
    const auto& free = here_.free;
    const double of_control = control_tension(here_.mean);
    multiplier_ = !mean_held() ? 0.0 : free.count > 0.0 ? free.sum / free.count : free.least;
    level_ = multiplier_ - of_control;
    const double stiffest = elastic_.greatest_stiffness();
    const auto numbers = rows_.numbers<4>([&](Index i) {
        const auto g = row(here_.gaps, i);
        const auto G = row(here_.gradient, i) - level_;
        auto face = row(face_, i);
        face = (above_zero(g) + above_zero(-G)).min(1.0).cast<float>();
        const auto in_face = face.cast<double>();
        return std::array{G.min(stiffest * g).abs().maxCoeff(), in_face.sum(), (in_face * G).sum(),
                          (in_face * G).square().sum()};
    });
    in_face_ = {.count = numbers.sum(1), .gradient = numbers.sum(2), .square = numbers.sum(3)};
    return numbers.largest(0);
}

double AdhesiveCell::Work::energy_to_trial(bool stiff_known) {
    auto sums = rows_.sums<4>();
    auto energies = rows_.sums<1>();
    const auto compare = [&](Index i) {
        sums.store(i, sum_up(trial_, i));
        const double elastic =
            0.5 * ((row(trial_.gaps, i) - row(here_.gaps, i)) * (row(trial_.stiff, i) + row(here_.stiff, i))).sum();
        energies.store(i, {elastic + (trial_.energy[i] - here_.energy[i])});
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
    take_sums(trial_, sums);
    return energies.sum() / points_ + control_energy(here_.mean, trial_.mean);
}

bool AdhesiveCell::Work::gradient_step() {
    const double length = 1.0 / (elastic_.greatest_stiffness() + control_stiffness());
    const auto sums = rows_.numbers<2>([&](Index i) {
        auto g = row(trial_.gaps, i);
        g = row(here_.gaps, i) - length * (row(here_.gradient, i) - level_);
        return above(g);
    });
    cut_trial({sums.sum(0), sums.sum(1)});
    const bool lower = energy_to_trial(false) <= 1e-14 * law_.work_of_adhesion;
    if (lower) take_trial();
    return lower;
}

bool AdhesiveCell::Work::newton_step(double residual) {
    const double forcing = std::min(0.1, std::sqrt(residual / law_.greatest_tension()));
    const auto outcome = model_.minimise(
        {.gradient = here_.gradient,
         .level = mean_held() && in_face_.count > 0.0 ? level_ + in_face_.gradient / in_face_.count : level_,
         .slopes = here_.slope,
         .face = face_,
         .points = in_face_.count,
         .mean_held = mean_held(),
         .control_stiffness = control_stiffness(),
         .radius = radius_,
         .tolerance = forcing * std::sqrt(in_face_.square / std::max(1.0, in_face_.count))});
    double length = 1.0;
    for (int attempt = 0; attempt < 7; ++attempt, length *= 0.3) {
        const auto sums = rows_.numbers<3>([&](Index i) {
            auto g = row(trial_.gaps, i);
            g = row(here_.gaps, i) + length * model_.step(i);
            const auto over = above(g);
            return std::array{over[0], over[1], g.minCoeff()};
        });
        const bool cut = sums.least(2) < 0.0;
        if (!cut) {
            rows_.each([&](Index i) { row(trial_.stiff, i) = row(here_.stiff, i) + length * model_.stiff_step(i); });
        } else {
            cut_trial({sums.sum(0), sums.sum(1)});
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
    result.adhesive_energy = rows_.sum([&](Index i) { return here_.energy[i]; }) / points_;
    result.area_fraction =
        rows_.sum([&](Index i) { return static_cast<double>((row(here_.gaps, i) == 0.0).count()); }) / points_;
    return result;
}

double AdhesiveCell::Work::approach_equilibrium(double left, double wanted, int& iterations) {
    if (left > wanted && gradient_step()) {  // adds and removes contact of many points
        ++iterations;
        left = residual();
    }
    while (left > wanted && iterations < options_.max_iterations) {
        ++iterations;
        if (!newton_step(left) && !gradient_step()) break;
        left = residual();
    }
    return left;
}

AdhesiveState AdhesiveCell::Work::solve(const AdhesiveControl& control) {
    const auto transforms = all_transforms();
    control_ = control;
    if (const auto* held = std::get_if<HeldGap>(&control)) {
        if (!(held->mean_gap >= 0.0))
            throw InvalidArgument(fmt::format("mean gap is {} m; expected >= 0", held->mean_gap));
        if (std::abs(here_.mean - held->mean_gap) > 1e-14 * std::max(here_.mean, law_.range))
            move_to_mean(here_, held->mean_gap, held->mean_gap - here_.mean);
    }
    if (const auto* stage = std::get_if<Stage>(&control); stage && !(stage->stiffness > 0.0))
        throw InvalidArgument(fmt::format("stiffness of the stage is {} Pa/m; expected > 0", stage->stiffness));
    refresh();
    radius_ = 2.0 * law_.range;
    const double wanted = options_.tolerance * law_.greatest_tension();
    double left = residual();
    int iterations = 0, before = -1;
    // Newton steps leave rounding errors of float in stresses: equilibrium is tested with newly computed stresses
    while (left > wanted && iterations < options_.max_iterations && iterations > before) {
        before = iterations;
        left = approach_equilibrium(left, wanted, iterations);
        refresh();
        left = residual();
    }
    return state(left, iterations, all_transforms() - transforms);
}

AdhesiveCell::Tangent AdhesiveCell::Work::find_tangent() {
    const double free = rows_.sum([&](Index i) {
        row(face_, i) = above_zero(row(here_.gaps, i)).cast<float>();
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
    // for a mean gap that changes by ρ. V'' is 0 for constant tension: the response of the longest wave is the lower
    // limit
    const double least = elastic_.min_stiffness();
    const auto sums = rows_.numbers<2>([&](Index i) {
        auto G = row(trial_.gradient, i);
        const auto t = row(tangent_, i);
        G = law_.range * (row(stiff_tangent_, i) + sloped(i, t));
        return std::array{(row(face_, i).cast<double>() * G).sum(),
                          (sloped(i, t).square() + least * least * t.square()).sum()};
    });
    const auto outcome = model_.minimise({.gradient = trial_.gradient,
                                          .level = sums.sum(0) / free,
                                          .slopes = here_.slope,
                                          .face = face_,
                                          .points = free,
                                          .radius = std::numeric_limits<double>::infinity(),
                                          .tolerance = tangent_accuracy * law_.range * std::sqrt(sums.sum(1) / free)});
    if (outcome.curves_down) return {.largest = points_ / free};
    rows_.each([&](Index i) {
        row(tangent_, i) += model_.step(i) / law_.range;
        row(stiff_tangent_, i) += model_.stiff_step(i) / law_.range;
    });
    has_tangent_ = true;
    Tangent result{.stable = true};
    result.largest = rows_.largest([&](Index i) { return row(tangent_, i).abs().maxCoeff(); });
    result.tension_slope = rows_.sum([&](Index i) {
        return (row(tangent_, i) * (row(stiff_tangent_, i) + sloped(i, row(tangent_, i)))).sum();
    }) / points_;
    return result;
}

void AdhesiveCell::Work::follow_tangent(double change) {
    const double mean = std::max(0.0, here_.mean + change);
    if (has_tangent_) {
        here_.gaps += change * tangent_;
    } else if (elastic_.slab().anywhere((here_.gaps > 0.0).any())) {
        here_.gaps = (here_.gaps > 0.0).select(here_.gaps + change, 0.0);
    } else {
        // out of full contact the least pressed points open
        here_.gaps -= here_.gradient / elastic_.greatest_stiffness();
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
const parallel::Slab& AdhesiveCell::slab() const { return work_->slab(); }
const Interaction& AdhesiveCell::interaction() const { return work_->interaction(); }
const Array2D& AdhesiveCell::gaps() const { return work_->gaps(); }
Array2D AdhesiveCell::pressures() const { return work_->pressures(); }
double AdhesiveCell::felt_gap() const { return work_->felt_gap(); }
double AdhesiveCell::conformal_energy() const { return work_->conformal_energy(); }
double AdhesiveCell::touching_gap() const { return work_->touching_gap(); }
AdhesiveControl AdhesiveCell::displaced(double displacement, std::optional<double> stage_stiffness) const {
    return work_->displaced(displacement, stage_stiffness);
}
double AdhesiveCell::displacement(const AdhesiveState& state) const { return work_->displacement(state); }
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
