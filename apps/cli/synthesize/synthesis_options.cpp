// SPDX-License-Identifier: GPL-3.0-or-later
#include "synthesize/synthesis_options.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/core/units.hpp"
#include "setae/spectra/self_affine.hpp"
#include "setae/spectra/spectral_density.hpp"
#include "setae/tables/power_spectrum_table.hpp"

namespace setae::cli {
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

std::array<double, 2> lengths(const std::string& text) {
    const auto texts = parts(text);
    return {parse_quantity(texts[0], dimension::length), parse_quantity(texts[1], dimension::length)};
}

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

void SynthesisOptions::add_to(Options& options) {
    options.add("--hurst", hurst, "Hurst exponent H of a self-affine spectrum, 0 < H <= 1").within(domain::share);
    options.add("--rolloff", rolloff, "roll-off wavelength; longer ones have a flat spectrum")
        .quantity(positive(dimension::length));
    options.add("--short-cutoff", short_cutoff, "shortest wavelength").quantity(positive(dimension::length));
    options.add("--long-cutoff", long_cutoff, "longest wavelength, none by default")
        .quantity(positive(dimension::length));
    options.add("--rms-height", rms_height, "of the spectrum, such as 20 nm").quantity(positive(dimension::length));
    options.add("--rms-slope", rms_slope, "of the spectrum").quantity(positive(dimension::none));
    options.add("--plateau", plateau, "C_iso below the roll-off, such as \"5e-27 m4\"")
        .quantity(positive(dimension::power_spectrum_2d));
    options.add("--spectrum,table", spectrum,
                "table of q and C_iso [m4] or C1D [m3] instead of a self-affine spectrum");
    options.add("--unit", spectrum_unit,
                "of the table's columns where its header has none, such as \"1/um, nm3\" or \"frequency 1/um, nm3\"");
    options.add("--pixels", pixels, "points along x and y, such as 1024x512; one number for both")
        .default_shown()
        .read_by([](const std::string& text) { (void)point_counts(text); });
    const auto extent = [](const std::string& text) { (void)lengths(text); };
    options.add("--size", size, "extent, such as \"5 um\" or \"5 um x 2 um\"").read_by(extent);
    options
        .add("--window-of", window_of,
             "make a periodic surface of this extent and write --size of it, which is not periodic")
        .read_by(extent);
    options.add("--seed", seed, "same seed, same surface").default_shown();
    options.flag("--line", line, "a line on such a surface");
    options.flag("--exact-rms", exact_rms, "scale the heights to the spectrum's rms height, or to --rms-height");
    options.add("--amplitudes", amplitudes, "gaussian, or exact: every mode as the spectrum says")
        .one_of({"gaussian", "exact"});
    options.add("--stretch", stretch, "features this many times longer along --angle").default_shown();
    options.add("--skewness", skewness, "of the heights of a surface, which keeps its spectrum; default 0");
    options.add("--kurtosis", kurtosis, "of the heights of a surface; default 3, Gaussian");
    options.add("--angle", angle, "of the long direction against x, degrees").default_shown();
}

SynthesisPlan SynthesisOptions::plan(parallel::Threads threads) const {
    if (size.empty()) throw InvalidArgument("no extent; expected --size, such as \"5 um\"");
    SynthesisPlan plan;
    plan.line = line;
    const auto points = point_counts(pixels);
    const auto extent = lengths(size);
    plan.grid = {points[0], points[1], extent[0], extent[1]};
    if (!window_of.empty()) {
        if (line) throw InvalidArgument("--window-of is for surfaces; leave it out with --line");
        const auto whole = lengths(window_of);
        const auto count = [&](std::size_t i) {
            return static_cast<Index>(std::llround(whole[i] / extent[i] * static_cast<double>(points[i])));
        };
        plan.window = points;
        const Index nx = count(0), ny = count(1);
        const double pixel_x = extent[0] / static_cast<double>(points[0]),
                     pixel_y = extent[1] / static_cast<double>(points[1]);
        plan.grid = {nx, ny, pixel_x * static_cast<double>(nx), pixel_y * static_cast<double>(ny)};
        if (nx < points[0] || ny < points[1])
            throw InvalidArgument(
                fmt::format("--window-of {} is smaller than --size {}; expected a window no larger than the surface",
                            window_of, size));
    }
    plan.options = {
        .key = {seed},
        .amplitudes = amplitudes == "exact" ? synthesis::Amplitudes::exact : synthesis::Amplitudes::gaussian,
        .anisotropy = {stretch, angle * pi / 180.0},
        .threads = threads};
    if (skewness || kurtosis) {
        if (line) throw InvalidArgument("--skewness and --kurtosis are for surfaces; leave them out with --line");
        plan.heights = synthesis::johnson_heights({skewness.value_or(0.0), kurtosis.value_or(3.0)});
    }
    if (spectrum.empty()) {
        if (!spectrum_unit.empty())
            throw InvalidArgument("--unit is that of a table's columns; expected --spectrum with it");
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

spectra::SpectralDensity SynthesisOptions::self_affine(const synthesis::SurfaceGrid& grid) const {
    if (!hurst || rolloff.empty() || short_cutoff.empty())
        throw InvalidArgument("no spectrum; expected --hurst, --rolloff and --short-cutoff, or --spectrum table.csv");
    if (rms_height.empty() + rms_slope.empty() + plateau.empty() != 2)
        throw InvalidArgument("how rough? expected one of --rms-height, --rms-slope and --plateau");
    spectra::SelfAffine model{1.0, wavevector_of(rolloff, "--rolloff"), *hurst,
                              wavevector_of(short_cutoff, "--short-cutoff")};
    (void)spectra::density(model);
    const double longest = long_cutoff.empty() ? 0.0 : wavevector_of(long_cutoff, "--long-cutoff");
    if (longest > model.rolloff_wavevector * (1.0 + 1e-12))
        throw InvalidArgument(
            fmt::format("--long-cutoff {} is shorter than --rolloff {}; expected it longer, or no other than it",
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
            "--long-cutoff is for surfaces; a line crosses its long waves at any angle, give --spectrum with C1D instead");
    return spectra::profile_density(
        C_iso, {std::min(0.01 * model.rolloff_wavevector, 2.0 * pi / grid.size_x), model.short_wavevector});
}

}  // namespace setae::cli
