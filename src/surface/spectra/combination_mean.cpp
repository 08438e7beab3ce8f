// SPDX-License-Identifier: GPL-3.0-or-later
#include "combination_mean.hpp"

#include <cmath>
#include <map>

#include "setae/core/constants.hpp"

namespace setae::spectra {

Multiplicity all_members(const BinnedSpectra& spectra) {
    return Multiplicity(static_cast<std::size_t>(spectra.C1D.rows()), 1);
}

Array1D bin_weights(const BinnedSpectra& spectra, Index bin, Weighting weighting, const Multiplicity& drawn) {
    const Index members = spectra.C1D.rows();
    Array1D weights = Array1D::Zero(members);
    for (Index i = 0; i < members; ++i)
        if (!std::isnan(spectra.C1D(i, bin))) weights[i] = drawn[static_cast<std::size_t>(i)];
    if (weighting == Weighting::inverse_variance)
        for (Index i = 0; i < members; ++i)
            if (weights[i] > 0.0) weights[i] /= spectra.relative_variance(i, bin);
    if (weighting == Weighting::per_instrument) {
        std::map<std::string, double> totals;
        for (Index i = 0; i < members; ++i) totals[spectra.instruments[static_cast<std::size_t>(i)]] += weights[i];
        for (Index i = 0; i < members; ++i)
            if (weights[i] > 0.0) weights[i] /= totals[spectra.instruments[static_cast<std::size_t>(i)]];
    }
    return weights;
}

Array1D bin_means(const BinnedSpectra& spectra, Weighting weighting, const Multiplicity& drawn) {
    Array1D means(spectra.wavevector.size());
    for (Index bin = 0; bin < means.size(); ++bin) {
        const Array1D weights = bin_weights(spectra, bin, weighting, drawn);
        double sum = 0.0, total = 0.0;
        for (Index i = 0; i < weights.size(); ++i) {
            if (!(weights[i] > 0.0)) continue;
            sum += weights[i] * spectra.C1D(i, bin);
            total += weights[i];
        }
        means[bin] = total > 0.0 ? sum / total : undefined;
    }
    return means;
}

std::vector<Index> filled_bins(const Array1D& means) {
    std::vector<Index> filled;
    for (Index b = 0; b < means.size(); ++b)
        if (!std::isnan(means[b])) filled.push_back(b);
    return filled;
}

Eigen::Array<bool, Eigen::Dynamic, 1> fill_lost_bins(Array1D& means, const Array1D& full) {
    const Index n = means.size();
    const Eigen::Array<bool, Eigen::Dynamic, 1> lost = means.isNaN();
    const Array1D ratio = means / full;
    Index before = -1;
    for (Index b = 0; b < n; ++b) {
        if (!lost[b]) {
            before = b;
            continue;
        }
        Index after = b;
        while (after < n && lost[after]) ++after;
        const double t = before < 0   ? 1.0
                         : after == n ? 0.0
                                      : static_cast<double>(b - before) / static_cast<double>(after - before);
        const double below = before < 0 ? 0.0 : ratio[before], above = after == n ? 0.0 : ratio[after];
        means[b] = full[b] * ((1.0 - t) * below + t * above);
    }
    return lost;
}

}  // namespace setae::spectra
