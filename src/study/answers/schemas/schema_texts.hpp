// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

/// The schemas in this folder, included in the program at build time.
namespace setae::answers::schemas {

struct NamedText {
    std::string_view name;  ///< name of the file, without ending
    std::string_view text;
};

extern const std::span<const NamedText> texts;

}  // namespace setae::answers::schemas
