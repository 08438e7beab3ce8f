// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/fields/describe.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::simulation {

/// Comparison of silhouettes with line scans.
struct ProjectionOptions {
    double thickness = 0.0;  ///< thickness of the foil [m], >= 0
    synthesis::SurfaceGrid
        grid;           ///< grid of each simulated surface, periodic; as wide along y as the foil is thick or wider
    int surfaces = 16;  ///< number of simulated surfaces, >= 2
    int bins_per_decade = 4;  ///< bins of wavevectors
    numerics::RandomKey key;
    parallel::Threads threads;
};

/// A ratio and the standard error of its mean over simulated surfaces.
struct BiasFactor {
    double value = 1.0;
    double standard_error = 0.0;
};

/// Silhouettes divided by line scans of the same surfaces: 1 without bias.
struct ProjectionBias {
    double thickness = 0.0;           ///< [m]
    double correlation_length = 0.0;  ///< distance at which the autocorrelation of line scans falls to 1/e [m]
    Array1D wavevector;               ///< geometric centres of bins in which lines have power [1/m]
    Array1D C1D, C1D_standard_error;  ///< factor on C1D in each bin
    /// rms height of the silhouette about its mean; rms slope from differences of neighbours
    BiasFactor rms_height, rms_slope;
    /// mean height of silhouettes minus that of line scans, in rms heights of the line scans
    double mean_height_shift = 0.0;
};

/// Bias of the silhouette of a foil for a surface with the given spectrum.
///
/// Surfaces are simulated with that C_iso; from each, silhouettes of adjacent foils and every line are transformed
/// (periodic, no window), C1D averaged; the factor in a bin is the ratio of summed C1D. Sums over surfaces have a fixed
/// order. A silhouette is higher and has less power at most wavevectors, because ridges hide valleys; at the transition
/// between two ridges it has a kink, which lines lack, so the factor is above 1 where C1D of lines falls steeply. The
/// factors do not depend on the scale of heights, only on thickness divided by the wavelengths of the spectrum. @throws
/// InvalidArgument as synthesis::random_surface, for fewer than two surfaces, or a foil thicker than the grid. Cost:
/// one map and its row transforms per surface.
[[nodiscard]] ProjectionBias projection_bias(const spectra::SpectralDensity& C_iso, const ProjectionOptions& options);

/// FOIL_PROJECTION: spectrum, height and slope of a silhouette relative to the true values; empty where all factors are
/// within `tolerance` of 1.
[[nodiscard]] std::vector<Alert> projection_alerts(const ProjectionBias& bias, const std::string& subject,
                                                   double tolerance = 0.02);

/// Output of `setae lab foil`.
struct FoilOutput {
    ProjectionBias bias;
    int surfaces = 0;
    std::uint64_t seed = 0;
    std::vector<Alert> alerts;
};

/// Factor on C1D in a bin of wavevectors.
struct FactorAtWavevector {
    BiasFactor factor;
    double wavevector = 0.0;  ///< [1/m]
};

[[nodiscard]] inline std::vector<FactorAtWavevector> factors_of(const ProjectionBias& bias) {
    std::vector<FactorAtWavevector> factors;
    for (Index b = 0; b < bias.wavevector.size(); ++b)
        factors.push_back({{bias.C1D[b], bias.C1D_standard_error[b]}, bias.wavevector[b]});
    return factors;
}

}  // namespace setae::simulation

template <>
struct setae::fields::Described<setae::simulation::BiasFactor> {
    using T = simulation::BiasFactor;
    static constexpr std::array rows{
        field<&T::value>("value", "value of the silhouettes divided by that of the lines"),
        field<&T::standard_error>("standard_error", "standard error of the ratio"),
    };
    static constexpr Description description{"ratio", "silhouettes divided by lines of the same surfaces", rows};
};
static_assert(setae::fields::complete<setae::simulation::BiasFactor>);

template <>
struct setae::fields::Described<setae::simulation::FactorAtWavevector> {
    using T = simulation::FactorAtWavevector;
    static constexpr std::array rows{
        fields_of<T>([](const T& of) -> const auto& { return of.factor; }),
        field<&T::wavevector>("wavevector", "wavevector q").in_unit("1/m"),
        inner<&T::factor>(),
    };
    static constexpr Description description{"", "ratio of C1D at a wavevector", rows};
};
static_assert(setae::fields::complete<setae::simulation::FactorAtWavevector>);

template <>
struct setae::fields::Described<setae::simulation::FoilOutput> {
    using T = simulation::FoilOutput;
    static constexpr std::array rows{
        made<T>("foil_thickness", "thickness of the foil", [](const T& of) { return of.bias.thickness; }).in_unit("m"),
        made<T>("correlation_length", "correlation length of lines of the surfaces",
                [](const T& of) { return of.bias.correlation_length; })
            .in_unit("m"),
        field<&T::surfaces>("surfaces", "number of simulated surfaces"),
        field<&T::seed>("seed", "seed of the random numbers"),
        made<T>("rms_height", "rms height of silhouettes divided by that of lines",
                [](const T& of) { return of.bias.rms_height; }),
        made<T>("rms_slope", "rms slope of silhouettes divided by that of lines",
                [](const T& of) { return of.bias.rms_slope; }),
        field<&T::alerts>("alerts", "warnings"),
        made<T>("C1D", "C1D of silhouettes divided by that of lines, by wavevector",
                [](const T& of) { return simulation::factors_of(of.bias); }),
        inner<&T::bias>(),
    };
    static constexpr Description description{"", "spectra of foils with known surfaces", rows};
};
static_assert(setae::fields::complete<setae::simulation::FoilOutput>);
