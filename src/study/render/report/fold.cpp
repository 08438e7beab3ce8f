// SPDX-License-Identifier: GPL-3.0-or-later
#include "fold.hpp"

#include <fmt/format.h>

namespace setae::report {
namespace {

std::string heading_of(const Fold& part) {
    return fmt::format("<h{0} id=\"{1}-title\">{2}</h{0}>{3}", part.level, part.identifier, part.title,
                       part.remark.empty() ? "" : " <span class=\"count\">" + part.remark + "</span>");
}

/// A region named by its heading.
std::string section_html(const Fold& part, const std::string& html) {
    return fmt::format("<section class=\"{0}\" id=\"{1}\" aria-labelledby=\"{1}-title\">{2}</section>\n", part.kind,
                       part.identifier, html);
}

}  // namespace

std::string as_html(const Fold& fold) {
    return section_html(fold, "<details" + std::string(fold.open ? " open" : "") + "><summary>" + heading_of(fold) +
                                  "</summary>" + fold.html + "</details>");
}

std::string unfolded_html(const Fold& part) { return section_html(part, heading_of(part) + part.html); }

}  // namespace setae::report
