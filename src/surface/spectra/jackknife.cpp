// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/jackknife.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <fmt/format.h>
#include <boost/math/special_functions/trigamma.hpp>

#include "combination_mean.hpp"
#include "setae/core/errors.hpp"

namespace setae::spectra {
namespace {

using Stratum = std::vector<std::size_t>;  ///< measurements, each with its multiplicity

std::vector<Stratum> strata(const BinnedSpectra& spectra, const Multiplicity& multiplicity) {
    std::map<std::string, Stratum> by_instrument;
    for (std::size_t i = 0; i < multiplicity.size(); ++i)
        if (!spectra.C1D.row(static_cast<Index>(i)).isNaN().all())
            for (int k = 0; k < multiplicity[i]; ++k) by_instrument[spectra.instruments[i]].push_back(i);
    std::vector<Stratum> found;
    Stratum singles;
    for (auto& [instrument, members] : by_instrument) {
        if (members.size() == 1) singles.push_back(members.front());
        if (members.size() > 1) found.push_back(std::move(members));
    }
    if (singles.size() == 1 && !found.empty())
        std::max_element(found.begin(), found.end(), [](const Stratum& a, const Stratum& b) {
            return a.size() < b.size();
        })->push_back(singles.front());
    else if (singles.size() > 1) found.push_back(std::move(singles));
    return found;
}

}  // namespace

JackknifeSpectra jackknife(const BinnedSpectra& spectra, Weighting weighting, const Multiplicity& multiplicity) {
    auto taking_part = multiplicity.empty() ? all_members(spectra) : multiplicity;
    if (taking_part.size() != spectra.instruments.size())
        throw InvalidArgument(fmt::format("a multiplicity of {} measurements for {}; expected one each",
                                          taking_part.size(), spectra.instruments.size()));
    // the bins and the shape of missing ones are those of all measurements, so every combination covers the same band
    const Array1D all = bin_means(spectra, weighting, all_members(spectra));
    const auto filled = filled_bins(all);
    const Array1D full = all(filled);
    JackknifeSpectra result;
    result.wavevector = spectra.wavevector(filled);
    for (const auto& stratum : strata(spectra, taking_part)) {
        Array2D& curves = result.C1D.emplace_back(static_cast<Index>(stratum.size()), full.size());
        for (std::size_t k = 0; k < stratum.size(); ++k) {
            const auto row = static_cast<Index>(k);
            if (k > 0 && stratum[k] == stratum[k - 1]) {
                curves.row(row) = curves.row(row - 1);
                continue;
            }
            --taking_part[stratum[k]];
            Array1D means = bin_means(spectra, weighting, taking_part)(filled);
            ++taking_part[stratum[k]];
            fill_lost_bins(means, full);
            curves.row(row) = means.transpose();
        }
    }
    return result;
}

MovedBins moved_single_bins(const BinnedSpectra& spectra, Weighting weighting) {
    const Array1D all = bin_means(spectra, weighting, all_members(spectra));
    const auto filled = filled_bins(all);
    const Array1D full = all(filled);
    std::vector<Index> single;  // of the filled bins
    std::vector<double> deviations;
    for (std::size_t k = 0; k < filled.size(); ++k) {
        const auto has_value = !spectra.C1D.col(filled[k]).isNaN();
        if (has_value.count() != 1) continue;
        Index member = 0;
        has_value.maxCoeff(&member);
        single.push_back(static_cast<Index>(k));
        deviations.push_back(std::sqrt(boost::math::trigamma(1.0 / spectra.relative_variance(member, filled[k]))));
    }
    const auto rows = static_cast<Index>(single.size());
    MovedBins result{spectra.wavevector(filled), full.transpose().replicate(rows, 1),
                     full.transpose().replicate(rows, 1)};
    for (Index r = 0; r < rows; ++r) {
        const auto at = static_cast<std::size_t>(r);
        result.plus(r, single[at]) *= std::exp(deviations[at]);
        result.minus(r, single[at]) *= std::exp(-deviations[at]);
    }
    return result;
}

}  // namespace setae::spectra
