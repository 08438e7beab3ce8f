// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_patches.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include <fmt/format.h>

#include "fast_length.hpp"
#include "patch_heights.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/simulation/afm.hpp"
#include "setae/simulation/side_view.hpp"
#include "setae/simulation/stylus.hpp"
#include "setae/synthesis/random_surface.hpp"
#include "spectral_moment.hpp"
#include "window_patch.hpp"

namespace setae::simulation {
namespace {

using numerics::RandomKey;
using numerics::substream;

/// Random streams of one measurement.
enum PatchStream : std::uint64_t { of_heights, of_level, of_tip, of_instrument, of_session, of_references };

constexpr parallel::Threads one_thread{1};

/// Length of a line of the surface divided by that of the measurement: longer waves contribute 1e-3 of the power after
/// subtracting a parabola.
constexpr double lengths_per_line = 8.0;

/// The radius of the tip that a protocol uses, of all surfaces or drawn for the surface of the key.
template <class Protocol>
double radius_of_tip(const Protocol& protocol, RandomKey key) {
    if (protocol.shared_tip_radius) return *protocol.shared_tip_radius;
    const double stated_value = protocol.tip_radius, standard_error = protocol.tip_radius_standard_error;
    const double radius = stated_value + standard_error * numerics::normal_number(substream(key, of_tip), 0);
    if (!(radius > 0.0))
        throw InvalidArgument(
            fmt::format("a tip of {} ± {} m was drawn with a radius of {} m; give a smaller uncertainty", stated_value,
                        standard_error, radius));
    return radius;
}

std::optional<double> if_positive(double value) { return value > 0.0 ? std::optional(value) : std::nullopt; }

StylusOptions stylus_options(const StylusProtocol& protocol, std::size_t scan, RandomKey key) {
    return {.tip_radius_standard_error = if_positive(protocol.tip_radius_standard_error),
            .length = protocol.lengths[scan],
            .step = protocol.step(scan),
            .noise_rms = protocol.noise,
            .tilt = protocol.tilt,
            .bow = protocol.bow,
            .artefact = {.rms = protocol.artefact,
                         .longest_wavelength = protocol.artefact_wavelength,
                         .session = substream(key, of_session)},
            .key = substream(substream(key, of_instrument), scan)};
}

/// C1D of points sampled at a step: all waves shorter than two steps are aliased.
spectra::SpectralDensity folded(const LineSpectrum& C1D, double step, double lowest) {
    constexpr int single = 16;  // aliases added one by one; beyond them their sum is an integral
    constexpr double nodes_per_e_fold = 40.0;
    const double sampling = 2.0 * pi / step, nyquist = 0.5 * sampling;
    double tail = 0.0;
    const double first = (single + 0.5) * sampling, extent = std::log(C1D.upper() / first);
    for (double t = 0.5 / nodes_per_e_fold; t < extent; t += 1.0 / nodes_per_e_fold) {
        const double q = first * std::exp(t);
        tail += 2.0 * C1D(q) * q / nodes_per_e_fold / sampling;
    }
    const auto count = static_cast<Index>(std::ceil(nodes_per_e_fold * std::log(nyquist / lowest))) + 1;
    Array1D q(count), values(count);
    for (Index i = 0; i < count; ++i) {
        q[i] = lowest * std::pow(nyquist / lowest, static_cast<double>(i) / static_cast<double>(count - 1));
        values[i] = C1D(q[i]) + tail;
        for (int m = 1; m <= single; ++m) values[i] += C1D(m * sampling + q[i]) + C1D(m * sampling - q[i]);
    }
    q[count - 1] *= 1.0 + 1e-9;
    return spectra::tabulated_density(q, values);
}

/// Pointwise readings without a tip.
topography::LineScan bare_scan(const KnownSurface& surface, const LineSpectrum& C1D, const StylusOptions& options,
                               RandomKey key) {
    const Index points = fast_length(lengths_per_line * options.length / options.step);
    const double extent = options.step * static_cast<double>(points);
    auto line = synthesis::random_line(folded(C1D, options.step, pi / extent), {.points = points, .size = extent},
                                       {.key = substream(key, of_heights), .threads = one_thread});
    PatchHeights(surface, extent, substream(key, of_level))(line.heights.data(), points);
    const Index scanned = std::llround(options.length / options.step);
    return recorded_scan(line.heights.head(scanned), options);
}

/// Scans of one length side by side: the strip on which a stylus runs.
PatchShape strip_for(const KnownSurface& surface, const StylusProtocol& protocol,
                     const std::vector<std::size_t>& scans) {
    constexpr double points_per_rolloff = 40.0, points_per_radius = 50.0, rolloffs_apart = 4.0, rolloffs_wide = 10.0,
                     highest_over_rms = 6.0, widest_lane = 30e-6, max_points = 1 << 24;
    const double longest = protocol.lengths[scans.front()], lanes = static_cast<double>(scans.size());
    const double long_rolloff = surface.anisotropy.stretch * surface.rolloff_wavelength;
    const double rms_height =
        std::sqrt(spectral_moment(surface.C_iso, 0.0, surface.band().lower, {0.0, surface.band().upper}) / (2.0 * pi));
    const double reach =
        std::min(protocol.tip_radius, std::sqrt(2.0 * protocol.tip_radius * highest_over_rms * rms_height));
    const double apart = std::max(rolloffs_apart, rolloffs_wide / lanes) * long_rolloff;
    const double lane = std::clamp(apart, 2.0 * reach, std::max(widest_lane, 2.0 * reach));
    const double width = lane * lanes;
    const double length = longest + std::max(0.02 * longest, std::min(rolloffs_apart * long_rolloff, lane));
    const double finest =
        std::max(std::min(surface.rolloff_wavelength / points_per_rolloff, protocol.tip_radius / points_per_radius),
                 std::sqrt(length * width / max_points));
    double step = protocol.step(scans.front());
    for (const auto scan : scans) step = std::min(step, protocol.step(scan));
    const double pixel = step / std::max(1.0, std::floor(step / finest));
    return {.nx = fast_length(length / pixel),
            .ny = fast_length(width / pixel),
            .pixel = pixel,
            .window = longest,
            .lanes = static_cast<Index>(scans.size())};
}

/// Indices of scans by their length, the longest first.
std::map<double, std::vector<std::size_t>, std::greater<>> by_length(const std::vector<double>& lengths) {
    std::map<double, std::vector<std::size_t>, std::greater<>> groups;
    for (std::size_t k = 0; k < lengths.size(); ++k) groups[lengths[k]].push_back(k);
    return groups;
}

/// Points of the fine grid per pixel of a map.
Index fine_points(const KnownSurface& surface, double tip_radius, double step, Index pixels) {
    constexpr double points_per_radius = 15.0;
    constexpr Index max_patches_per_side = 2048,
                    max_without_tip = 8;  // where waves shorter than two fine pixels are white noise
    const double finest = std::max(0.5 * surface.short_wavelength, tip_radius / points_per_radius);
    const Index most = std::max<Index>(1, max_patches_per_side / pixels);
    return std::clamp<Index>(static_cast<Index>(std::ceil(step / finest)), 1,
                             tip_radius > 0.0 ? most : std::min(most, max_without_tip));
}

/// Heights along x and, of a foil with thickness, along the beam.
topography::HeightMap foil(const KnownSurface& surface, const LineSpectrum& C1D, const TemProtocol& protocol,
                           double length, RandomKey key) {
    if (protocol.foil_thickness == 0.0) {
        constexpr double points_per_wave =
            64.0;  // straight lines between points take (q step)²/6 of the power: 1.6e-3 at the end
        const double extent = lengths_per_line * length;
        const Index n = fast_length(extent * C1D.upper() / (2.0 * pi) * points_per_wave);
        auto line = synthesis::random_line([&C1D](double q) { return C1D(q); }, {.points = n, .size = extent},
                                           {.key = substream(key, of_heights), .threads = one_thread});
        PatchHeights(surface, extent, substream(key, of_level))(line.heights.data(), n);
        // a foil of no thickness: the same line twice, so that it is a map
        return {.heights = line.heights.replicate(1, 2), .size = {extent, 2.0 * line.pixel_size()}, .periodic = true};
    }
    constexpr double points_per_wave = 16.0, max_points = 1 << 23;
    const double width = std::max(1.25 * protocol.foil_thickness, 0.25 * length), extent = 1.25 * length;
    const double pixel = std::max(surface.short_wavelength / points_per_wave, std::sqrt(extent * width / max_points));
    return window_patch(
        surface,
        {.nx = fast_length(extent / pixel), .ny = fast_length(width / pixel), .pixel = pixel, .window = length},
        substream(key, of_heights));
}

}  // namespace

std::vector<topography::LineScan> stylus_scans(const KnownSurface& surface, const LineSpectrum& C1D,
                                               const StylusProtocol& protocol, RandomKey key) {
    std::vector<topography::LineScan> scans(protocol.lengths.size());
    const RandomKey heights = substream(key, of_heights);
    if (protocol.tip_radius == 0.0) {
        for (std::size_t k = 0; k < scans.size(); ++k)
            scans[k] = bare_scan(surface, C1D, stylus_options(protocol, k, key), substream(heights, k));
        return scans;
    }
    const topography::Tip tip = topography::SphereTip{radius_of_tip(protocol, key)};
    for (const auto& [length, group] : by_length(protocol.lengths)) {
        const PatchShape strip = strip_for(surface, protocol, group);
        const auto map = window_patch(surface, strip, substream(heights, group.front()));
        const topography::Dilator touched(map, tip, {.threads = one_thread});
        for (std::size_t lane = 0; lane < group.size(); ++lane) {
            auto options = stylus_options(protocol, group[lane], key);
            options.tip = topography::SphereTip{protocol.tip_radius};
            const Index margin = (strip.nx - std::llround(length / strip.pixel)) / 2;
            options.start_x = strip.pixel * static_cast<double>(margin);
            options.start_y = map.size[1] * (static_cast<double>(lane) + 0.5) / static_cast<double>(group.size());
            scans[group[lane]] = stylus_scan(touched, options);
        }
    }
    return scans;
}

std::vector<topography::LineScan> stylus_references(const StylusProtocol& protocol, RandomKey key) {
    std::vector<topography::LineScan> scans;
    for (std::size_t k = 0; k < protocol.lengths.size(); ++k) {
        auto options = stylus_options(protocol, k, key);
        options.key = substream(substream(key, of_references), k);
        if (protocol.tip_radius > 0.0) options.tip = topography::SphereTip{protocol.tip_radius};
        scans.push_back(reference_scan(options));
    }
    return scans;
}

topography::HeightMap afm_scan(const KnownSurface& surface, const AfmProtocol& protocol, std::size_t index,
                               RandomKey key) {
    constexpr double patch_over_map = 1.25;
    const RandomKey own = substream(key, index);
    const Index pixels = protocol.pixels_of(index);
    const double size = protocol.sizes[index], step = size / static_cast<double>(pixels);
    const Index fine = fine_points(surface, protocol.tip_radius, step, pixels);
    const Index n = fast_length(patch_over_map * static_cast<double>(pixels * fine));
    const Index margin = (n - pixels * fine) / 2;
    const double pixel = step / static_cast<double>(fine), start = pixel * static_cast<double>(margin);
    const PatchShape shape{.nx = n, .ny = n, .pixel = pixel, .window = size, .pointwise = protocol.tip_radius == 0.0};
    const auto map = window_patch(surface, shape, substream(own, of_heights));
    AfmOptions options{.nx = pixels,
                       .ny = pixels,
                       .size = size,
                       .start_x = start,
                       .start_y = start,
                       .noise_rms = protocol.noise,
                       .line_offset_rms = protocol.line_offset,
                       .line_drift_rms = protocol.line_drift,
                       .tilt_x = protocol.tilt,
                       .bow = protocol.bow,
                       .feedback_lag = protocol.feedback_lag,
                       .key = substream(own, of_instrument),
                       .touch = {.threads = one_thread}};
    if (protocol.tip_radius > 0.0) {
        options.tip = topography::SphereTip{radius_of_tip(protocol, key)};
        return afm_map(map, options);
    }
    const Index first = (n - pixels * fine) / 2;
    return recorded_map(map.heights(Eigen::seqN(first, pixels, fine), Eigen::seqN(first, pixels, fine)), options);
}

topography::Profile tem_contour(const KnownSurface& surface, const LineSpectrum& C1D, const TemProtocol& protocol,
                                std::size_t index, RandomKey key) {
    const RandomKey own = substream(key, index);
    const double length = protocol.lengths[index];
    const auto cut = foil(surface, C1D, protocol, length, own);
    return projected_contour(cut, {.thickness = protocol.foil_thickness,
                                   .start_x = 0.1 * length,
                                   .length = length,
                                   .step = protocol.step,
                                   .steps = protocol.steps,
                                   .step_spread = protocol.step_spread,
                                   .trace_noise_rms = protocol.noise,
                                   .key = substream(own, of_instrument)});
}

}  // namespace setae::simulation
