// SPDX-License-Identifier: GPL-3.0-or-later
#include "stated_draws.hpp"

#include <fmt/format.h>

#include "name_hash.hpp"
#include "setae/numerics/random_numbers.hpp"

namespace setae::simulation {
namespace {

/// Beside the streams of measurements, loops and ranges.
constexpr std::uint64_t stated_streams = 1ull << 34;

double drawn(const Estimate& told, numerics::RandomKey key) {
    if (!told.uncertain()) return told.value;
    if (const auto& range = told.interval)
        return range->lower + (range->upper - range->lower) * numerics::uniform_number(key, 0);
    return told.value + told.standard_error * numerics::normal_number(key, 0);
}

bool alike(const Estimate& a, const Estimate& b) {
    return a.value == b.value && a.standard_error == b.standard_error && a.interval.has_value() == b.interval.has_value();
}

}  // namespace

StatedQuantity StatedDraws::required(bytes::TomlReader& reader, const std::string& table, const char* key,
                                     const Expected& expected, const std::string& input) {
    return of(reader.required_uncertain(key, expected), input, table + "." + key, reader, key);
}

StatedQuantity StatedDraws::of(const Estimate& told, const std::string& input, const std::string& place,
                               const bytes::TomlReader& reader, const char* key) {
    const auto& scope = input.empty() ? place : input;
    const auto [first, fresh] = told_.try_emplace(scope, Told{told, place});
    if (!input.empty() && !fresh && !alike(first->second.value, told))
        reader.fail(key, fmt::format("'{}' is {} here and {} at {}; expected one value, or another name", input,
                                     told_text(told, "in SI"), told_text(first->second.value, "in SI"),
                                     first->second.place));
    const auto stream = numerics::substream({.seed = seed_}, stated_streams);
    StatedQuantity quantity{drawn(told, numerics::substream(stream, name_hash(scope))), told, input};
    if (told.uncertain() && !(quantity.value > 0.0))
        reader.fail(key, fmt::format("{} was drawn as {}; expected a ± that keeps it above 0, so give a smaller one",
                                     told_text(told, "in SI"), quantity.value));
    return quantity;
}

std::string told_text(const Estimate& told, const std::string& unit) {
    const std::string behind = unit.empty() ? "" : " " + unit;
    if (!told.uncertain()) return fmt::format("{:.9g}{}", told.value, behind);
    if (const auto& range = told.interval) return fmt::format("{:.9g} to {:.9g}{}", range->lower, range->upper, behind);
    return fmt::format("{:.9g} ± {:.9g}{}", told.value, told.standard_error, behind);
}

}  // namespace setae::simulation
