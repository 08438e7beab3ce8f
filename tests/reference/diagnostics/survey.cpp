// SPDX-License-Identifier: GPL-3.0-or-later
#include "survey.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "setae/diagnostics/diagnose.hpp"
#include "setae/numerics/random_numbers.hpp"
#include "setae/processing/despike.hpp"
#include "setae/spectra/self_affine.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::reference {
namespace {

constexpr double pixel = 1e-6 / 128.0;

spectra::SelfAffine model_of(int number, double size) {
    constexpr double exponents[] = {0.3, 0.5, 0.7, 0.9};
    return {1e-32, 2.0 * std::numbers::pi / (size / 8.0), exponents[number % 4],
            2.0 * std::numbers::pi / (0.25 * pixel)};
}

/// Whether the surface goes on below two pixels.
bool sampled(int number) { return (number / 4) % 2 == 1; }

numerics::RandomKey key_of(int number, std::uint64_t stream) {
    return numerics::substream({2026, stream}, static_cast<std::uint64_t>(number));
}

/// Count points of a line of n, `distance` apart, each by its place in a shuffled list.
template <class Far>
std::vector<Index> places(Index n, int count, std::uint64_t seed, Far far) {
    std::vector<Index> chosen;
    for (std::uint64_t draw = 0; static_cast<int>(chosen.size()) < count; ++draw) {
        const Index candidate = numerics::random_index({seed, 1}, draw, n);
        if (std::all_of(chosen.begin(), chosen.end(), [&](Index other) { return far(candidate, other); }))
            chosen.push_back(candidate);
    }
    return chosen;
}

void tally(Survey& survey, const topography::Measurement& measurement) {
    const auto findings = diagnostics::diagnose(measurement);
    ++survey.surfaces;
    survey.alarmed += findings.empty() ? 0 : 1;
    for (const auto& finding : findings) ++survey.codes[finding.alert.code];
}

void tally(Survey& survey, const topography::Mask& added, const topography::Mask& found) {
    for (Index k = 0; k < added.size(); ++k) {
        survey.spikes_added += added.data()[k];
        survey.spikes_found += added.data()[k] * found.data()[k];
        survey.points_blamed += (1 - added.data()[k]) * found.data()[k];
    }
}

constexpr double spike_height = 10.0;
constexpr int spikes_per_surface = 20;

}  // namespace

topography::HeightMap faultless_map(int number) {
    constexpr Index points = 128;
    const Index fine = sampled(number) ? 2 : 1;
    // a window of a periodic surface twice as wide
    const Index whole = 2 * points * fine;
    const auto surface = synthesis::random_surface(spectra::density(model_of(number, pixel * points)),
                                                   {whole, whole, 2.0 * points * pixel, 2.0 * points * pixel},
                                                   {.key = key_of(number, 1)});
    topography::HeightMap map{Array2D(points, points), {points * pixel, points * pixel}, false, {}};
    for (Index i = 0; i < points; ++i)
        for (Index j = 0; j < points; ++j) map.heights(i, j) = surface.heights(i * fine, j * fine);
    map.metadata.name = "map " + std::to_string(number);
    return map;
}

topography::LineScan faultless_line(int number) {
    constexpr Index points = 512;
    const Index fine = sampled(number) ? 2 : 1, whole = 2 * points * fine;
    const auto model = model_of(number, pixel * points);
    const auto C1D =
        spectra::profile_density(spectra::density(model), {1e-3 * model.rolloff_wavevector, model.short_wavevector});
    const auto line = synthesis::random_line(C1D, {whole, 2.0 * points * pixel}, {.key = key_of(number, 2)});
    topography::LineScan scan{Array1D(points), points * pixel, false, {}};
    for (Index i = 0; i < points; ++i) scan.heights[i] = line.heights[i * fine];
    scan.metadata.name = "line " + std::to_string(number);
    return scan;
}

TrueValues with_spikes(const topography::HeightMap& map, int count, std::uint64_t seed) {
    const Index nx = map.heights.rows(), ny = map.heights.cols(), rim = 3;
    const double height = spike_height * processing::find_spikes(map).deviation;
    auto spiked = map;
    topography::Mask mask = topography::Mask::Zero(nx, ny);
    const auto row = [&](Index place) { return rim + place / (ny - 2 * rim); };
    const auto column = [&](Index place) { return rim + place % (ny - 2 * rim); };
    const auto chosen = places((nx - 2 * rim) * (ny - 2 * rim), count, seed, [&](Index a, Index b) {
        return std::max(std::abs(row(a) - row(b)), std::abs(column(a) - column(b))) >= 5;
    });
    double sign = 1.0;
    for (const Index place : chosen) {
        spiked.heights(row(place), column(place)) += sign * height;
        mask(row(place), column(place)) = 1;
        sign = -sign;
    }
    return {std::move(spiked), std::move(mask)};
}

TrueValues with_spikes(const topography::LineScan& scan, int count, std::uint64_t seed) {
    const Index n = scan.heights.size(), rim = 3;
    const double height = spike_height * processing::find_spikes(scan).deviation;
    auto spiked = scan;
    topography::Mask mask = topography::Mask::Zero(n, 1);
    const auto chosen = places(n - 2 * rim, count, seed, [](Index a, Index b) { return std::abs(a - b) >= 8; });
    double sign = 1.0;
    for (const Index place : chosen) {
        spiked.heights[rim + place] += sign * height;
        mask(rim + place, 0) = 1;
        sign = -sign;
    }
    return {std::move(spiked), std::move(mask)};
}

Survey survey_maps(int surfaces) {
    Survey survey;
    for (int number = 0; number < surfaces; ++number) {
        const auto map = faultless_map(number);
        tally(survey, map);
        const auto added = with_spikes(map, spikes_per_surface, static_cast<std::uint64_t>(number));
        tally(survey, added.mask, processing::find_spikes(std::get<topography::HeightMap>(added.measurement)).mask);
    }
    return survey;
}

Survey survey_lines(int surfaces) {
    Survey survey;
    for (int number = 0; number < surfaces; ++number) {
        const auto line = faultless_line(number);
        tally(survey, line);
        const auto added = with_spikes(line, spikes_per_surface, static_cast<std::uint64_t>(number));
        tally(survey, added.mask, processing::find_spikes(std::get<topography::LineScan>(added.measurement)).mask);
    }
    return survey;
}

}  // namespace setae::reference
