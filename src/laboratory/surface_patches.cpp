// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_patches.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/laboratory/afm.hpp"
#include "setae/laboratory/side_view.hpp"
#include "setae/laboratory/stylus.hpp"
#include "setae/synthesis/random_surface.hpp"
#include "setae/synthesis/height_transform.hpp"
#include "spectral_moment.hpp"

namespace setae::laboratory {
namespace {

using synthesis::RandomKey;
using synthesis::substream;

/// Streams of what one measurement draws.
enum Stream : std::uint64_t { of_heights, of_place, of_tip, of_instrument };

constexpr parallel::Threads one_thread{1};

/// Smallest product of 2, 3 and 5 that is not below n: lengths that transform fast.
Index fast_length(double n) {
    for (auto candidate = static_cast<Index>(std::ceil(n));; ++candidate) {
        Index rest = candidate;
        for (const Index factor : {2, 3, 5})
            while (rest % factor == 0) rest /= factor;
        if (rest == 1) return candidate;
    }
}

/// Heights of a patch of the Gaussian parent become those of the surface. The waves that are longer than the patch set the
/// height about which it lies, drawn here and taken off again.
class PatchHeights {
public:
    PatchHeights(const KnownSurface& surface, double patch_size, RandomKey key) : surface_(&surface) {
        if (surface.gaussian()) return;
        const Band all = surface.band();
        rms_height_ = std::sqrt(variance_below(all.upper));
        const double longer = std::min(variance_below(std::min(pi / patch_size, all.upper)), rms_height_ * rms_height_);
        level_ = std::sqrt(longer) * synthesis::normal_number(substream(key, of_place), 0);
        transform_ = synthesis::lognormal_heights(surface.skewness);
    }

    void operator()(double* heights, Index count) const {
        if (surface_->gaussian()) return;
        const double about = transform_(level_ / rms_height_);
        for (Index i = 0; i < count; ++i)
            heights[i] = rms_height_ * (transform_((heights[i] + level_) / rms_height_) - about);
    }

private:
    /// Of the waves up to a wavevector.
    [[nodiscard]] double variance_below(double upper) const {
        return spectral_moment(surface_->C_iso, 0.0, surface_->band().lower, {0.0, upper}) / (2.0 * pi);
    }

    const KnownSurface* surface_;
    synthesis::HeightTransform transform_;
    double rms_height_ = 0.0;
    double level_ = 0.0;
};

topography::HeightMap patch(const KnownSurface& surface, const synthesis::SurfaceGrid& grid, double extent, RandomKey key) {
    auto map = synthesis::random_surface(surface.C_iso, grid, {.key = substream(key, of_heights), .threads = one_thread});
    PatchHeights(surface, extent, key)(map.heights.data(), map.heights.size());
    return map;
}

double drawn_radius(double told, double standard_error, RandomKey key) {
    const double radius = told + standard_error * synthesis::normal_number(substream(key, of_tip), 0);
    if (!(radius > 0.0))
        throw InvalidArgument(fmt::format("a tip of {} ± {} m was drawn with a radius of {} m; give a smaller uncertainty", told,
                                          standard_error, radius));
    return radius;
}

std::optional<double> if_positive(double value) { return value > 0.0 ? std::optional(value) : std::nullopt; }

}  // namespace

std::vector<topography::LineScan> stylus_scans(const KnownSurface& surface, const StylusProtocol& protocol, RandomKey key) {
    constexpr double points_a_rolloff = 40.0, rolloffs_apart = 4.0, ends = 1.02, most_points = 1 << 24;
    const double longest = *std::max_element(protocol.lengths.begin(), protocol.lengths.end());
    const double apart = rolloffs_apart * surface.rolloff_wavelength;
    const double width = apart * static_cast<double>(protocol.lengths.size());
    const double finest = std::max(surface.rolloff_wavelength / points_a_rolloff, std::sqrt(ends * longest * width / most_points));
    const double pixel = protocol.step / std::max(1.0, std::floor(protocol.step / finest));
    const Index nx = fast_length(ends * longest / pixel), ny = fast_length(std::max(2.0, width / pixel));
    const auto strip = patch(surface, {nx, ny, pixel * static_cast<double>(nx), pixel * static_cast<double>(ny)}, longest, key);
    const topography::Tip tip = topography::SphereTip{drawn_radius(protocol.tip_radius, protocol.tip_radius_standard_error, key)};
    const topography::Dilator touched(strip, tip, {.threads = one_thread});
    std::vector<topography::LineScan> scans;
    for (std::size_t k = 0; k < protocol.lengths.size(); ++k)
        scans.push_back(stylus_scan(touched, {.tip = topography::SphereTip{protocol.tip_radius},
                                              .tip_radius_standard_error = if_positive(protocol.tip_radius_standard_error),
                                              .length = protocol.lengths[k],
                                              .step = protocol.step,
                                              .start_y = apart * static_cast<double>(k),
                                              .noise_rms = protocol.noise,
                                              .tilt = protocol.tilt,
                                              .bow = protocol.bow,
                                              .key = substream(substream(key, of_instrument), k)}));
    return scans;
}

topography::HeightMap afm_scan(const KnownSurface& surface, const AfmProtocol& protocol, std::size_t index, RandomKey key) {
    constexpr double pixels_a_radius = 20.0, scans_a_patch = 2.0;
    constexpr Index most_pixels = 4096;
    const RandomKey own = substream(key, index);
    const double size = protocol.sizes[index], step = size / static_cast<double>(protocol.pixels);
    const double finest = std::max(0.5 * surface.short_wavelength, protocol.tip_radius / pixels_a_radius);
    const Index most = std::max<Index>(1, most_pixels / static_cast<Index>(scans_a_patch * static_cast<double>(protocol.pixels)));
    const Index fine = std::clamp<Index>(static_cast<Index>(std::ceil(step / finest)), 1, most);
    const Index n = static_cast<Index>(scans_a_patch) * protocol.pixels * fine;
    const double extent = scans_a_patch * size;
    const auto map = patch(surface, {n, n, extent, extent}, extent, own);
    const topography::Tip tip = topography::SphereTip{drawn_radius(protocol.tip_radius, protocol.tip_radius_standard_error, key)};
    return afm_map(map, {.tip = tip,
                         .nx = protocol.pixels,
                         .ny = protocol.pixels,
                         .size = size,
                         .noise_rms = protocol.noise,
                         .line_offset_rms = protocol.line_offset,
                         .key = substream(own, of_instrument),
                         .touch = {.threads = one_thread}});
}

topography::Profile tem_contour(const KnownSurface& surface, const TemProtocol& protocol, std::size_t index, RandomKey key) {
    constexpr double points_a_wave = 8.0, contours_a_line = 2.0;
    const RandomKey own = substream(key, index);
    const double length = protocol.lengths[index], extent = contours_a_line * length;
    const Index n = fast_length(extent / (surface.short_wavelength / points_a_wave));
    const auto C1D = synthesis::profile_density(surface.C_iso, {0.01 * surface.band().lower, surface.band().upper});
    auto line = synthesis::random_line(C1D, {.points = n, .size = extent},
                                       {.key = substream(own, of_heights), .threads = one_thread});
    PatchHeights(surface, extent, own)(line.heights.data(), n);
    // a foil of no thickness: the same line twice, so that it is a map
    const topography::HeightMap foil{.heights = line.heights.replicate(1, 2), .size = {extent, 2.0 * line.pixel_size()}, .periodic = true};
    return side_view_contour(foil, {.length = length,
                                    .step = protocol.step,
                                    .trace_noise_rms = protocol.noise,
                                    .key = substream(own, of_instrument)});
}

}  // namespace setae::laboratory
