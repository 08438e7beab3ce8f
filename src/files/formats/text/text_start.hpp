// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/tables/text_numbers.hpp"

namespace setae::formats {

/// Start of the numbers of a text, from as many bytes as needed for a whole row. Empty if there is no row.
[[nodiscard]] std::optional<tables::TextStart> find_start(const bytes::Source& source);

/// While it exists, find_start(source) of this thread reads the text once: every text format calls it for detection,
/// and the format that opens the file calls it again.
class KeptStart {
public:
    explicit KeptStart(const bytes::Source& source);
    KeptStart(const KeptStart&) = delete;
    KeptStart& operator=(const KeptStart&) = delete;
    ~KeptStart();

private:
    friend std::optional<tables::TextStart> find_start(const bytes::Source& source);

    const bytes::Source& source_;
    std::optional<std::optional<tables::TextStart>> start_;  ///< empty before the first call
    KeptStart* const outer_;
};

}  // namespace setae::formats
