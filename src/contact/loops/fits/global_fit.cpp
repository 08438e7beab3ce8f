// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/global_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "fit_support.hpp"
#include "model_estimates.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"

namespace setae::loops {
namespace {

constexpr std::array<const char*, 4> slot_names{"contact_modulus", "work_of_adhesion", "transition_parameter",
                                                "contact_point"};
constexpr Index none = -1;

/// Unknown of the global fit for each slot of each branch.
struct Layout {
    std::vector<std::array<Index, 4>> columns;
    std::vector<std::string> names;

    [[nodiscard]] Index unknowns() const { return static_cast<Index>(names.size()); }
};

Layout layout(const std::vector<GlobalBranch>& branches, const std::vector<SolvedFit>& separate,
              const GlobalOptions& options) {
    const std::array<bool, 4> shared{options.share_contact_modulus, options.share_work_of_adhesion, false, false};
    Layout result;
    std::array<Index, 4> of_all{none, none, none, none};
    for (std::size_t b = 0; b < branches.size(); ++b) {
        std::array<Index, 4> columns{none, none, none, none};
        for (const Index slot : separate[b].prepared.free) {
            const auto k = static_cast<std::size_t>(slot);
            if (shared[k] && of_all[k] != none) {
                columns[k] = of_all[k];
                continue;
            }
            columns[k] = result.unknowns();
            if (shared[k]) of_all[k] = columns[k];
            result.names.push_back(shared[k] ? slot_names[k]
                                             : fmt::format("{} of {}", slot_names[k], branches[b].name));
        }
        result.columns.push_back(columns);
    }
    return result;
}

/// Slots of one branch from the unknowns of all.
FitParameters slots_of(const Layout& layout, std::size_t branch, const FitParameters& start,
                       const Eigen::VectorXd& unknowns) {
    FitParameters at = start;
    for (std::size_t k = 0; k < 4; ++k)
        if (layout.columns[branch][k] != none) at[static_cast<Index>(k)] = unknowns[layout.columns[branch][k]];
    return at;
}

Eigen::VectorXd start_of(const Layout& layout, const std::vector<SolvedFit>& separate) {
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(layout.unknowns()), counts = sums;
    for (std::size_t b = 0; b < separate.size(); ++b)
        for (std::size_t k = 0; k < 4; ++k)
            if (const Index column = layout.columns[b][k]; column != none) {
                sums[column] += separate[b].solution.at[static_cast<Index>(k)];
                counts[column] += 1.0;
            }
    return sums.cwiseQuotient(counts);
}

LeastSquaresSolution least_squares_of_all(const Layout& layout, const std::vector<SolvedFit>& separate,
                                          const Eigen::VectorXd& start) {
    Index residual_count = 0;
    for (const SolvedFit& fit : separate) residual_count += fit.prepared.problem.residuals();
    const ResidualFunction function{
        .residuals = residual_count,
        .parameters = layout.unknowns(),
        .evaluate = [&](const Eigen::VectorXd& unknowns, Eigen::VectorXd& residuals, Eigen::MatrixXd* jacobian) {
            if (jacobian) jacobian->setZero(residual_count, layout.unknowns());
            Index row = 0;
            for (std::size_t b = 0; b < separate.size(); ++b) {
                const BranchProblem& problem = separate[b].prepared.problem;
                const FitParameters at = slots_of(layout, b, separate[b].solution.at, unknowns);
                if (!drawable(at)) {
                    residuals.setConstant(undefined);
                    return;
                }
                Eigen::MatrixXd own;
                problem.evaluate(at, residuals.segment(row, problem.residuals()), jacobian ? &own : nullptr);
                for (std::size_t k = 0; k < 4 && jacobian; ++k)
                    if (const Index column = layout.columns[b][k]; column != none)
                        jacobian->col(column).segment(row, problem.residuals()) = own.col(static_cast<Index>(k));
                row += problem.residuals();
            }
        }};
    return solve_nonlinear(function, start);
}

SharingTest sharing_test(const GlobalFit& fit, const std::vector<SolvedFit>& separate) {
    double chi2 = 0.0, parameters = 0.0, independent = 0.0;
    for (const SolvedFit& branch : separate) {
        const auto own = static_cast<double>(branch.prepared.free.size());
        chi2 += branch.fit.chi2;
        parameters += own;
        independent += static_cast<double>(branch.prepared.problem.residuals()) / branch.fit.correlated_samples;
    }
    SharingTest test{.extra_parameters = parameters - static_cast<double>(fit.parameters.size()),
                     .degrees_of_freedom = std::max(1.0, independent - parameters)};
    if (!(test.extra_parameters > 0.0)) return test;
    test.f_ratio = std::max(0.0, fit.chi2 - chi2) / test.extra_parameters / (chi2 / test.degrees_of_freedom);
    test.p_value = f_exceedance(test.f_ratio, test.extra_parameters, test.degrees_of_freedom);
    return test;
}

std::vector<SolvedFit> separate_fits(const std::vector<GlobalBranch>& branches, const ModelFitOptions& options) {
    std::vector<SolvedFit> fits;
    for (const GlobalBranch& branch : branches) try {
            fits.push_back(solved_fit(branch.data, branch.bodies, options));
        } catch (const InvalidArgument& error) {
            throw InvalidArgument(fmt::format("{}: {}", branch.name, error.what()));
        } catch (const UndefinedDataError& error) {
            throw UndefinedDataError(fmt::format("{}: {}", branch.name, error.what()));
        }
    return fits;
}

/// Estimate of a slot's quantity with the error of its unknown; for a fixed one, as in the branch's own fit.
class BranchEstimates {
public:
    BranchEstimates(const Layout& layout, std::size_t branch, const SolvedFit& separate,
                    const LeastSquaresSolution& solution)
        : columns_(layout.columns[branch]),
          separate_(separate),
          solution_(solution),
          at_(slots_of(layout, branch, separate.solution.at, solution.parameters)),
          slopes_(physical_slopes(separate.prepared.problem, at_)) {}

    [[nodiscard]] const FitParameters& at() const { return at_; }
    [[nodiscard]] const Eigen::Vector4d& slopes() const { return slopes_; }
    [[nodiscard]] bool held(std::size_t slot) const { return columns_[slot] == none; }
    [[nodiscard]] double error(std::size_t slot) const {
        const Index column = columns_[slot];
        return std::sqrt(solution_.uncertainty.covariance(column, column));
    }
    [[nodiscard]] Estimate contact_modulus() const {
        if (held(0)) return separate_.fit.contact_modulus;
        const double modulus = std::exp(at_[0]);
        return solution_.estimate(modulus, modulus * error(0));
    }
    [[nodiscard]] Outcome<Estimate> work_of_adhesion() const {
        if (held(1)) return separate_.fit.work_of_adhesion;
        return work_estimate(separate_.prepared.problem.curve(), solution_, at_, error(1));
    }
    [[nodiscard]] Outcome<Estimate> transition_parameter() const {
        if (held(2) || !separate_.fit.transition_parameter) return separate_.fit.transition_parameter;
        const double lambda = separate_.prepared.problem.curve().transition_parameter(at_.head<3>());
        return solution_.estimate(lambda, lambda * error(2));
    }
    [[nodiscard]] Estimate contact_point() const {
        const BranchProblem& problem = separate_.prepared.problem;
        if (held(3)) return separate_.fit.contact_point;
        return solution_.estimate(problem.contact_point(at_), problem.depth_unit() * error(3));
    }

private:
    std::array<Index, 4> columns_;
    const SolvedFit& separate_;
    const LeastSquaresSolution& solution_;
    FitParameters at_;
    Eigen::Vector4d slopes_;
};

}  // namespace

GlobalFit fit_globally(const std::vector<GlobalBranch>& branches, const GlobalOptions& options) {
    if (branches.empty()) throw InvalidArgument("a global fit needs branches, got none");
    if (options.fit.model == ContactModel::transition)
        throw InvalidArgument(
            "the transition equation has the parameters a0, Fc and α and can share neither E* nor W; use "
            "maugis_dugdale");
    const bool shares_work = options.share_work_of_adhesion && options.fit.model != ContactModel::hertz;
    if (!options.share_contact_modulus && !shares_work)
        throw InvalidArgument(
            "a global fit must share the contact modulus, the work of adhesion, or both; got neither");

    std::vector<SolvedFit> separate = separate_fits(branches, options.fit);
    const Layout unknowns = layout(branches, separate, options);
    LeastSquaresSolution solution{.parameters = start_of(unknowns, separate)};
    GlobalFit fit{.options = options, .parameters = unknowns.names};
    constexpr int max_rounds = 30;
    for (int round = 0; round < max_rounds; ++round) {
        double change = 0.0;
        for (std::size_t b = 0; b < separate.size(); ++b)
            change = std::max(change, separate[b].prepared.problem.renew_weights(
                                          slots_of(unknowns, b, separate[b].solution.at, solution.parameters)));
        if (round > 0 && change < 1e-9) break;
        solution = least_squares_of_all(unknowns, separate, solution.parameters);
        fit.iterations += solution.iterations;
    }
    fit.converged = solution.converged && solution.uncertainty.covariance.allFinite();
    fit.correlated_samples = solution.uncertainty.correlated_samples;

    Eigen::VectorXd slopes(unknowns.unknowns());
    for (std::size_t b = 0; b < branches.size(); ++b) {
        const BranchEstimates own(unknowns, b, separate[b], solution);
        const BranchProblem& problem = separate[b].prepared.problem;
        GlobalBranchFit branch{.name = branches[b].name,
                               .separate = separate[b].fit,
                               .contact_modulus = own.contact_modulus(),
                               .youngs_modulus = youngs_modulus(own.contact_modulus(), branches[b].bodies),
                               .work_of_adhesion = own.work_of_adhesion(),
                               .transition_parameter = own.transition_parameter(),
                               .contact_point = own.contact_point(),
                               .chi2 = problem.chi2(problem.fitted(own.at()), own.at()),
                               .n = problem.samples()};
        for (std::size_t k = 0; k < 4; ++k)
            if (!own.held(k)) slopes[unknowns.columns[b][k]] = own.slopes()[static_cast<Index>(k)];
        fit.chi2 += branch.chi2;
        fit.n += branch.n;
        fit.branches.push_back(std::move(branch));
    }
    fit.covariance = slopes.asDiagonal() * solution.uncertainty.covariance * slopes.asDiagonal();
    if (options.share_contact_modulus) fit.contact_modulus = fit.branches.front().contact_modulus;
    if (shares_work && fit.branches.front().work_of_adhesion)
        fit.work_of_adhesion = *fit.branches.front().work_of_adhesion;
    fit.chi2_reduced = fit.chi2 / static_cast<double>(solution.residuals.size() - unknowns.unknowns());
    fit.sharing = sharing_test(fit, separate);
    return fit;
}

}  // namespace setae::loops
