// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/roughness/parameter_spread.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "setae/core/constants.hpp"
#include "setae/core/statistics.hpp"

namespace setae::roughness {
namespace {

double mean_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Σ (f − f̄)(g − ḡ).
double sum_of_products(const std::vector<double>& f, const std::vector<double>& g) {
    const double mean_f = mean_of(f), mean_g = mean_of(g);
    double sum = 0.0;
    for (std::size_t i = 0; i < f.size(); ++i) sum += (f[i] - mean_f) * (g[i] - mean_g);
    return sum;
}

std::vector<double> values_of(const ParameterSpread::Function& f, const std::vector<SpectralParameters>& parameters) {
    std::vector<double> values;
    for (const auto& p : parameters) values.push_back(f(p));
    return values;
}

}  // namespace

std::string spectrum_input(const std::string& surface) { return "spectrum of " + surface; }

bool ParameterSpread::has_jackknife() const {
    return !replicas_are_draws &&
           std::any_of(left_out.begin(), left_out.end(), [](const auto& stratum) { return stratum.size() > 1; });
}

std::vector<LeaveOneOut> ParameterSpread::without_each(const Function& f) const {
    std::vector<LeaveOneOut> strata;
    for (const auto& stratum : left_out)
        if (stratum.size() > 1) strata.push_back(values_of(f, stratum));
    return strata;
}

double ParameterSpread::covariance(const Function& f, const Function& g) const {
    double sum = 0.0;
    if (has_jackknife()) {
        const auto of_f = without_each(f), of_g = without_each(g);
        for (std::size_t s = 0; s < of_f.size(); ++s) {
            const auto n = static_cast<double>(of_f[s].size());
            sum += (n - 1.0) / n * sum_of_products(of_f[s], of_g[s]);
        }
    } else if (replicas.size() > 1) {
        sum += sum_of_products(values_of(f, replicas), values_of(g, replicas)) /
               (static_cast<double>(replicas.size()) - 1.0);
    }
    for (const auto* moved : {&sources, &single_bins})
        for (const auto& source : *moved)
            sum += 0.25 * (f(source.plus) - f(source.minus)) * (g(source.plus) - g(source.minus));
    return sum;
}

double ParameterSpread::standard_error(const Function& f) const {
    return has_jackknife() || replicas.size() > 1 || !sources.empty() ? std::sqrt(covariance(f, f)) : undefined;
}

VarianceTerm ParameterSpread::variance_term(const Function& f) const {
    VarianceTerm result{covariance(f, f)};
    if (!has_jackknife()) return result;
    const auto between = jackknife_estimate(undefined, without_each(f));  // the degrees of freedom do not depend on its
                                                                          // value
    if (!between.degrees_of_freedom) return result;
    std::vector<VarianceTerm> terms{{between.variance(), *between.degrees_of_freedom}};
    for (const auto* moved : {&sources, &single_bins})
        for (const auto& source : *moved) terms.push_back({0.25 * std::pow(f(source.plus) - f(source.minus), 2)});
    result.degrees_of_freedom = satterthwaite_degrees_of_freedom(terms);
    return result;
}

Components ParameterSpread::components(const Function& f, const std::string& surface) const {
    std::vector<double> open;
    const auto add_scaled = [&open](const std::vector<double>& values, double factor) {
        const double mean = mean_of(values);
        for (const double value : values) open.push_back(factor * (value - mean));
    };
    const auto strata = has_jackknife() ? without_each(f) : std::vector<LeaveOneOut>{};
    if (!strata.empty()) {
        for (const auto& stratum : strata) {
            const auto n = static_cast<double>(stratum.size());
            add_scaled(stratum, std::sqrt((n - 1.0) / n));
        }
    } else if (replicas.size() > 1) {
        add_scaled(values_of(f, replicas), 1.0 / std::sqrt(static_cast<double>(replicas.size()) - 1.0));
    }
    for (const auto& bin : single_bins) open.push_back(0.5 * (f(bin.plus) - f(bin.minus)));
    Components result;
    if (!open.empty()) {
        Component own{Eigen::Map<const Array1D>(open.data(), static_cast<Index>(open.size()))};
        if (!strata.empty())
            if (const auto freedom = jackknife_estimate(undefined, strata).degrees_of_freedom)
                own.degrees_of_freedom = *freedom;
        result.emplace(spectrum_input(surface), std::move(own));
    }
    for (const auto& source : sources)
        result[source.name] = {Array1D::Constant(1, 0.5 * (f(source.plus) - f(source.minus)))};
    return result;
}

std::string ParameterSpread::method(const std::string& scale) const {
    if (replicas_are_draws) return "likelihood";
    const std::string with_sources = sources.empty() ? "" : ", delta";
    if (has_jackknife())
        return "jackknife t" + scale + (single_bins.empty() ? "" : ", modes of single bins") + with_sources;
    if (replicas.size() > 1) return replica_method + scale + with_sources;
    return "delta" + scale;
}

Estimate ParameterSpread::estimate(double value, const Function& f, double least) const {
    Estimate result{value, standard_error(f)};
    if (replicas.size() > 1 && !has_jackknife()) result.seed = seed;
    // a value not above the bound has no logarithm: NaN propagates to the interval and is refused there
    const auto log_excess = variance_term([&](const SpectralParameters& p) { return std::log(f(p) - least); });
    const bool on_ln = log_excess.variance > 0.0 && std::isfinite(log_excess.variance) && value > least;
    const auto known = on_ln ? log_excess : variance_term(f);
    result.method = method(on_ln ? " on ln" : "");
    if (known.variance > 0.0 && std::isfinite(known.degrees_of_freedom))
        result.degrees_of_freedom = known.degrees_of_freedom;
    if (!on_ln) return result;
    constexpr double level = 0.95;
    const double factor = std::exp(student_t_quantile(0.5 * (1.0 + level), log_excess.degrees_of_freedom) *
                                   std::sqrt(log_excess.variance));
    result.interval = Interval{least + (value - least) / factor, least + (value - least) * factor, level};
    return result;
}

void ParameterSpread::each(const std::function<void(SpectralParameters&)>& change) {
    for (auto& replica : replicas) change(replica);
    for (auto& stratum : left_out)
        for (auto& without : stratum) change(without);
    for (auto* moved : {&sources, &single_bins})
        for (auto& source : *moved) {
            change(source.plus);
            change(source.minus);
        }
}

}  // namespace setae::roughness
