// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>

#include "model_scatter_fit.hpp"
#include "nonnegative_minimum.hpp"
#include "pair_least_squares.hpp"
#include "setae/adhesion/free_energy_fit.hpp"
#include "setae/core/statistics.hpp"

namespace setae::adhesion {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;
using Columns = std::vector<Index>;

MatrixXd columns_of(const MatrixXd& matrix, const Columns& columns) {
    MatrixXd result(matrix.rows(), static_cast<Index>(columns.size()));
    for (std::size_t k = 0; k < columns.size(); ++k) result.col(static_cast<Index>(k)) = matrix.col(columns[k]);
    return result;
}

/// W, then u of each surface, and how far the pairs are from them.
class FreeFit {
public:
    FreeFit(const std::vector<FreeEnergyPoint>& points, const FreeEnergyFit& start)
        : points_(points), pairs_(pairs_of(points)), model_(pairs_, {.surfaces = false}) {
        const auto surfaces = static_cast<Index>(start.energy_per_modulus.size());
        at_ = VectorXd(1 + surfaces);
        at_[0] = start.work_of_adhesion;
        for (Index s = 0; s < surfaces; ++s) {
            const auto& [name, energy] = start.energy_per_modulus[static_cast<std::size_t>(s)];
            names_.push_back(name);
            at_[1 + s] = energy;
        }
    }

    /// Whether the pairs determine all parameters.
    [[nodiscard]] bool find() {
        constexpr int rounds = 200;
        constexpr double settled = 1e-9;
        if (static_cast<Index>(points_.size()) <= at_.size()) return false;
        for (int round = 0; round < rounds; ++round) {
            look();
            if (!told_apart()) return false;
            residuals_.design = columns_of(slopes_, free());
            scatter_ =
                round == 0 ? model_.most_likely(residuals_, scatter_) : model_.nearest_summit(residuals_, scatter_);
            const VectorXd before = at_, found = minimum();
            // shorter steps where a pair at its floor would make the solution oscillate
            at_ = round < rounds / 4 ? found : VectorXd(0.5 * (before + found));
            const VectorXd moved = (at_ - before).cwiseAbs(), size = at_.cwiseMax(before);
            if ((moved.array() <= settled * size.array()).all()) break;
        }
        look();
        residuals_.design = columns_of(slopes_, free());
        return told_apart();
    }

    [[nodiscard]] GeneralisedFreeEnergies result() const {
        GeneralisedFreeEnergies fit;
        fit.n = static_cast<int>(points_.size());
        fit.parameters = static_cast<int>(at_.size());
        fit.scatter = scatter_;
        fit.log_likelihood = model_.log_likelihood(residuals_, scatter_);
        std::vector<double> measured;
        for (const auto& pair : pairs_) measured.push_back(pair.measured.value);
        fit.r_squared = 1.0 - residuals_.value.squaredNorm() / squares_about_mean(measured);
        fit.traced_work_of_adhesion = traced(0);
        fit.work_of_adhesion = estimate(0);
        for (Index k = 1; k < at_.size(); ++k)
            fit.energies.push_back({names_[static_cast<std::size_t>(k - 1)], estimate(k)});
        return fit;
    }

private:
    static std::vector<PairPoint> pairs_of(const std::vector<FreeEnergyPoint>& points) {
        std::vector<PairPoint> pairs;
        for (const auto& point : points) pairs.push_back(point.pair);
        return pairs;
    }

    [[nodiscard]] Index surface_of(const PairPoint& pair) const {
        return 1 + std::distance(names_.begin(), std::find(names_.begin(), names_.end(), pair.surface));
    }

    /// Residuals and ∂f/∂θ where the parameters are.
    void look() {
        there_.clear();
        for (const auto& point : points_) there_.push_back(point.storing(at_[surface_of(point.pair)]));
        residuals_ = PairInputs(there_).residuals_at(at_[0]);
        slopes_ = MatrixXd::Zero(static_cast<Index>(points_.size()), at_.size());
        for (std::size_t i = 0; i < there_.size(); ++i) {
            if (!(there_[i].raw_prediction(at_[0]) > 0.0) && there_[i].floored) continue;
            slopes_(static_cast<Index>(i), 0) = there_[i].slope;
            slopes_(static_cast<Index>(i), surface_of(there_[i])) = -points_[i].contact_modulus.value;
        }
    }

    /// Parameters that some pair answers to.
    [[nodiscard]] Columns answered() const {
        Columns columns;
        for (Index k = 0; k < at_.size(); ++k)
            if (!slopes_.col(k).isZero(0.0)) columns.push_back(k);
        return columns;
    }

    /// Those above their floor.
    [[nodiscard]] Columns free() const {
        auto columns = answered();
        std::erase_if(columns, [this](Index k) { return !(at_[k] > 0.0); });
        return columns;
    }

    [[nodiscard]] bool told_apart() const {
        constexpr double least = 1e-10;
        const auto columns = answered();
        if (columns.empty() || columns.front() != 0) return false;
        MatrixXd design = columns_of(slopes_, columns);
        design.colwise().normalize();
        return Eigen::SelfAdjointEigenSolver<MatrixXd>(design.transpose() * design).eigenvalues().minCoeff() > least;
    }

    /// Minimum of the squares with fixed V and fixed pairs above their floor.
    [[nodiscard]] VectorXd minimum() const {
        const auto columns = answered();
        const MatrixXd design = columns_of(slopes_, columns);
        const MatrixXd weighted = factor_of(model_.covariance(residuals_, scatter_)).solve(design);
        const VectorXd target = residuals_.value + slopes_ * at_;
        const VectorXd found = nonnegative_minimum(design.transpose() * weighted, weighted.transpose() * target);
        VectorXd all = at_;
        for (std::size_t k = 0; k < columns.size(); ++k) all[columns[k]] = found[static_cast<Index>(k)];
        return all;
    }

    /// Estimate of a parameter by the pairs without its own floor, with those of the others fixed.
    [[nodiscard]] TracedValue traced(Index parameter) const {
        auto columns = free();
        auto place = std::find(columns.begin(), columns.end(), parameter);
        if (place == columns.end()) place = columns.insert(columns.end(), parameter);
        const auto row = std::distance(columns.begin(), place);
        auto at = residuals_;
        at.design = columns_of(slopes_, columns);
        const VectorXd h = generalised_weights(at.design, model_.covariance(at, scatter_)).row(row);
        return {at_[parameter] + h.dot(at.value), model_.components(at, residual_inputs(there_, at_[0]), scatter_, h)};
    }

    [[nodiscard]] Estimate estimate(Index parameter) const {
        if (slopes_.col(parameter).isZero(0.0))
            return {.value = at_[parameter], .method = "generalised least squares, every pair at its floor"};
        auto result = traced(parameter).estimate("generalised least squares");
        if (at_[parameter] > 0.0) {
            result.value = at_[parameter];
            result.interval = interval_of(result);
            if (result.interval) result.interval->lower = std::max(0.0, result.interval->lower);
            return result;
        }
        return one_sided(result);
    }

    static Estimate one_sided(const Estimate& without_floor) {
        constexpr double level = 0.95;
        Estimate result{.value = 0.0, .method = "generalised least squares, one-sided: at its floor 0"};
        if (!without_floor.uncertain()) return result;
        const double freedom = without_floor.degrees_of_freedom.value_or(std::numeric_limits<double>::infinity());
        const double below =
            std::max(std::numeric_limits<double>::min(),
                     student_t_probability(without_floor.value / without_floor.standard_error, freedom));
        const double upper =
            without_floor.value - without_floor.standard_error * student_t_quantile((1.0 - level) * below, freedom);
        result.degrees_of_freedom = without_floor.degrees_of_freedom;
        result.interval = Interval{0.0, std::max(0.0, upper), level};
        return result;
    }

    const std::vector<FreeEnergyPoint>& points_;
    std::vector<PairPoint> pairs_;
    ScatterFit model_;
    std::vector<std::string> names_;
    VectorXd at_;
    MatrixXd slopes_;
    ModelScatter scatter_;
    std::vector<PairPoint> there_;  ///< pairs with the stored energies of the parameters
    PairResiduals residuals_;
};

}  // namespace

std::optional<GeneralisedFreeEnergies> fit_free_energies_generalised(const std::vector<FreeEnergyPoint>& pairs,
                                                                     const FreeEnergyFit& start) {
    FreeFit fit(pairs, start);
    if (!fit.find()) return std::nullopt;
    return fit.result();
}

}  // namespace setae::adhesion
