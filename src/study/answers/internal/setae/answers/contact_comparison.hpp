// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "setae/answers/persson_contact.hpp"
#include "setae/core/table.hpp"
#include "setae/half_space/grid.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/study/surface_analysis.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::answers {

/// Request of `setae contact compare`: Persson's theory compared with solved contacts of surfaces with the same
/// spectrum.
struct ComparisonRequest {
    PerssonRequest theory;  ///< without adhesion
    std::string pixels = "512";
    std::string cell;  ///< empty: twice the longest wave
    int surfaces = 4;
    std::uint64_t seed = 0;
    double tolerance = 1e-6;

    /// @throws InvalidArgument where something is missing or malformed.
    void require_complete() const;
};

/// Result of the comparison. Every surface is periodic and has the band's waves in the grid's modes, with the power of
/// the spectrum: the surfaces differ only by the phases of their waves.
struct ContactComparison {
    persson::Scales scales;  ///< scales of the cell: the theory uses the same waves as the solution
    half_space::Grid grid;
    Band band;  ///< [1/m]
    /// pressure [Pa]; then for area_fraction (with the perimeter's correction), mean_gap [m], contact_stiffness [Pa/m]
    /// and stored_energy [J/m2] each the mean over surfaces, its "…_standard_error", and "…_persson"
    Table load;
    half_space::Body body;
    double energy_factor = 0.0;
    int surfaces = 0;
    std::uint64_t seed = 0;
    double rms_height = 0.0, rms_slope = 0.0;  ///< rms height and slope of the spectrum within its band [m], [1]
    synthesis::ExpectedRoughness made;         ///< roughness of every surface
    double largest_duality_gap = 0.0;
    std::vector<Alert> alerts;
};

/// surface: without failure.  progress: number of contacts solved, and their total; may throw to stop.
/// @throws as ComparisonRequest and persson::load_table(); InvalidArgument for pixels too coarse for the shortest wave
/// (four of them are needed) and a cell shorter than the longest.
[[nodiscard]] ContactComparison compare_contact(const study::SurfaceResult& surface, const ComparisonRequest& request,
                                                parallel::Threads threads = {},
                                                const std::function<void(Index, Index)>& progress = {});

}  // namespace setae::answers

template <>
struct setae::fields::Asked<setae::answers::ComparisonRequest> {
    using R = answers::ComparisonRequest;
    static constexpr std::array options{
        option<&R::pixels>("pixels", "points of each surface, 512 or 1024x512; at least four per shortest wavelength")
            .default_shown(),
        option<&R::cell>("cell", "extent of each surface").such_as("2 um").or_else("twice the longest wavelength"),
        option<&R::surfaces>("surfaces", "number of surfaces").within(domain::positive).default_shown(),
        option<&R::seed>("seed", "seed of the first surface; the others have the next ones").default_shown().advanced(),
        option<&R::tolerance>("tolerance", "largest relative duality gap of each contact")
            .within(domain::positive)
            .default_shown()
            .advanced(),
    };
};
