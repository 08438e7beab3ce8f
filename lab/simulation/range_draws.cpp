// SPDX-License-Identifier: GPL-3.0-or-later
#include "range_draws.hpp"

#include <cmath>

#include <fmt/format.h>

#include "name_hash.hpp"

namespace setae::simulation {
namespace {

/// Beside the streams of measurements and loops.
constexpr std::uint64_t range_streams = 1ull << 33;

}  // namespace

RangeDraws::RangeDraws(std::uint64_t seed, const std::string& table)
    : key_(numerics::substream(numerics::substream({.seed = seed}, range_streams), name_hash(table))) {}

std::optional<double> RangeDraws::quantity(bytes::TomlReader& reader, const char* key,
                                           const Dimension& dimension) const {
    if (!reader.is_list(key)) return reader.quantity(key, dimension);
    const auto range = reader.quantities(key, dimension);
    if (range.size() != 2)
        reader.fail(key, fmt::format("a list of {} numbers; expected one number, or a range [from, to]", range.size()));
    const double from = range[0], to = range[1];
    if (!(from > 0.0 && from <= to && std::isfinite(to)))
        reader.fail(key, fmt::format("range from {} to {} {}; expected 0 < from <= to", from, to, si_unit(dimension)));
    if (from == to) return from;
    return from * std::pow(to / from, numerics::uniform_number(key_, name_hash(key)));
}

double RangeDraws::required(bytes::TomlReader& reader, const char* key, const Dimension& dimension) const {
    if (const auto value = quantity(reader, key, dimension)) return *value;
    return reader.required_uncertain(key, dimension).value;
}

}  // namespace setae::simulation
