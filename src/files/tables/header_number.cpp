// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/header_number.hpp"

#include <cmath>

#include "setae/core/number_text.hpp"
#include "setae/core/text.hpp"

namespace setae::tables {
namespace {

template <class Number>
std::optional<Number> whole(std::string_view text) {
    text = trimmed(text);
    if (text.starts_with('+')) text.remove_prefix(1);
    return spelled<Number>(text);
}

}  // namespace

std::optional<double> finite_number(std::string_view text) {
    const auto value = whole<double>(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<Index> count_in(std::string_view text) {
    constexpr Index most = Index{1} << 40;
    const auto value = whole<Index>(text);
    return value && *value >= 0 && *value <= most ? value : std::nullopt;
}

}  // namespace setae::tables
