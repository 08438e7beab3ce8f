// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/patches/patch.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/half_space/elastic_operator.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::patches {
namespace {

void require(const PatchDesign& design) {
    const auto refuse = [](const char* what, double value, const char* expected) {
        throw InvalidArgument(fmt::format("{} of a patch is {}; expected {}", what, value, expected));
    };
    constexpr Index max_points = 16384;  // a contact of so many squared takes some 40 GB
    if (design.points < 1 || design.points > max_points)
        refuse("side in points", static_cast<double>(design.points), "1 to 16384");
    if (!(design.points_per_wave >= 4.0)) refuse("shortest wave in points", design.points_per_wave, "at least 4");
    if (!(design.waves_per_side >= 1.0))
        refuse("number of longest waves per side", design.waves_per_side, "at least 1");
    if (!(design.energy_share > 0.0 && std::isfinite(design.energy_share)))
        refuse("share of energy", design.energy_share, "> 0");
    if (!(design.squared_ratio > 0.0 && design.squared_ratio <= 1.0))
        refuse("w dx/(E* rho^2)", design.squared_ratio, "above 0, at most 1");
    if (!(design.band() > 1.0))
        throw InvalidArgument(
            fmt::format("a patch of {} points has no band between {} waves per side and {} points per wave; expected "
                        "more points",
                        design.points, design.waves_per_side, design.points_per_wave));
}

spectra::SpectralDensity spectrum_of(const PatchDesign& design) {
    const double longest = 2.0 * pi * design.waves_per_side / static_cast<double>(design.points),
                 shortest = 2.0 * pi / design.points_per_wave;
    if (!design.spectrum) return spectra::density(spectra::SelfAffine{1.0, longest, design.hurst_exponent, shortest});
    return [longest, shortest, C = *design.spectrum](double q) {
        return q < longest * (1.0 - 1e-9) || q > shortest * (1.0 + 1e-9) ? 0.0 : C(q);
    };
}

}  // namespace

double PatchDesign::band() const { return static_cast<double>(points) / (waves_per_side * points_per_wave); }

Patch make_patch(const PatchDesign& design, parallel::Threads threads) {
    require(design);
    const auto side = static_cast<double>(design.points);
    const synthesis::SurfaceGrid points{design.points, design.points, side, side};
    const synthesis::SurfaceOptions drawn{
        .key = {design.seed}, .amplitudes = synthesis::Amplitudes::exact, .threads = threads};
    const auto spectrum = spectrum_of(design);
    const auto expected = synthesis::expected_roughness(spectrum, points, drawn);
    if (!(expected.rms_height > 0.0))
        throw InvalidArgument("the spectrum of a patch has no power in its band; expected a wider band");

    Patch patch{.heights = synthesis::random_surface(spectrum, points, drawn).heights,
                .grid = {design.points, design.points, side, side},
                .body = {.contact_modulus = 1.0},
                .interaction = {1.0, 1.0 / std::sqrt(design.squared_ratio), design.law},
                .energy_share = design.energy_share};
    const double stored =
        half_space::ElasticOperator(patch.grid, patch.body).energy_of_displacements(patch.heights) / patch.grid.area();
    const double factor = std::sqrt(design.energy_share / stored);
    patch.heights *= factor;
    patch.rms_height = factor * expected.rms_height;
    patch.rms_slope = factor * expected.rms_slope;
    return patch;
}

}  // namespace setae::patches
