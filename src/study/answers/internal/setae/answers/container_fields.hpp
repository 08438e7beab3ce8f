// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Containers, as the JSON of `setae container check` and `setae container write` has them.

#include <array>
#include <string>
#include <vector>

#include "setae/answers/containers.hpp"
#include "setae/fields/describe.hpp"

namespace setae::answers {

/// A measurement of a container, and its channel by number.
struct StoredMeasurementEntry {
    std::size_t index = 0;
    const formats::ContainerTopography* topography;
    const formats::ChannelInfo* channel;
};

/// A surface of a container.
struct StoredSurfaceEntry {
    const formats::ContainerSurface* surface;
    std::vector<StoredMeasurementEntry> measurements;
};
[[nodiscard]] inline std::vector<StoredSurfaceEntry> surfaces_of(const formats::ContainerReport& report) {
    std::vector<StoredSurfaceEntry> surfaces;
    std::size_t index = 0;
    for (const auto& surface : report.file.container.surfaces) {
        auto& entry = surfaces.emplace_back(StoredSurfaceEntry{&surface, {}});
        for (const auto& topography : surface.topographies) {
            entry.measurements.push_back({index, &topography, &report.channels[index]});
            ++index;
        }
    }
    return surfaces;
}

}  // namespace setae::answers

namespace setae::fields {

template <>
struct Described<answers::StoredMeasurementEntry> {
    using T = answers::StoredMeasurementEntry;
    static constexpr std::array rows{
        field<&T::index>("channel", "number of the channel within the file, counted from 0"),
        made<T>("name", "name of the measurement", [](const T& of) -> const auto& { return of.topography->name; }),
        made<T>("format", "identifier of the format", [](const T& of) -> const auto& { return of.channel->format; }),
        made<T>("shape", "number of points along x and y, or along a line",
                [](const T& of) -> const auto& { return of.channel->shape; }),
        made<T>("size", "extent along x and y, or along a line",
                [](const T& of) -> const auto& { return of.channel->size; })
            .in_unit("m"),
        made<T>("unit", "unit of the heights in the file", [](const T& of) -> const auto& { return of.channel->unit; }),
        made<T>("original", "member with the measured file",
                [](const T& of) -> const auto& { return of.topography->datafile.original; }),
        made<T>("processed_copy", "member with the heights that contact.engineering processed",
                [](const T& of) -> const auto& { return of.topography->datafile.squeezed; }),
        made<T>("detrend_mode", "detrending, as the container states it",
                [](const T& of) -> const auto& { return of.topography->detrend_mode; }),
        made<T>("measurement_date", "date of measurement, as the container states it",
                [](const T& of) -> const auto& { return of.topography->measurement_date; }),
        made<T>("readable", "whether the heights can be read", [](const T& of) { return of.channel->is_height; }),
    };
    static constexpr Description description{"", "a measurement of a container", rows};
};

template <>
struct Described<answers::StoredSurfaceEntry> {
    using T = answers::StoredSurfaceEntry;
    static constexpr std::array rows{
        made<T>("name", "name of the surface", [](const T& of) -> const auto& { return of.surface->name; }),
        made<T>("category", "category, as the container states it",
                [](const T& of) -> const auto& { return of.surface->category; }),
        made<T>("tags", "tags, as the container states them",
                [](const T& of) -> const auto& { return of.surface->tags; }),
        field<&T::measurements>("measurements", "measurements of the surface"),
        inner<&T::surface>(),
    };
    static constexpr Description description{"", "a surface of a container", rows};
};
static_assert(complete<answers::StoredSurfaceEntry>);

template <>
struct Described<answers::CheckedContainer> {
    using T = answers::CheckedContainer;
    static constexpr std::array rows{
        field<&T::file>("file", "name of the file as it was given"),
        made<T>("generation", "generation of the layout of the container",
                [](const T& of) { return formats::describe(of.report.file.generation); }),
        made<T>("created_at", "date of creation, as the container states it",
                [](const T& of) -> const auto& { return of.report.file.container.created_at; }),
        made<T>("surfaces", "surfaces of the container", [](const T& of) { return answers::surfaces_of(of.report); }),
        made<T>("alerts", "warnings", [](const T& of) -> const auto& { return of.report.alerts; }),
        made<T>("differences", "differences between the container and the container that setae writes from it",
                [](const T& of) -> const auto& { return of.report.differences; }),
        inner<&T::report>(),
    };
    static constexpr Description description{"", "content and problems of a container", rows};
};
static_assert(complete<answers::CheckedContainer>);

template <>
struct Described<answers::CheckedContainers> {
    using T = answers::CheckedContainers;
    static constexpr std::array rows{field<&T::containers>("containers", "containers in the order of the files")};
    static constexpr Description description{"", "contents and problems of containers", rows};
};
static_assert(complete<answers::CheckedContainers>);

template <>
struct Described<answers::WrittenContainer> {
    using T = answers::WrittenContainer;
    static constexpr std::array rows{
        field<&T::output>("output", "path of the container"),
        made<T>("surfaces", "number of surfaces", [](const T& of) { return of.draft.container.surfaces.size(); }),
        made<T>("measurements", "number of measurements", [](const T& of) { return of.measurements(); }),
        made<T>("members", "number of files in the container", [](const T& of) { return of.draft.members.size(); }),
        made<T>("alerts", "warnings", [](const T& of) -> const auto& { return of.draft.alerts; }),
        inner<&T::draft>(),
        inner<&T::failures>(),
    };
    static constexpr Description description{"", "contents that were written to a container", rows};
};
static_assert(complete<answers::WrittenContainer>);

}  // namespace setae::fields
