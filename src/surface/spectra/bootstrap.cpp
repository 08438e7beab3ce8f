// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/bootstrap.hpp"

#include <map>
#include <vector>

#include <fmt/format.h>

#include "combination_mean.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/random_numbers.hpp"

namespace setae::spectra {
namespace {

/// Members to draw from, all or those of each instrument, without members that have no data in any bin.
std::vector<std::vector<std::size_t>> strata(const BinnedSpectra& spectra, bool by_instrument) {
    std::map<std::string, std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < spectra.instruments.size(); ++i)
        if (!spectra.C1D.row(static_cast<Index>(i)).isNaN().all())
            groups[by_instrument ? spectra.instruments[i] : std::string{}].push_back(i);
    std::vector<std::vector<std::size_t>> result;
    for (auto& [instrument, members] : groups) result.push_back(std::move(members));
    return result;
}

Multiplicity draw(const std::vector<std::vector<std::size_t>>& strata, std::size_t members,
                  const BootstrapOptions& options, std::size_t resample) {
    const auto key = numerics::substream({options.seed, 0}, resample);
    std::uint64_t drawn_so_far = 0;
    const auto index_below = [&](std::size_t n) {
        return static_cast<std::size_t>(numerics::random_index(key, drawn_so_far++, static_cast<Index>(n)));
    };
    Multiplicity drawn(members, 0);
    for (std::size_t s = 0; s < strata.size(); ++s) {
        const auto& stratum = strata[options.draw == Draw::instruments_and_within ? index_below(strata.size()) : s];
        for (std::size_t k = 0; k < stratum.size(); ++k) ++drawn[stratum[index_below(stratum.size())]];
    }
    return drawn;
}

}  // namespace

BootstrapSpectra bootstrap(const BinnedSpectra& spectra, const BootstrapOptions& options) {
    if (options.resamples < 1)
        throw InvalidArgument(fmt::format("{} resamples; expected at least 1", options.resamples));
    const Array1D all = bin_means(spectra, options.weighting, all_members(spectra));
    const auto filled = filled_bins(all);
    const Array1D full = all(filled);
    const auto groups = strata(spectra, options.draw != Draw::measurements);

    BootstrapSpectra result;
    result.seed = options.seed;
    result.wavevector = spectra.wavevector(filled);
    result.C1D.resize(options.resamples, full.size());
    result.drawn.resize(static_cast<std::size_t>(options.resamples));
    Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> lost(options.resamples, full.size());
    parallel::for_each_index(static_cast<std::size_t>(options.resamples), options.threads, [&](std::size_t r) {
        result.drawn[r] = draw(groups, spectra.instruments.size(), options, r);
        Array1D means = bin_means(spectra, options.weighting, result.drawn[r])(filled);
        lost.row(static_cast<Index>(r)) = fill_lost_bins(means, full).transpose();
        result.C1D.row(static_cast<Index>(r)) = means.transpose();
    });
    result.filled_share = lost.cast<double>().colwise().mean().transpose();
    return result;
}

}  // namespace setae::spectra
