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

/// Name of the input "spectrum of a surface": the uncertainty left by its measurements.
[[nodiscard]] std::string spectrum_input(const std::string& surface);

/// Uncertainty of spectral parameters and its origin: values without each measurement, replicas, and pairs of values
/// from a given ±. Standard errors, covariances and intervals use the same set:
///
///   draws from the covariance of a fit without its inputs, if the replicas are such draws
///   otherwise the jackknife within strata, if any stratum has two members
///   otherwise the scatter of bootstrap replicas
///
/// plus the contributions of bins with a single measurement, which these exclude, and of the sources, each independent
/// of the others: inputs that numbers of other surfaces may share by name.
struct ParameterSpread {
    struct Source {
        std::string name;  ///< of the input, such as "tip radius of afm (10 nm), PUNCD"; equal names are the same input
        SpectralParameters plus, minus;
    };
    using Function = std::function<double(const SpectralParameters&)>;

    std::vector<SpectralParameters> replicas;
    std::uint64_t seed = 0;  ///< seed of the replicas
    std::string replica_method = "bootstrap";
    bool replicas_are_draws = false;                        ///< drawn from the covariance of a fit
    std::vector<std::vector<SpectralParameters>> left_out;  ///< without each measurement of each stratum
    std::vector<Source> sources;
    std::vector<Source> single_bins;  ///< each bin with a single measurement, changed by the scatter of its modes

    /// Covariance of two functions of the parameters.
    ///
    ///   draws: Σ (f_k − f̄)(g_k − ḡ)/(K − 1)
    ///   jackknife: Σ_g (n_g − 1)/n_g Σ_i (f_(gi) − f_(g·)) (g_(gi) − g_(g·))
    ///   source or single bin: ¼ (f₊ − f₋)(g₊ − g₋)
    ///
    /// 0 if no uncertainty is known. Source: Efron, Tibshirani, An Introduction to the Bootstrap (1993), ch. 11.
    [[nodiscard]] double covariance(const Function& f, const Function& g) const;
    /// NaN if no uncertainty is known.
    [[nodiscard]] double standard_error(const Function& f) const;
    /// The variance of f as a term of a sum: its standard error squared, and the degrees of freedom from the
    /// measurements of each stratum; draws, bootstrap replicas and sources are exact. Variance 0 if no uncertainty is
    /// known.
    [[nodiscard]] VarianceTerm variance_term(const Function& f) const;
    /// Components of the variance of f: that of measurements, draws or replicas with the name "spectrum of SURFACE",
    /// one direction per measurement or replica, and each source with its own name.
    ///
    ///   jackknife: √((n_g − 1)/n_g) (f_(gi) − f_(g·));  replicas: (f_k − f̄)/√(K − 1);  a source: ½ (f₊ − f₋)
    ///
    /// so products of components are the covariance above. Empty if no uncertainty is known.
    [[nodiscard]] Components components(const Function& f, const std::string& surface) const;
    /// A function of the parameters with given value, and its uncertainty from this spread.
    ///
    ///   x = ln(f − least),  f between least + exp(x ∓ t_ν s),  s² = variance of x, ν its degrees of freedom, both as
    ///   above
    ///
    /// least: lower limit of f, 0 except for area ratios, 1. Without value > least no interval is stored. Method:
    /// "likelihood" for draws; "jackknife t on ln" or "bootstrap on ln", with ", delta" if sources contribute, or
    /// "delta on ln" for sources only; without " on ln" if no interval is stored. Source: coverage measured in
    /// docs/concepts/uncertainty.md.
    [[nodiscard]] Estimate estimate(double value, const Function& f, double least = 0.0) const;
    /// Changes every stored set of parameters.
    void each(const std::function<void(SpectralParameters&)>& change);

private:
    [[nodiscard]] bool has_jackknife() const;
    /// Values of f without each measurement, by stratum.
    [[nodiscard]] std::vector<LeaveOneOut> without_each(const Function& f) const;
    [[nodiscard]] std::string method(const std::string& scale) const;
};

}  // namespace setae::roughness
