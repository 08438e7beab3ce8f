// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/channel_remedy.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "setae/tables/column_guess.hpp"

namespace setae::study {
namespace {

using loops::ChannelFault;

constexpr std::string_view minus = "-1 * ";

bool is_one_column(std::string_view expression) { return expression.find_first_of("+-*/^() ") == std::string::npos; }

std::string reversed(const std::string& expression) {
    if (expression.starts_with(minus) && is_one_column(std::string_view(expression).substr(minus.size())))
        return expression.substr(minus.size());
    return std::string(minus) + (is_one_column(expression) ? expression : fmt::format("({})", expression));
}

}  // namespace

tables::ChosenColumns columns_that_undo(ChannelFault fault, const tables::ChannelNames& channels) {
    tables::ChosenColumns columns;
    const auto reverse = [&](const std::string& role) {
        if (const auto channel = channels.find(role); channel != channels.end())
            columns[role] = reversed(channel->second.expression);
    };
    if (fault == ChannelFault::force_reversed || fault == ChannelFault::both_reversed) reverse("force");
    if (fault == ChannelFault::displacement_reversed || fault == ChannelFault::both_reversed) reverse("displacement");
    const auto force = channels.find("force"), displacement = channels.find("displacement");
    if (fault != ChannelFault::swapped || force == channels.end() || displacement == channels.end()) return columns;
    const auto &f = force->second, &d = displacement->second;
    if (f.column.empty() || d.column.empty()) return columns;
    columns["force"] = fmt::format("{}[{}]", d.column, f.unit);
    columns["displacement"] = fmt::format("{}[{}]", f.column, d.unit);
    return columns;
}

std::string channel_remedy(ChannelFault fault, const tables::ChannelNames& channels) {
    const auto columns = columns_that_undo(fault, channels);
    return columns.empty() ? "check which column is the force and which the displacement"
                           : "use " + tables::column_option(columns);
}

}  // namespace setae::study
