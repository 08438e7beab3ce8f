// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace setae::report {

/// A part of a page under a heading that opens and closes it: a reader's click, a link to it, printing.
struct Fold {
    std::string identifier;  ///< identifier of the part, for links; unique
    std::string kind;        ///< class in the style sheet
    std::string title;       ///< HTML
    std::string remark;      ///< HTML after the title, such as "16 rows"; may be empty
    std::string html;        ///< folded content
    int level = 3;           ///< level of the heading
    bool open = false;       ///< whether it is unfolded initially
};
[[nodiscard]] std::string as_html(const Fold& fold);

/// The same part, always open.
[[nodiscard]] std::string unfolded_html(const Fold& part);

}  // namespace setae::report
