// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "setae/answers/surface_request.hpp"
#include "setae/fields/option.hpp"
#include "setae/formats/container_draft.hpp"

namespace setae::answers {

/// Request of `setae container write`: contents of a container. Metadata missing in files are given for all, "um", or
/// for one, "FILE=um".
struct ContainerRequest {
    std::vector<std::string> files;  ///< measured ones become one surface, containers keep theirs
    std::vector<std::string> from;
    std::string output, name, description, as;
    std::vector<std::string> sizes, units, channels, trends;
    bool keep_values = false;
    bool every_file = false;  ///< the first that cannot be read is thrown, and nothing is written
};

/// A container that was written; without surfaces nothing was.
struct WrittenContainer {
    std::string output;
    formats::ContainerDraft draft;
    std::vector<std::string> failures;  ///< failures of files that could not be read

    [[nodiscard]] std::size_t measurements() const;
    /// Whether all named contents are included and can be read.
    [[nodiscard]] bool complete() const;
};

/// @throws InvalidArgument for no output, nothing to put in, a value of a file that is not named; FileError.
[[nodiscard]] WrittenContainer write_container(const ContainerRequest& request);

/// @throws InvalidArgument where nothing was written.
void require_written(const WrittenContainer& written);

/// A container that was checked.
struct CheckedContainer {
    std::string file;
    formats::ContainerReport report;
};

/// The answer of `setae container check`.
struct CheckedContainers {
    std::vector<CheckedContainer> containers;
};

/// Whether something cannot be read, or is not the same after writing.
[[nodiscard]] bool at_fault(const formats::ContainerReport& report);

}  // namespace setae::answers

template <>
struct setae::fields::Asked<setae::answers::ContainerRequest> {
    using R = answers::ContainerRequest;
    static constexpr std::array options{
        option<&R::name>("name", "name of the surface that measured files become").or_else("that of the output"),
        option<&R::description>("description", "description of the surface that measured files become"),
        option<&R::from>("from", "containers and studies (.toml) whose surfaces are taken over")
            .in_python("taken_over"),
        option<&R::sizes>("size", "extent where files do not state it, of all files or of one as \"FILE=1 mm x 1 mm\"")
            .such_as("1 mm x 1 mm"),
        option<&R::units>("unit", "unit of lengths where files do not state it, of all files or of one as FILE=um")
            .such_as("um"),
        option<&R::channels>("channel",
                             "channel by its number, counted from 0, or by its name, of all files or of one as FILE=1")
            .or_else("the preferred channel"),
        option<&R::trends>("detrend",
                           "trend to be removed: mean, tilt or parabola, of all files or of one as FILE=tilt")
            .or_else("mean"),
        answers::layout_option<&R::as>(),
        answers::keep_values_option<&R::keep_values>(),
    };
};
