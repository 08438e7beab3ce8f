// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A traced contour, as its file and the JSON of `setae contour` have it.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "setae/fields/describe.hpp"
#include "setae/output/contour_file.hpp"
#include "setae/study/contours.hpp"
#include "setae/study/provenance.hpp"

namespace setae::output {

/// A segment of the contour, and its profile.
struct SegmentEntry {
    const imaging::ContourSegment* segment;
    const study::ContourProfile* profile;
};

/// A picture with its traces, and the options that reproduce them.
struct ContourEntry {
    const study::TracedPicture* picture;
    const study::ContourOptions* options;

    [[nodiscard]] std::string title() const {
        const auto& micrograph = picture->micrograph;
        return micrograph.images.empty() ? std::string() : micrograph.images[micrograph.image].title;
    }
    [[nodiscard]] std::vector<std::array<long, 4>> hidden() const {
        std::vector<std::array<long, 4>> regions;
        for (const auto& r : options->trace.hidden) regions.push_back({r.x, r.y, r.width, r.height});
        return regions;
    }
    [[nodiscard]] std::vector<std::vector<std::array<double, 2>>> anchors() const {
        std::vector<std::vector<std::array<double, 2>>> lists;
        for (const auto& anchors : options->trace.anchors) {
            auto& list = lists.emplace_back();
            for (const auto& anchor : anchors) list.push_back({anchor.x, anchor.y});
        }
        return lists;
    }
    [[nodiscard]] std::vector<SegmentEntry> segments() const {
        std::vector<SegmentEntry> entries;
        for (std::size_t i = 0; i < picture->trace.segments.size(); ++i)
            entries.push_back({&picture->trace.segments[i], &picture->profiles[i]});
        return entries;
    }
};

}  // namespace setae::output

namespace setae::fields {

template <>
struct Described<topography::ReentrantStretch> {
    using T = topography::ReentrantStretch;
    static constexpr std::array rows{
        field<&T::begin>("begin", "position along the edge where the overhang begins").in_unit("m"),
        field<&T::end>("end", "position along the edge where the overhang ends").in_unit("m"),
        field<&T::depth>("depth", "distance by which the edge turns back along x").in_unit("m"),
    };
    static constexpr Description description{"", "a part of the edge that is an overhang", rows};
};
static_assert(complete<topography::ReentrantStretch>);

template <>
struct Described<topography::ParametricStatistics> {
    using T = topography::ParametricStatistics;
    static constexpr std::array rows{
        field<&T::length>("length", "length along the edge; of a closed outline its perimeter").in_unit("m"),
        field<&T::tortuosity>("tortuosity", "length over the distance of the ends; null for a closed outline")
            .in_unit("1"),
        field<&T::rms_normal_distance>("rms_normal_distance", "rms distance from the mean line").in_unit("m"),
        field<&T::rms_angle>("rms_angle", "rms angle between the edge and the mean line").in_unit("rad"),
        field<&T::rms_curvature>("rms_curvature", "rms curvature, with the noise of the trace").in_unit("1/m"),
        field<&T::reentrant_share>("reentrant_share", "share of the length that overhangs hide from above")
            .in_unit("1"),
    };
    static constexpr Description description{"", "statistics of the edge as a curve", rows};
};
static_assert(complete<topography::ParametricStatistics>);

template <>
struct Described<output::SegmentEntry> {
    using T = output::SegmentEntry;
    static constexpr std::array rows_of_profile{
        made<T>("points", "number of points",
                [](const T& of) { return of.profile->levelled.profile.positions.size(); }),
        made<T>("length", "length of the profile along x",
                [](const T& of) { return of.profile->levelled.profile.size(); })
            .in_unit("m"),
        made<T>("rotation", "angle by which the edge was turned to its mean line, counterclockwise",
                [](const T& of) { return of.profile->levelled.rotation; })
            .in_unit("rad"),
        made<T>("rms_height", "rms height Rq, without the contribution of noise",
                [](const T& of) { return of.profile->rms_height; })
            .in_unit("m"),
        made<T>("rms_error", "rms of the standard errors of heights", [](const T& of) { return of.profile->rms_error; })
            .in_unit("m"),
        made<T>("reentrant_share", "share of the length that is in overhangs",
                [](const T& of) { return of.profile->levelled.reentrant_share; })
            .in_unit("1"),
        made<T>("reentrant", "overhanging parts of the edge",
                [](const T& of) -> const auto& { return of.profile->levelled.reentrant; }),
    };
    static constexpr Description profile{"", "heights above the mean line", rows_of_profile};
    static constexpr std::array rows{
        made<T>("length", "length along the edge", [](const T& of) { return of.segment->length; }).in_unit("px"),
        made<T>("points", "number of points", [](const T& of) { return of.segment->x.size(); }),
        made<T>("closed", "whether the edge is a closed outline", [](const T& of) { return of.segment->closed; }),
        made<T>("edge_width", "standard deviation of the blur across the edge",
                [](const T& of) { return of.segment->edge_width; })
            .in_unit("px"),
        made<T>("smoothing_length", "smoothing length along the edge",
                [](const T& of) { return of.segment->smoothing_length; })
            .in_unit("px"),
        made<T>("noise_density", "noise density of positions along the edge, before smoothing",
                [](const T& of) { return of.segment->noise_density; })
            .in_unit("px3"),
        made<T>("contrast_to_noise", "grey-level step of the edge over the noise of a pixel",
                [](const T& of) { return of.segment->contrast_to_noise; })
            .in_unit("1"),
        made<T>("fringe", "whether a Fresnel fringe was detected", [](const T& of) { return of.segment->fringe; }),
        made<T>("converged", "whether the iteration converged", [](const T& of) { return of.segment->converged; }),
        made<T>("mean_standard_error", "mean standard error of positions along the normal",
                [](const T& of) { return of.segment->standard_error.mean(); })
            .in_unit("px"),
        part<T>("profile", "heights above the mean line", profile),
        made<T>("curve", "statistics of the edge as a curve",
                [](const T& of) -> const auto& { return of.profile->statistics; }),
    };
    static constexpr Description description{"", "a section of the edge", rows};
};

template <>
struct Described<output::ContourEntry> {
    using T = output::ContourEntry;
    static constexpr std::array<std::string_view, 1> formats{output::trace_format};
    static constexpr std::array rows_of_image{
        made<T>("file", "name of the file as it was given",
                [](const T& of) -> const auto& { return of.picture->micrograph.file; }),
        made<T>("sha256", "SHA-256 of the bytes of the file",
                [](const T& of) -> const auto& { return of.picture->digest; }),
        made<T>("width", "width in pixels", [](const T& of) { return of.picture->micrograph.pixels.cols(); }),
        made<T>("height", "height in pixels", [](const T& of) { return of.picture->micrograph.pixels.rows(); }),
        made<T>("format", "identifier of the format",
                [](const T& of) -> const auto& { return of.picture->micrograph.format; }),
        made<T>("image", "number of the image within the file, counted from 0",
                [](const T& of) { return of.picture->micrograph.image; }),
        made<T>("title", "title of the image in the file; empty without a title",
                [](const T& of) { return of.title(); }),
    };
    static constexpr Description image{"", "picture that was traced", rows_of_image};
    static constexpr std::array rows_of_calibration{
        made<T>("pixel_size", "width and height of a pixel",
                [](const T& of) {
                    const auto& size = of.picture->calibration.pixel_size;
                    return std::array{size.x, size.y};
                })
            .in_unit("m"),
        made<T>("relative_standard_error", "relative standard error of the pixel size",
                [](const T& of) { return of.picture->calibration.relative_standard_error; })
            .in_unit("1"),
        made<T>("source", "source of the pixel size",
                [](const T& of) -> const auto& { return of.picture->calibration.source; }),
    };
    static constexpr Description calibration{"", "size of a pixel and its standard error", rows_of_calibration};
    static constexpr std::array rows_of_options{
        made<T>("vacuum", "side of the picture that is vacuum, as requested",
                [](const T& of) { return output::to_string(of.options->trace.vacuum); })
            .one_of(output::vacuum_words),
        made<T>("smoothing_length", "smoothing length along the edge; null where it follows from the picture",
                [](const T& of) { return of.options->trace.smoothing_length; })
            .or_null()
            .in_unit("px"),
        made<T>("denoise", "standard deviation of the Gaussian that smooths the picture",
                [](const T& of) { return of.options->trace.denoise; })
            .in_unit("px"),
        made<T>("least_length", "shortest length of a section that is kept; null where it follows from the picture",
                [](const T& of) { return of.options->trace.min_length; })
            .or_null()
            .in_unit("px"),
        made<T>("hidden", "parts of the picture that are left out: x, y, width, height of each",
                [](const T& of) { return of.hidden(); })
            .in_unit("px"),
        made<T>("hide_annotations", "whether scale bars and text are left out",
                [](const T& of) { return of.options->hide_annotations; }),
        made<T>("shape", "treatment of overhangs in the profile",
                [](const T& of) { return output::to_string(of.options->shape); })
            .one_of(output::shape_words),
        made<T>("foil_thickness", "thickness of the sample along the beam; null where it is not given",
                [](const T& of) { return of.options->foil_thickness; })
            .or_null()
            .in_unit("m"),
    };
    static constexpr Description options{"", "options of the tracing", rows_of_options};
    static constexpr std::array rows_of_levels{
        made<T>("vacuum", "side of the picture that is vacuum, as found",
                [](const T& of) { return output::to_string(of.picture->trace.vacuum); })
            .one_of(output::vacuum_words),
        made<T>("binary", "whether the picture has two grey levels",
                [](const T& of) { return of.picture->trace.binary; }),
        made<T>("vacuum_level", "median grey level of the vacuum",
                [](const T& of) { return of.picture->trace.vacuum_level; }),
        made<T>("vacuum_noise", "standard deviation of the grey level of the vacuum",
                [](const T& of) { return of.picture->trace.vacuum_noise; }),
        made<T>("sample_level", "median grey level of the sample",
                [](const T& of) { return of.picture->trace.sample_level; }),
        made<T>("sample_noise", "standard deviation of the grey level of the sample, with the structure of the sample",
                [](const T& of) { return of.picture->trace.sample_noise; }),
    };
    static constexpr Description levels{"", "grey levels on both sides of the edge", rows_of_levels};
    static constexpr std::array rows{
        made<T>("format", "format of the file", [](const T&) { return output::trace_format; }).one_of(formats),
        made<T>("version", "version of the layout of the file", [](const T&) { return output::trace_version; }),
        part<T>("image", "picture that was traced", image),
        part<T>("calibration", "size of a pixel and its standard error", calibration),
        part<T>("options", "options of the tracing", options),
        made<T>("anchors", "points through which the edge passes: x and y of each, one list per section of the edge",
                [](const T& of) { return of.anchors(); })
            .in_unit("px"),
        part<T>("levels", "grey levels on both sides of the edge", levels),
        made<T>("segments", "sections of the edge", [](const T& of) { return of.segments(); }),
        made<T>("alerts", "warnings", [](const T& of) -> const auto& { return of.picture->alerts; }),
        made<T>("setae", "version of the program", [](const T&) { return study::version(); }),
    };
    static constexpr Description description{"", "options that reproduce a traced contour, and its results", rows};
};

}  // namespace setae::fields
