// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/bootstrap.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <vector>

#include <fmt/format.h>

#include "combination_mean.hpp"
#include "setae/core/errors.hpp"

namespace setae::spectra {
namespace {

/// Uniform index below n: the same numbers with any standard library, whose own distributions differ.
std::size_t draw_index(std::mt19937_64& engine, std::size_t n) {
    const std::uint64_t size = n, remainder = (~std::uint64_t{0} % size + 1) % size;
    for (;;) {
        const std::uint64_t number = engine();
        if (number <= ~std::uint64_t{0} - remainder) return static_cast<std::size_t>(number % size);
    }
}

/// Members among which to draw, all or those of each instrument; members without data in any bin are no draw.
std::vector<std::vector<std::size_t>> strata(const BinnedSpectra& spectra, bool by_instrument) {
    std::map<std::string, std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < spectra.instruments.size(); ++i)
        if (!spectra.C1D.row(static_cast<Index>(i)).isNaN().all()) groups[by_instrument ? spectra.instruments[i] : std::string{}].push_back(i);
    std::vector<std::vector<std::size_t>> result;
    for (auto& [instrument, members] : groups) result.push_back(std::move(members));
    return result;
}

Multiplicity draw(const std::vector<std::vector<std::size_t>>& strata, std::size_t members, std::uint64_t seed, std::size_t resample) {
    // seed_seq mixes both, so that neighbouring seeds and resamples share nothing
    std::seed_seq mixed{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                        static_cast<std::uint32_t>(resample), static_cast<std::uint32_t>(resample >> 32)};
    std::mt19937_64 engine(mixed);
    Multiplicity drawn(members, 0);
    for (const auto& stratum : strata)
        for (std::size_t k = 0; k < stratum.size(); ++k) ++drawn[stratum[draw_index(engine, stratum.size())]];
    return drawn;
}

/// Replaces NaN by full times the ratio of the neighbours, interpolated linearly over the bins. Returns which were filled.
Eigen::Array<bool, Eigen::Dynamic, 1> fill(Array1D& means, const Array1D& full) {
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
        const double t = before < 0 ? 1.0 : after == n ? 0.0 : static_cast<double>(b - before) / static_cast<double>(after - before);
        const double below = before < 0 ? 0.0 : ratio[before], above = after == n ? 0.0 : ratio[after];
        means[b] = full[b] * ((1.0 - t) * below + t * above);
    }
    return lost;
}

}  // namespace

BootstrapSpectra bootstrap(const BinnedSpectra& spectra, const BootstrapOptions& options) {
    if (options.resamples < 1) throw InvalidArgument(fmt::format("{} resamples; expected at least 1", options.resamples));
    const Array1D all = bin_means(spectra, options.weighting, all_members(spectra));
    std::vector<Index> filled;
    for (Index b = 0; b < all.size(); ++b)
        if (!std::isnan(all[b])) filled.push_back(b);
    const Array1D full = all(filled);
    const auto groups = strata(spectra, options.stratified);

    BootstrapSpectra result;
    result.seed = options.seed;
    result.wavevector = spectra.wavevector(filled);
    result.C1D.resize(options.resamples, full.size());
    Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> lost(options.resamples, full.size());
    parallel::for_each_index(static_cast<std::size_t>(options.resamples), options.threads, [&](std::size_t r) {
        const auto drawn = draw(groups, spectra.instruments.size(), options.seed, r);
        Array1D means = bin_means(spectra, options.weighting, drawn)(filled);
        lost.row(static_cast<Index>(r)) = fill(means, full).transpose();
        result.C1D.row(static_cast<Index>(r)) = means.transpose();
    });
    result.filled_share = lost.cast<double>().colwise().mean().transpose();
    return result;
}

}  // namespace setae::spectra
