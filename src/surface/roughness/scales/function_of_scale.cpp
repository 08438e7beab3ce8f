// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/scales/function_of_scale.hpp"
#include "setae/core/units.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::scales {
namespace {

/// One measurement in one bin.
struct Share {
    double distance = 0.0, value = 0.0, count = 0.0, points = 0.0;
    Index measurement = 0;
};

/// Means over the members of each bin of one function; bins by number.
std::map<Index, Share> shares_of(const FunctionOfScale& function, const spectra::LogGrid& grid, Index measurement) {
    std::map<Index, Share> shares;
    for (Index k = 0; k < function.distance.size(); ++k) {
        if (!std::isfinite(function.value[k])) continue;
        auto& share = shares[grid.bin_of(function.distance[k])];
        share.distance += function.distance[k];
        share.value += function.value[k];
        share.count += function.count[k];
        share.points += 1.0;
        share.measurement = measurement;
    }
    for (auto& [bin, share] : shares) {
        share.distance /= share.points;
        share.value /= share.points;
    }
    return shares;
}

std::string instrument_of(const topography::Metadata& metadata) {
    const auto& instrument = metadata.instrument;
    if (!instrument.type.empty()) return instrument.type;
    return instrument.name.empty() ? "unknown" : instrument.name;
}

double weight_of(const Share& share, const std::vector<Share>& bin, const std::vector<std::string>& instruments,
                 Weighting weighting) {
    if (weighting == Weighting::equal) return 1.0;
    if (weighting == Weighting::by_count) return share.count;
    const auto same = std::count_if(bin.begin(), bin.end(), [&](const Share& other) {
        return instruments[static_cast<std::size_t>(other.measurement)] ==
               instruments[static_cast<std::size_t>(share.measurement)];
    });
    return 1.0 / static_cast<double>(same);
}

/// Gaps between filled bins that no measurement covers.
std::vector<Alert> coverage_gaps(const std::vector<Index>& bins, std::span<const FunctionOfScale> cut,
                                 const spectra::LogGrid& grid) {
    std::vector<Alert> alerts;
    for (std::size_t b = 1; b < bins.size(); ++b) {
        const double from = grid.edge(bins[b - 1] + 1), to = grid.edge(bins[b]);
        const bool spanned = std::any_of(cut.begin(), cut.end(), [&](const auto& function) {
            return function.distance.size() > 0 && function.distance.minCoeff() < from &&
                   function.distance.maxCoeff() >= to * (1.0 - 1e-9);
        });
        if (bins[b] - bins[b - 1] > 1 && !spanned)
            alerts.push_back(
                {"COVERAGE_GAP", cut[0].quantity,
                 fmt::format("no measurement between {} and {}", format_value(from, "m"), format_value(to, "m")),
                 "measure these distances, or use the parts on both sides of the gap separately"});
    }
    return alerts;
}

double wavelength_at(const spectra::ReliableBand& band) { return 2.0 * pi / band.band.upper; }

}  // namespace

FunctionOfScale within_limit(FunctionOfScale function) {
    std::vector<Index> kept;
    for (Index k = 0; k < function.distance.size(); ++k)
        if (function.distance[k] >= function.reliable_from * (1.0 - 1e-9)) kept.push_back(k);
    for (auto* values : {&function.distance, &function.value, &function.standard_error, &function.count})
        *values = Array1D((*values)(kept));
    return function;
}

FunctionOfScale binned(const FunctionOfScale& function, const spectra::LogGrid& grid) {
    const auto shares = shares_of(function, grid, 0);
    const auto n = static_cast<Index>(shares.size());
    FunctionOfScale result = function;
    result.distance = result.value = result.count = Array1D(n);
    result.standard_error = Array1D::Constant(n, undefined);
    Index k = 0;
    for (const auto& [bin, share] : shares) {
        result.distance[k] = share.distance;
        result.value[k] = share.value;
        result.count[k++] = share.count;
    }
    return result;
}

double shortest_reliable_wavelength(const topography::HeightMap& map, const spectra::ReliabilityOptions& options,
                                    parallel::Threads threads) {
    return wavelength_at(spectra::reliable_band(map, options, threads));
}

double shortest_reliable_wavelength(const topography::TiledMap& map, Index lines_together,
                                    const spectra::ReliabilityOptions& options, parallel::Threads threads) {
    return wavelength_at(spectra::reliable_band(map, lines_together, options, threads));
}

double shortest_reliable_wavelength(const topography::LineScan& scan, const spectra::ReliabilityOptions& options,
                                    parallel::Threads threads) {
    return wavelength_at(spectra::reliable_band(scan, options, threads));
}

double shortest_reliable_wavelength(const topography::Profile& profile, const spectra::ReliabilityOptions& options,
                                    parallel::Threads threads) {
    return wavelength_at(spectra::reliable_band(profile, options, threads));
}

double shortest_reliable_wavelength(const topography::Measurement& measurement,
                                    const spectra::ReliabilityOptions& options, parallel::Threads threads) {
    return wavelength_at(spectra::reliable_band(measurement, options, threads));
}

CombinedFunction combine(std::span<const FunctionOfScale> functions, const CombinationOptions& options) {
    if (functions.empty())
        throw InvalidArgument("no function of scale is given; expected at least one measurement to combine");
    std::vector<std::string> instruments;
    std::vector<FunctionOfScale> cut;
    std::map<Index, std::vector<Share>> bins;
    for (std::size_t i = 0; i < functions.size(); ++i) {
        const auto& function = functions[i];
        if (function.quantity != functions[0].quantity || function.unit != functions[0].unit)
            throw InvalidArgument(fmt::format("{} [{}] cannot be combined with {} [{}]; combine one quantity at a time",
                                              function.quantity, function.unit, functions[0].quantity,
                                              functions[0].unit));
        if (options.weighting == Weighting::by_count && function.count_unit != functions[0].count_unit)
            throw InvalidArgument(
                "a polyline has a length, not a number of pairs; choose equal weights or weights per instrument");
        instruments.push_back(instrument_of(function.metadata));
        cut.push_back(within_limit(function));
        for (const auto& [bin, share] : shares_of(cut.back(), options.grid, static_cast<Index>(i)))
            bins[bin].push_back(share);
    }
    if (bins.empty())
        throw InvalidArgument(fmt::format(
            "no {} of {} {} is reliable: all distances are shorter than what tip, resolution and "
            "sampling allow",
            functions[0].quantity, functions.size(), functions.size() == 1 ? "measurement" : "measurements"));

    const auto n = static_cast<Index>(bins.size());
    CombinedFunction result{
        functions[0].quantity, functions[0].unit, Array1D(n), Array1D(n), Array1D(n), Array1D(n), Array1D(n), {}, {}};
    std::vector<Index> numbers;
    Index k = 0;
    for (const auto& [bin, shares] : bins) {
        double weights = 0.0, distance = 0.0, value = 0.0, scatter = 0.0;
        std::set<std::string> different;
        std::vector<Index> contributors;
        for (const auto& share : shares) {
            const double weight = weight_of(share, shares, instruments, options.weighting);
            weights += weight;
            distance += weight * share.distance;
            value += weight * share.value;
            different.insert(instruments[static_cast<std::size_t>(share.measurement)]);
            contributors.push_back(share.measurement);
        }
        distance /= weights;
        value /= weights;
        for (const auto& share : shares) {
            const double weight = weight_of(share, shares, instruments, options.weighting);
            scatter += weight * weight * (share.value - value) * (share.value - value);
        }
        const auto members = static_cast<double>(shares.size());
        result.distance[k] = distance;
        result.value[k] = value;
        result.standard_error[k] = members > 1.0 ? std::sqrt(members / (members - 1.0) * scatter) / weights : undefined;
        result.count[k] = members;
        result.instrument_count[k] = static_cast<double>(different.size());
        result.contributors.push_back(std::move(contributors));
        numbers.push_back(bin);
        ++k;
    }
    result.alerts = coverage_gaps(numbers, cut, options.grid);
    return result;
}

Weighting weighting_from_name(const std::string& name) {
    if (name == "equal") return Weighting::equal;
    if (name == "per_instrument") return Weighting::per_instrument;
    if (name == "by_count") return Weighting::by_count;
    throw InvalidArgument(fmt::format("unknown weighting \"{}\"; expected equal, per_instrument or by_count", name));
}

}  // namespace setae::scales
