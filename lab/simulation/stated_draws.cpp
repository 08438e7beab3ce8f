// SPDX-License-Identifier: GPL-3.0-or-later
#include "stated_draws.hpp"

#include <fmt/format.h>

#include "name_hash.hpp"
#include "setae/numerics/random_numbers.hpp"

namespace setae::simulation {
namespace {

/// Beside the streams of measurements, loops and ranges.
constexpr std::uint64_t stated_streams = 1ull << 34;

double drawn_about(const Estimate& stated_value, numerics::RandomKey key) {
    if (!stated_value.uncertain()) return stated_value.value;
    if (const auto& range = stated_value.interval)
        return range->lower + (range->upper - range->lower) * numerics::uniform_number(key, 0);
    return stated_value.value + stated_value.standard_error * numerics::normal_number(key, 0);
}

bool alike(const Estimate& a, const Estimate& b) {
    return a.value == b.value && a.standard_error == b.standard_error &&
           a.interval.has_value() == b.interval.has_value();
}

}  // namespace

StatedQuantity StatedDraws::required(bytes::TomlReader& reader, const std::string& table, const char* key,
                                     const Expected& expected, const std::string& input) {
    const auto unit = expected.dimension == dimension::none ? "" : si_unit(expected.dimension);
    return drawn({.stated_value = reader.required_uncertain(key, expected), .unit = unit, .input = input},
                 table + "." + key, reader, key);
}

StatedQuantity StatedDraws::drawn(StatedQuantity quantity, const std::string& place, const bytes::TomlReader& reader,
                                  const char* key) {
    const auto& scope = quantity.input.empty() ? place : quantity.input;
    const auto [at, fresh] = scopes_.try_emplace(scope, StatedScope{quantity, place});
    const auto& first = at->second;
    if (!fresh && !alike(first.quantity.stated_value, quantity.stated_value))
        reader.fail(key, fmt::format("'{}' is {} here and {} at {}; expected one value, or another name", scope,
                                     stated_text(quantity), stated_text(first.quantity), first.place));
    const auto stream = numerics::substream({.seed = seed_}, stated_streams);
    quantity.value = drawn_about(quantity.stated_value, numerics::substream(stream, name_hash(scope)));
    if (quantity.stated_value.uncertain() && !(quantity.value > 0.0))
        reader.fail(key, fmt::format("{} was drawn as {}, which must be above 0; give a smaller ±",
                                     stated_text(quantity), quantity.value));
    return quantity;
}

std::string stated_text(const Estimate& stated_value, const std::string& unit) {
    const std::string behind = unit.empty() ? "" : " " + unit;
    if (!stated_value.uncertain()) return fmt::format("{:.9g}{}", stated_value.value, behind);
    if (const auto& range = stated_value.interval)
        return fmt::format("{:.9g} to {:.9g}{}", range->lower, range->upper, behind);
    return fmt::format("{:.9g} ± {:.9g}{}", stated_value.value, stated_value.standard_error, behind);
}

}  // namespace setae::simulation
