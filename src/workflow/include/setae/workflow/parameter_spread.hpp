// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/core/statistics.hpp"
#include "setae/roughness/spectral_moments.hpp"

namespace setae::workflow {

/// How uncertain spectral parameters are, and why: bootstrap replicas, values without each measurement, and pairs of values
/// a given ± leads to.
struct ParameterSpread {
    struct Source {
        std::string name;  ///< such as "tip radius"
        roughness::SpectralParameters plus, minus;
    };
    using Function = std::function<double(const roughness::SpectralParameters&)>;

    std::vector<roughness::SpectralParameters> replicas;
    std::uint64_t seed = 0;  ///< of the replicas
    bool replicas_are_draws = false;  ///< drawn from the covariance of a fit: their scatter is the uncertainty itself
    std::vector<std::vector<roughness::SpectralParameters>> left_out;  ///< without each measurement of each stratum
    std::vector<Source> sources;

    /// Covariance of two functions of the parameters: between replicas, plus ¼ (f₊ − f₋)(g₊ − g₋) of each source.
    [[nodiscard]] double covariance(const Function& f, const Function& g) const;
    [[nodiscard]] double standard_error(const Function& f) const;
    /// The variance of f as a term of a sum: its standard error squared, and the degrees of freedom that the measurements
    /// of each stratum leave it, the sources' share counting as known. Variance 0 where nothing is known.
    [[nodiscard]] VarianceTerm variance_term(const Function& f) const;
    /// A function of the parameters, whose value is given, with what this spread says of it.
    ///
    ///   x = ln(f − least),  f between least + exp(x ∓ t_ν s),  s² = jackknife variance of x + Σ ¼ (x₊ − x₋)² of the sources
    ///
    /// Where the replicas are draws, s² is the variance of x between them and ν infinite (method "likelihood").
    /// least: what f exceeds, 0 but for area ratios, 1. The standard error is that of standard_error(); without values that
    /// exceed `least`, or without strata and sources, there is no interval of its own.
    /// Source: coverage measured in docs/uncertainty.md.
    [[nodiscard]] Estimate estimate(double value, const Function& f, double least = 0.0) const;
};

}  // namespace setae::workflow
