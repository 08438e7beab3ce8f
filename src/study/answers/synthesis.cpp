// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/synthesis.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "setae/answers/words.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/summation.hpp"
#include "setae/core/text.hpp"
#include "setae/core/units.hpp"
#include "setae/output/json.hpp"
#include "setae/spectra/self_affine.hpp"
#include "setae/spectra/spectral_density.hpp"
#include "setae/synthesis/random_surface.hpp"
#include "setae/tables/power_spectrum_table.hpp"

namespace setae::answers {
namespace {

double wavevector_of(const std::string& wavelength, const char* option) {
    const double length = parse_quantity(wavelength, dimension::length);
    if (!(length > 0.0))
        throw InvalidArgument(fmt::format("{} {}: expected a positive wavelength", option, wavelength));
    return 2.0 * pi / length;
}

/// One or two parts of "1024x512" or "5 um x 2 um".
std::vector<std::string> parts(const std::string& text) {
    const auto cross = text.find('x');
    if (cross == std::string::npos) return {text, text};
    return {std::string(trimmed(text.substr(0, cross))), std::string(trimmed(text.substr(cross + 1)))};
}

}  // namespace

std::array<Index, 2> point_counts(const std::string& text) {
    std::array<Index, 2> counts{};
    const auto texts = parts(text);
    for (std::size_t i = 0; i < 2; ++i) {
        const char* end = texts[i].data() + texts[i].size();
        const auto [stop, error] = std::from_chars(texts[i].data(), end, counts[i]);
        if (error != std::errc{} || stop != end)
            throw InvalidArgument(fmt::format("'{}': expected whole numbers, as 1024 or 1024x512", text));
    }
    return counts;
}

std::array<double, 2> extents(const std::string& text) {
    const auto texts = parts(text);
    return {parse_quantity(texts[0], dimension::length), parse_quantity(texts[1], dimension::length)};
}

namespace {

/// A model's C_iso without the wavevectors below `longest`.
spectra::SpectralDensity without_longer(spectra::SpectralDensity density, double longest) {
    if (!(longest > 0.0)) return density;
    return [density = std::move(density), longest](double q) { return q < longest * (1.0 - 1e-12) ? 0.0 : density(q); };
}

/// C_iso or C1D from columns q, C.
spectra::SpectralDensity from_table(const Table& table, bool line) {
    const auto& q = table.at("wavevector");
    if (const auto* C_iso = table.find("C_iso")) {
        auto density = spectra::tabulated_density(q, C_iso->values);
        return line ? spectra::profile_density(density, {q[0], q[q.size() - 1]}) : density;
    }
    const auto& C1D = table.at("C1D");
    return line ? spectra::tabulated_density(q, C1D) : spectra::surface_density(q, C1D);
}

/// Root mean square of heights about their mean and of forward differences over a pixel.
struct MadeRoughness {
    double rms_height, rms_slope;
};

MadeRoughness measured(const topography::HeightMap& map) {
    const auto [nx, ny] = map.shape();
    const auto pixel = map.pixel_size();
    const auto mean_over_rows = [](Index rows, const auto& of_row) {
        Array1D means(rows);
        for (Index i = 0; i < rows; ++i) means[i] = of_row(i);
        return pairwise_sum(means) / static_cast<double>(rows);
    };
    const auto& h = map.heights;
    const double mean = mean_over_rows(nx, [&](Index i) { return h.row(i).mean(); });
    const double square = mean_over_rows(nx, [&](Index i) { return (h.row(i) - mean).square().mean(); });
    const double along_x = mean_over_rows(nx - 1, [&](Index i) { return (h.row(i + 1) - h.row(i)).square().mean(); });
    const double along_y =
        mean_over_rows(nx, [&](Index i) { return (h.row(i).tail(ny - 1) - h.row(i).head(ny - 1)).square().mean(); });
    return {std::sqrt(square), std::sqrt(along_x / (pixel[0] * pixel[0]) + along_y / (pixel[1] * pixel[1]))};
}

MadeRoughness measured(const topography::LineScan& scan) {
    const auto& h = scan.heights;
    const Array1D squares = (h - pairwise_sum(h) / static_cast<double>(h.size())).square();
    const Array1D slopes = ((h.tail(h.size() - 1) - h.head(h.size() - 1)) / scan.pixel_size()).square();
    return {std::sqrt(pairwise_sum(squares) / static_cast<double>(h.size())),
            std::sqrt(pairwise_sum(slopes) / static_cast<double>(slopes.size()))};
}

MadeRoughness measured(const topography::Measurement& measurement) {
    const auto* map = std::get_if<topography::HeightMap>(&measurement);
    return map ? measured(*map) : measured(std::get<topography::LineScan>(measurement));
}

}  // namespace

synthesis::ExpectedRoughness SynthesisPlan::expected() const {
    return line ? synthesis::expected_roughness(density, synthesis::LineGrid{grid.nx, grid.size_x})
                : synthesis::expected_roughness(density, grid, options);
}

topography::Measurement SynthesisPlan::make() const {
    if (line) return synthesis::random_line(density, {grid.nx, grid.size_x}, options);
    auto map = heights ? synthesis::non_gaussian_surface(density, grid, heights, options).map
                       : synthesis::random_surface(density, grid, options);
    return window ? synthesis::cut(map, 0, 0, (*window)[0], (*window)[1]) : std::move(map);
}

SynthesisPlan SynthesisRequest::plan(parallel::Threads threads) const {
    require_word("amplitudes", amplitudes, fields::Asked<SynthesisRequest>::amplitudes);
    if (size.empty()) throw InvalidArgument("no extent; expected `size = 5 um`");
    SynthesisPlan plan;
    plan.line = line;
    const auto points = point_counts(pixels);
    const auto extent = extents(size);
    plan.grid = {points[0], points[1], extent[0], extent[1]};
    if (!window_of.empty()) {
        if (line) throw InvalidArgument("`window_of` is for surfaces; leave it out with `line`");
        const auto whole = extents(window_of);
        const auto count = [&](std::size_t i) {
            return static_cast<Index>(std::llround(whole[i] / extent[i] * static_cast<double>(points[i])));
        };
        plan.window = points;
        const Index nx = count(0), ny = count(1);
        const double pixel_x = extent[0] / static_cast<double>(points[0]),
                     pixel_y = extent[1] / static_cast<double>(points[1]);
        plan.grid = {nx, ny, pixel_x * static_cast<double>(nx), pixel_y * static_cast<double>(ny)};
        if (nx < points[0] || ny < points[1])
            throw InvalidArgument(fmt::format(
                "`window_of = {}` is smaller than `size = {}`; expected a window no larger than the surface", window_of,
                size));
    }
    plan.options = {
        .key = {seed},
        .amplitudes = amplitudes == "exact" ? synthesis::Amplitudes::exact : synthesis::Amplitudes::gaussian,
        .anisotropy = {stretch, angle * pi / 180.0},
        .threads = threads};
    if (skewness || kurtosis) {
        if (line) throw InvalidArgument("`skewness` and `kurtosis` are for surfaces; leave them out with `line`");
        plan.heights = synthesis::johnson_heights({skewness.value_or(0.0), kurtosis.value_or(3.0)});
    }
    if (spectrum.empty()) {
        if (!spectrum_unit.empty())
            throw InvalidArgument("`unit` is that of a table's columns; expected `spectrum` with it");
        plan.density = self_affine(plan.grid);
    } else {
        const auto table = tables::read_power_spectrum_table(
            spectrum,
            spectrum_unit.empty() ? tables::SpectrumUnits{} : tables::SpectrumUnits::from_text(spectrum_unit));
        plan.density = from_table(table, line);
        plan.alerts = tables::alerts_of(table, spectrum);
    }
    if (exact_rms)
        plan.options.exact_rms_height =
            rms_height.empty() ? plan.expected().rms_height : parse_quantity(rms_height, dimension::length);
    return plan;
}

spectra::SpectralDensity SynthesisRequest::self_affine(const synthesis::SurfaceGrid& grid) const {
    if (!hurst || rolloff.empty() || short_cutoff.empty())
        throw InvalidArgument("no spectrum; expected `hurst`, `rolloff` and `short_cutoff`, or `spectrum = table.csv`");
    if (rms_height.empty() + rms_slope.empty() + plateau.empty() != 2)
        throw InvalidArgument("no amplitude; expected one of `rms_height`, `rms_slope` and `plateau`");
    spectra::SelfAffine model{1.0, wavevector_of(rolloff, "`rolloff`"), *hurst,
                              wavevector_of(short_cutoff, "`short_cutoff`")};
    (void)spectra::density(model);
    const double longest = long_cutoff.empty() ? 0.0 : wavevector_of(long_cutoff, "`long_cutoff`");
    if (longest > model.rolloff_wavevector * (1.0 + 1e-12))
        throw InvalidArgument(
            fmt::format("`long_cutoff = {}` is shorter than `rolloff = {}`; expected it longer, or no other than it",
                        long_cutoff, rolloff));
    // moments of the unit plateau without the wavevectors that are cut
    const double unit_height = spectra::moment(model, 0.0) - longest * longest / 2.0,
                 unit_slope = spectra::moment(model, 2.0) - std::pow(longest, 4.0) / 4.0;
    if (!plateau.empty()) model.plateau = parse_quantity(plateau, dimension::power_spectrum_2d);
    else if (!rms_height.empty())
        model.plateau = 2.0 * pi * std::pow(parse_quantity(rms_height, dimension::length), 2.0) / unit_height;
    else model.plateau = 2.0 * pi * std::pow(parse_quantity(rms_slope, dimension::none), 2.0) / unit_slope;
    const auto C_iso = without_longer(spectra::density(model), longest);
    if (!line) return C_iso;
    if (longest > 0.0)
        throw InvalidArgument(
            "`long_cutoff` is for surfaces; a line crosses its long waves at any angle, give `spectrum` with C1D instead");
    return spectra::profile_density(
        C_iso, {std::min(0.01 * model.rolloff_wavevector, 2.0 * pi / grid.size_x), model.short_wavevector});
}

Synthesis synthesis_of(const SynthesisRequest& request, parallel::Threads threads) {
    Synthesis found{.plan = request.plan(threads), .measurement = {}, .quantities = {}};
    const auto expected = found.plan.expected();
    found.measurement = found.plan.make();
    const auto made = measured(found.measurement);
    found.quantities = {output::quantity("rms_height_of_spectrum", "h_rms", expected.rms_height, "m"),
                        output::quantity("rms_slope_of_spectrum", "h'_rms", expected.rms_slope, "1"),
                        output::quantity("rms_height_made", "h_rms", made.rms_height, "m"),
                        output::quantity("rms_slope_made", "h'_rms", made.rms_slope, "1")};
    return found;
}

}  // namespace setae::answers
