// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/core/resampling.hpp"
#include "setae/core/statistics.hpp"
#include "setae/core/traced_value.hpp"
#include "setae/roughness/spectral_moments.hpp"

namespace setae::roughness {

/// The input that the spectrum of a surface is: what its measurements leave open.
[[nodiscard]] std::string spectrum_input(const std::string& surface);

/// How uncertain spectral parameters are, and why: values without each measurement, replicas, and pairs of values a
/// given ± leads to. Standard errors, covariances and intervals rest on the same of them:
///
///   draws from the covariance of a fit without its inputs, where the replicas are such
///   else the jackknife within strata, where any stratum has two members
///   else the scatter of bootstrap replicas
///
/// plus what bins of a single measurement do, which these leave out, and what the sources do, each independent of the
/// others: inputs that numbers of other surfaces may share by name.
struct ParameterSpread {
    struct Source {
        std::string name;  ///< of the input, such as "tip radius of afm (10 nm), PUNCD"; one name is one input
        SpectralParameters plus, minus;
    };
    using Function = std::function<double(const SpectralParameters&)>;

    std::vector<SpectralParameters> replicas;
    std::uint64_t seed = 0;  ///< of the replicas
    std::string replica_method = "bootstrap";
    bool replicas_are_draws = false;                        ///< drawn from the covariance of a fit
    std::vector<std::vector<SpectralParameters>> left_out;  ///< without each measurement of each stratum
    std::vector<Source> sources;
    std::vector<Source> single_bins;  ///< each bin that one measurement covers, moved by the scatter of its modes

    /// Covariance of two functions of the parameters.
    ///
    ///   draws: Σ (f_k − f̄)(g_k − ḡ)/(K − 1);  jackknife: Σ_g (n_g − 1)/n_g Σ_i (f_(gi) − f_(g·)) (g_(gi) − g_(g·));  a
    ///   source or single bin: ¼ (f₊ − f₋)(g₊ − g₋)
    ///
    /// 0 where nothing is known. Source: Efron, Tibshirani, An Introduction to the Bootstrap (1993), ch. 11.
    [[nodiscard]] double covariance(const Function& f, const Function& g) const;
    /// NaN where nothing is known.
    [[nodiscard]] double standard_error(const Function& f) const;
    /// The variance of f as a term of a sum: its standard error squared, and the degrees of freedom that the
    /// measurements of each stratum leave it; draws, bootstrap replicas and sources count as known. Variance 0 where
    /// nothing is known.
    [[nodiscard]] VarianceTerm variance_term(const Function& f) const;
    /// What the variance of f consists of: what measurements, draws or replicas leave open under "spectrum of SURFACE",
    /// one direction a measurement or replica, and each source under its own name.
    ///
    ///   jackknife: √((n_g − 1)/n_g) (f_(gi) − f_(g·));  replicas: (f_k − f̄)/√(K − 1);  a source: ½ (f₊ − f₋)
    ///
    /// so that products of components are the covariance above. Empty where nothing is known.
    [[nodiscard]] Components components(const Function& f, const std::string& surface) const;
    /// A function of the parameters, whose value is given, with what this spread says of it.
    ///
    ///   x = ln(f − least),  f between least + exp(x ∓ t_ν s),  s² = variance of x, ν its degrees of freedom, both as
    ///   above
    ///
    /// least: what f exceeds, 0 but for area ratios, 1. Where a value does not exceed it there is no interval of its
    /// own. Method: "likelihood" of draws; "jackknife t on ln" or "bootstrap on ln", with ", delta" where sources add
    /// to them, or "delta on ln" for sources alone; without " on ln" where there is no interval of its own. Source:
    /// coverage measured in docs/concepts/uncertainty.md.
    [[nodiscard]] Estimate estimate(double value, const Function& f, double least = 0.0) const;
    /// Changes every set of parameters held here.
    void each(const std::function<void(SpectralParameters&)>& change);

private:
    [[nodiscard]] bool has_jackknife() const;
    /// Values of f without each measurement, by stratum.
    [[nodiscard]] std::vector<LeaveOneOut> without_each(const Function& f) const;
    [[nodiscard]] std::string method(const std::string& scale) const;
};

}  // namespace setae::roughness
