// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Converted files, as the JSON of `setae convert` has them.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "setae/fields/describe.hpp"

namespace setae::answers {

/// A channel that was written to a file.
struct ConvertedFile {
    std::string input, output;
    std::string channel;  ///< name of the channel
};

/// Channels of several files, or several channels of a file.
struct ConvertedFiles {
    std::vector<ConvertedFile> files;
};

}  // namespace setae::answers

template <>
struct setae::fields::Described<setae::answers::ConvertedFile> {
    using T = answers::ConvertedFile;
    static constexpr std::array rows{
        field<&T::input>("input", "name of the input as it was given"),
        field<&T::output>("output", "path of the file that was written"),
        field<&T::channel>("channel", "name of the channel"),
        made<T>("unit", "unit of the heights that were written", [](const T&) { return std::string_view("m"); }),
    };
    static constexpr Description description{"", "file that was written, for one input and one channel", rows};
};
static_assert(setae::fields::complete<setae::answers::ConvertedFile>);

template <>
struct setae::fields::Described<setae::answers::ConvertedFiles> {
    using T = answers::ConvertedFiles;
    static constexpr std::array rows{field<&T::files>("files", "files that were written, one per channel")};
    static constexpr Description description{"", "files that were written to a folder or from all channels", rows};
};
static_assert(setae::fields::complete<setae::answers::ConvertedFiles>);
