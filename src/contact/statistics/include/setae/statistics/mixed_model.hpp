// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/core/estimate.hpp"
#include "setae/statistics/replicate_data.hpp"

namespace setae::statistics {

/// Surfaces that share their variances.
enum class Pooling {
    surfaces,  ///< all of them: each component is estimated from all surfaces together
    none,      ///< each surface has its own
};

struct MixedModelOptions {
    Pooling pooling = Pooling::surfaces;
    double level = 0.95;    ///< level of intervals
    bool influence = true;  ///< whether to fit again without each outermost group in turn
};

/// Variance between the groups of one level within a group of the level above; "repeat" is the innermost, between rows.
struct VarianceComponent {
    std::string level;                  ///< outermost of `includes`
    std::vector<std::string> includes;  ///< levels with identical groups, whose variances are estimated as one sum
    double variance = 0.0;              ///< [unit²], >= 0
    double standard_error = 0.0;        ///< standard error of the variance, from the expected information
    int degrees_of_freedom = 0;         ///< groups of this level minus groups of the level above
    bool at_bound = false;              ///< the restricted likelihood is largest at 0
};

/// Variance components of a set of surfaces, at the largest restricted likelihood.
struct VarianceFit {
    std::vector<std::string> surfaces;
    std::vector<VarianceComponent> components;  ///< outermost first; empty without repetitions
    std::vector<std::string> not_estimable;     ///< a sentence for each level that cannot be estimated, with the reason
    double known_variance =
        undefined;  ///< mean square of the rows' own standard errors [unit²]; NaN where none is known
    double log_likelihood = undefined;  ///< restricted log-likelihood, without −(n − p)/2 ln 2π
    int n = 0;
    bool converged = true;
};

/// Scatter of a surface's rows compared with their standard errors, without regard to groups.
///
///   Q = Σ w_i (y_i − ȳ)²,  w_i = 1/σ_i²,  ȳ = Σ w_i y_i/Σ w_i,  I² = max(0, 1 − (n − 1)/Q)
///
/// Source: Cochran, Biometrics 10 (1954) 101; Higgins, Thompson, Stat. Med. 21 (2002) 1539.
struct Heterogeneity {
    double Q = 0.0;
    int degrees_of_freedom = 0;
    double probability = 1.0;  ///< probability of a Q at least as large if the standard errors explain all scatter
    double I2 = 0.0;           ///< share of the scatter that the standard errors do not explain
};

/// The mean of a surface without one of its outermost groups (a lens).
struct Influence {
    std::string level, group;
    std::optional<Estimate> mean;  ///< absent without remaining rows
    double shift = undefined;      ///< mean without the group minus mean with it [unit]
};

/// One surface.
struct SurfaceMean {
    std::string surface;
    Estimate mean;  ///< method "mixed model" or, for a single row, "single measurement"
    std::optional<Interval>
        prediction;  ///< interval of one more measurement: another lens, spot and repeat, without the error of its fit
    std::optional<Estimate> with_excluded;       ///< the mean with the excluded rows, where there are any
    std::optional<Heterogeneity> heterogeneity;  ///< two or more rows, each with its own standard error
    std::vector<int> groups;                     ///< number of groups of each level below the surface
    int n = 0;                                   ///< rows used
    int excluded = 0;
    Array1D weights;  ///< weight of each row of the data in the mean, variances fixed; 0 for rows left out
    std::vector<Influence> influence;
    std::vector<std::string> notes;  ///< remarks for the reader, such as that replicates are missing
};

/// later − earlier of two surfaces.
struct SurfaceDifference {
    std::string later, earlier;
    Estimate difference;
    double probability = undefined;  ///< two-sided probability of a difference at least as large by chance
};

/// Means of all surfaces, their variances and differences between surfaces.
struct MixedModel {
    std::vector<std::string> levels, crossed;  ///< levels of the data
    Pooling pooling = Pooling::surfaces;
    std::vector<VarianceFit> fits;               ///< one where pooled, else one per surface
    std::vector<SurfaceMean> surfaces;           ///< in order of first appearance
    std::vector<SurfaceDifference> differences;  ///< every pair of surfaces
    std::vector<std::string> notes;
};

/// Means of surfaces from unbalanced nested replicates by a linear mixed model.
///
///   y_i = μ_surface + b_lens + b_spot + b_repeat + e_i,  b_k ~ N(0, θ_k),  e_i ~ N(0, σ_i²) known
///   V = Σ_k θ_k Z_k Z_kᵀ + diag σ²,  Φ = (XᵀV⁻¹X)⁻¹,  μ = Φ XᵀV⁻¹y,  Var μ = Φ,  X the indicators of surfaces
///   2 ln L_R = −[ln det V + ln det XᵀV⁻¹X + (y − Xμ)ᵀV⁻¹(y − Xμ)]
///
/// θ_k >= 0 at the global maximum of L_R: damped Newton steps in ln θ from several starts with each set of components
/// at 0; ν of Var μ: 2 (Var μ)²/(gᵀCg), g = ∂Var μ/∂θ, C the inverse expected information of all components
/// (Satterthwaite; exact for balanced groups). Components at 0 are not certain to be 0: each keeps (1/2 − 1/(2π)) C of
/// its variance, as a normal variable cut at its mean. ν >= 1. Rows without a standard error have σ = 0: the errors of
/// their fits are part of the variance of repeats. Levels whose groups are those of the surface are left out, levels
/// with identical groups are merged: see VarianceFit. A level where every label is empty is missing. A crossed level
/// has a variance of its own in addition to that of its groups on each surface, lme4's (1|lens) + (1|surface:lens):
/// contributions common to all surfaces cancel in their differences.
/// @throws InvalidArgument for no rows or no levels, a value that is not finite, a negative standard error, a row whose
/// number of labels is not that of the levels, a label missing in some rows only, a crossed level that is none, an
/// exclusion without reason, of a row that is not there, or twice; UndefinedDataError where every row is excluded.
/// Source: Patterson, Thompson, Biometrika 58 (1971) 545; Harville, J. Am. Stat. Assoc. 72 (1977) 320; Giesbrecht,
/// Burns, Biometrics 41 (1985) 477. Cost: O(n) per step of the likelihood, then once the sum of m³ over the groups of
/// the outermost level below surfaces, m their rows, O(n) without such a level; O(n³) where a level is crossed. The
/// same for each group left out.
[[nodiscard]] MixedModel mixed_model(const ReplicateData& data, const MixedModelOptions& options = {});

}  // namespace setae::statistics
