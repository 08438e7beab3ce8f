// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "pair_functions.hpp"
#include "setae/hysteresis/ranking.hpp"

namespace setae::hysteresis {

enum class Branch { approach, retraction };

/// W_int of the elastomers: one of all, or in proportion to W_app of the smooth reference on the same elastomer.
enum class WorkOfElastomers { common, by_reference };

/// Present estimate of all inputs of a model's predictions: mean and covariance, in standard errors.
struct Knowledge {
    Eigen::VectorXd mean;
    Eigen::MatrixXd covariance;
};

/// measured − predicted of one branch, a straight line in the inputs x about where they are:
///
///   y − f = residual − J (x − mean)
struct BranchLines {
    Eigen::VectorXd residual;         ///< residual at that mean [J/m²]
    Eigen::MatrixXd jacobian;         ///< pairs × inputs [J/m²]
    Eigen::VectorXd own_variance;     ///< variance of noise that no other value shares [J²/m⁴]
    Eigen::VectorXd by_approach;      ///< ∂ predicted/∂ W_app as measured
    Eigen::MatrixXd covariance_with;  ///< covariance of all inputs with J x: K Jᵀ
    Eigen::MatrixXd covariance;       ///< J K Jᵀ and the own noise
};

/// Both works of adhesion of all pairs by one model, as functions of W_int, of the model's parameter and of all inputs.
///
///   W_app = g W − K,   W_ret = φ (measured W_app + x), or φ W_x α r
///
/// Logarithms of positive numbers vary linearly. Retraction uses the measured W_app, so that an error of the balance of
/// approach is counted once.
class BothBranches {
public:
    /// Inputs before those of the pairs: ln W_int, the model's parameter, and a constant error of W_ret.
    enum Shared : Index { work, number, constant, shared_count };

    /// known_work: W_int where it is not determined from the pairs. works: by_reference needs a reference of every
    /// pair; W_int is then that of a pair with the mean reference.
    BothBranches(const RetractionModel& model, const std::vector<RankedPair>& pairs,
                 const std::optional<Estimate>& known_work, WorkOfElastomers works = WorkOfElastomers::common);

    [[nodiscard]] Index size() const { return static_cast<Index>(pairs_.size()); }
    /// Before any pair has been measured. with_constant: whether W_ret may be off by one constant of all pairs.
    [[nodiscard]] Knowledge prior(bool with_constant) const;
    /// Linearised branch of the pairs about x. own_variance of W_ret includes that of W_app.
    [[nodiscard]] BranchLines lines_at(Branch branch, const Eigen::VectorXd& x, const Knowledge& known) const;
    /// approach_error: error of measured W_app [J/m²], which retraction uses.
    [[nodiscard]] double predicted(Branch branch, Index pair, const Eigen::VectorXd& x,
                                   double approach_error = 0.0) const;
    [[nodiscard]] const Eigen::VectorXd& measured(Branch branch) const {
        return branch == Branch::approach ? approach_ : retraction_;
    }
    /// Standard errors of the own noise [J/m²].
    [[nodiscard]] const Eigen::VectorXd& noise(Branch branch) const {
        return branch == Branch::approach ? approach_noise_ : retraction_noise_;
    }
    /// Estimates of the shared inputs: W_int [J/m²], the model's parameter [its unit], the constant [J/m²].
    [[nodiscard]] Estimate value_of(Shared input, const Knowledge& known) const;
    /// Position in the inputs with given parameter of the model and given W_int.
    [[nodiscard]] Eigen::VectorXd at(double work_of_adhesion, double parameter) const;
    /// The inputs for standard normal numbers, one per direction.
    [[nodiscard]] Eigen::VectorXd drawn(const Eigen::VectorXd& normal) const { return factor_ * normal; }
    [[nodiscard]] Index directions() const { return factor_.cols(); }

private:
    /// Inputs of the predictions of one pair, in their order.
    enum Number : Index {
        area_ratio,
        energy,
        modulus,
        surface_energy,
        measured_approach,
        measured_retraction,
        tip,
        pinning,
        patches,
        radius,
        contact_area,
        stiffness,
        reference,
        number_count
    };
    struct Pair {
        PairFunctions by_roughness;  ///< without W_app as measured
        PairFunctions functions;
        PairFunctions::Inputs values;
        Roughness rough;
        double deviations[number_count];
        double reference_work = 1.0;  ///< W_app of the reference divided by the mean of all; 1 where W_int is common
    };
    [[nodiscard]] Index first_of(Index pair) const { return shared_count + pair * number_count; }
    [[nodiscard]] double moved(Index pair, Number number, double value, const Eigen::VectorXd& x) const;
    /// Whether an input can change the prediction of a branch by the model.
    [[nodiscard]] bool matters(Branch branch, Number of) const;

    RetractionModel model_;
    std::vector<RetractionPair> without_approach_;
    std::vector<Pair> pairs_;
    Eigen::VectorXd approach_, retraction_, approach_noise_, retraction_noise_;
    Eigen::MatrixXd factor_;      ///< factor of the covariance of all inputs without the shared ones …
    Eigen::MatrixXd covariance_;  ///< … and that
    Estimate work_, number_;      ///< priors
    double constant_ = 0.0;       ///< standard error of the prior
};

}  // namespace setae::hysteresis
