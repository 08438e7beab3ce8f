// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The draft of a study, as the JSON of `setae study init` has it.

#include <array>
#include <string>

#include "setae/fields/describe.hpp"
#include "setae/study/study_draft.hpp"

namespace setae::answers {

/// A draft and its file.
struct DraftEntry {
    std::string file;
    const study::StudyDraft* draft;
};

}  // namespace setae::answers

template <>
struct setae::fields::Described<setae::study::UnreadablePath> {
    using T = study::UnreadablePath;
    static constexpr std::array rows{
        field<&T::path>("file", "name of the file as it was given"),
        field<&T::reason>("reason", "reason for which the file is left out"),
    };
    static constexpr Description description{"", "a file that is left out", rows};
};
static_assert(setae::fields::complete<setae::study::UnreadablePath>);

template <>
struct setae::fields::Described<setae::answers::DraftEntry> {
    using T = answers::DraftEntry;
    static constexpr std::array rows{
        field<&T::file>("study", "path of the draft"),
        made<T>("surfaces", "number of surfaces", [](const T& of) { return of.draft->surfaces; }),
        made<T>("measurements", "number of measurements", [](const T& of) { return of.draft->measurements; }),
        made<T>("loops", "number of loops", [](const T& of) { return of.draft->loops; }),
        made<T>("micrographs", "number of micrographs", [](const T& of) { return of.draft->micrographs; }),
        made<T>("left_out", "files without a surface or a loop",
                [](const T& of) -> const auto& { return of.draft->left_out; }),
        made<T>("passed_over", "files of folders that setae wrote: figures, tables, reports",
                [](const T& of) -> const auto& { return of.draft->own; }),
    };
    static constexpr Description description{"", "draft of a study", rows};
};
