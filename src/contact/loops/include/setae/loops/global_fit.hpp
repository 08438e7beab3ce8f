// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/fields/describe.hpp"
#include "setae/loops/model_fits.hpp"

namespace setae::loops {

/// One of several branches that are fitted together.
struct GlobalBranch {
    std::string name;
    BranchData data;
    LensAndCounterBody bodies;
};

struct GlobalOptions {
    bool share_contact_modulus = true;
    bool share_work_of_adhesion = false;
    /// Model, channels, errors, interaction range; fixed values apply to every branch. Not for the transition equation;
    /// each branch has its own λ.
    ModelFitOptions fit{};
};

/// Results of one branch of a global fit.
struct GlobalBranchFit {
    std::string name;
    ModelFit separate;         ///< fit of this branch only
    Estimate contact_modulus;  ///< shared or of the branch
    Estimate youngs_modulus;
    Outcome<Estimate> work_of_adhesion;
    Outcome<Estimate> transition_parameter;  ///< of Maugis–Dugdale
    Estimate contact_point;
    double chi2 = 0.0;  ///< in the global fit
    Index n = 0;
};

/// Test of whether shared parameters agree between branches: χ² of the global fit against the sum of the separate ones.
///
///   F = [(χ²_global − χ²_separate)/(p_separate − p_global)] / [χ²_separate/ν]
///
/// ν: number of independent residuals, minus p_separate. A small p-value means that the branches differ.
struct SharingTest {
    double f_ratio = 0.0;
    double extra_parameters = 0.0;    ///< p_separate − p_global
    double degrees_of_freedom = 0.0;  ///< ν
    double p_value = 1.0;
};

struct GlobalFit {
    GlobalOptions options;
    bool converged = false;
    int iterations = 0;
    std::optional<Estimate> contact_modulus;   ///< E* [Pa] where shared
    std::optional<Estimate> work_of_adhesion;  ///< W [J/m²] where shared and the model has it
    std::vector<GlobalBranchFit> branches;
    std::vector<std::string> parameters;  ///< rows of the covariance: "contact_modulus", "work_of_adhesion of NAME", …
    Eigen::MatrixXd covariance;
    double chi2 = 0.0, chi2_reduced = 0.0;
    double correlated_samples = 1.0;
    Index n = 0;
    SharingTest sharing;
};

/// Fits several branches at once, with common E* or W or both.
///
/// Each branch has its bodies, its noise and its contact point.
/// @throws InvalidArgument for no branches, nothing shared, or the transition equation; as fit_model, with the branch's
/// name.
[[nodiscard]] GlobalFit fit_globally(const std::vector<GlobalBranch>& branches, const GlobalOptions& options = {});

}  // namespace setae::loops

namespace setae::fields {

template <>
struct Described<loops::GlobalBranchFit> {
    using T = loops::GlobalBranchFit;
    static constexpr std::array rows{
        field<&T::name>("name", "name in the file, or given by the user"),
        field<&T::n>("n", "number of points, measurements or pairs"),
        field<&T::chi2>("chi_squared", "χ²"),
        quantity<&T::contact_modulus>("contact_modulus", "E*", "Pa", "E*"),
        quantity<&T::youngs_modulus>("youngs_modulus", "E", "Pa", "E"),
        quantity<&T::work_of_adhesion>("work_of_adhesion", "W", "J/m2", "W"),
        field<&T::separate>("separate", "separate fit of the loop"),
        inner<&T::transition_parameter>(),
        inner<&T::contact_point>(),
    };
    static constexpr Description description{"", "loop of a fit with shared parameters", rows};
};
static_assert(complete<loops::GlobalBranchFit>);

template <>
struct Described<loops::SharingTest> {
    using T = loops::SharingTest;
    static constexpr std::array rows{
        field<&T::f_ratio>("f_ratio", "F ratio of the fits with and without sharing"),
        field<&T::extra_parameters>("extra_parameters", "additional parameters of separate fits"),
        field<&T::degrees_of_freedom>("degrees_of_freedom", "degrees of freedom of Student's t or of χ²"),
        field<&T::p_value>("p_value", "probability of a ratio at least as large by chance"),
    };
    static constexpr Description description{"", "test of whether one value fits all loops", rows};
};
static_assert(complete<loops::SharingTest>);

template <>
struct Described<loops::GlobalFit> {
    using T = loops::GlobalFit;
    static constexpr std::array rows{
        made<T>("model", "name of the contact model", [](const T& of) { return to_string(of.options.fit.model); }),
        field<&T::converged>("converged", "whether the iteration converged"),
        quantity<&T::contact_modulus>("contact_modulus", "E*", "Pa", "E*"),
        quantity<&T::work_of_adhesion>("work_of_adhesion", "W", "J/m2", "W"),
        field<&T::branches>("loops", "one entry per loop"),
        field<&T::parameters>("parameters", "names of the fitted parameters, in the order of the covariance"),
        field<&T::covariance>("covariance", "covariance of the parameters"),
        field<&T::n>("n", "number of points, measurements or pairs"),
        field<&T::chi2_reduced>("chi_squared_reduced", "χ² divided by the degrees of freedom"),
        field<&T::sharing>("sharing_test", "test of whether one value fits all loops"),
        inner<&T::options>(),
        inner<&T::iterations>(),
        inner<&T::chi2>(),
        inner<&T::correlated_samples>(),
    };
    static constexpr Description description{"shared_fit", "fit with parameters that the loops share", rows};
};
static_assert(complete<loops::GlobalFit>);

}  // namespace setae::fields
