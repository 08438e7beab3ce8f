// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/tables/text_numbers.hpp"

namespace setae::formats {

/// Where the numbers of a text begin, from its first bytes: as many as it takes to see a whole row. Nothing where no
/// row is found.
[[nodiscard]] std::optional<tables::TextStart> find_start(const bytes::Source& source);

/// While it lives, find_start(source) of this thread looks once: every format of texts asks it whether the file is its
/// own, and the one that opens it asks again.
class KeptStart {
public:
    explicit KeptStart(const bytes::Source& source);
    KeptStart(const KeptStart&) = delete;
    KeptStart& operator=(const KeptStart&) = delete;
    ~KeptStart();

private:
    friend std::optional<tables::TextStart> find_start(const bytes::Source& source);

    const bytes::Source& source_;
    std::optional<std::optional<tables::TextStart>> start_;  ///< nothing before it was asked for
    KeptStart* const outer_;
};

}  // namespace setae::formats
