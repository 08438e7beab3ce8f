// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/answers/made_surface.hpp"
#include "setae/answers/surface_request.hpp"
#include "setae/fields/option.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/processing/pipeline.hpp"
#include "setae/topography/detrend.hpp"

namespace setae::answers {

/// Continuation of a map beyond its edges in a contact.
enum class BeyondMap {
    itself,   ///< the map again
    nothing,  ///< no contact: free edges, or a contact that ends within the map
};

/// Use of a measured map or line in a contact.
struct MeasuredSurfaceRequest {
    std::string trend;  ///< empty: study::trend_after()
    std::string edges = "automatic";

    /// @throws InvalidArgument for other words.
    void require_valid() const;
};

/// Preparation of measured heights, common to all contact commands.
///
/// 1. Heights are periodic where `edges` or their file states it, or where they continue across the seam as
///    inside (processing::seam_of). Nothing is subtracted from them unless a trend is requested.
/// 2. All others are levelled by study::trend_after(), as before a spectrum. The record names the step.
/// 3. For `edges` "windowed" they are reduced to their mean at the edges (processing::windowed) and are periodic then.
/// 4. Where a map that is not periodic is repeated, its metadata get the warning MAP_NOT_PERIODIC with the rms height
///    step at the seam.
///
/// read: heights and their processing by `pipeline`. recommended: the trend that their file recommends to remove.
/// Profiles are returned unchanged.
/// @throws InvalidArgument for other words, and as levelling does.
[[nodiscard]] processing::PipelineResult into_contact(processing::PipelineResult read,
                                                      const processing::Pipeline& pipeline,
                                                      std::optional<topography::Trend> recommended,
                                                      const MeasuredSurfaceRequest& request, BeyondMap beyond,
                                                      parallel::Threads threads = {});

/// Request of the surface of a contact.
struct ContactSurfaceRequest {
    MeasuredSurfaceRequest measured;  ///< for a map or a line that is read
    MadeSurfaceRequest made;          ///< for a surface that is generated from a spectrum or a study
};

/// The surface in contact: generated from a spectrum, or read; then processed, and prepared for the contact.
/// @throws InvalidArgument for a request of a generated surface in addition to a map, and as made_surface(),
/// into_contact(), reading and processing do.
[[nodiscard]] processing::PipelineResult contact_surface(const std::string& path, const FileRequest& file,
                                                         const processing::Pipeline& pipeline,
                                                         const ContactSurfaceRequest& request, BeyondMap beyond,
                                                         parallel::Threads threads = {});

/// Several that are made from a spectrum, seeds one after the other.
/// @throws InvalidArgument for several of a map.
[[nodiscard]] std::vector<processing::PipelineResult> contact_surfaces(const std::string& path, const FileRequest& file,
                                                                       const processing::Pipeline& pipeline,
                                                                       const ContactSurfaceRequest& request,
                                                                       BeyondMap beyond, int count,
                                                                       parallel::Threads threads = {});

}  // namespace setae::answers

template <>
struct setae::fields::Asked<setae::answers::MeasuredSurfaceRequest> {
    using R = answers::MeasuredSurfaceRequest;
    static constexpr std::array<std::string_view, 3> edges{"automatic", "periodic", "windowed"};
    static constexpr std::array options{
        answers::trend_option<&R::trend>("trend removed from measured heights: none, mean, tilt or parabola")
            .or_else("as before a spectrum, none for heights that repeat themselves"),
        option<&R::edges>(
            "edges",
            "edges of the map: repeated, with a warning if they differ (automatic), repeated (periodic), or brought to the mean height within a tenth (windowed)")
            .one_of(edges)
            .default_shown(),
    };
};
