// SPDX-License-Identifier: GPL-3.0-or-later
#include "keys.hpp"

#include <cmath>

namespace setae::study {

void remark_implausible(bytes::TomlReader& reader, const char* key, double value, double lower, double upper,
                        const std::string& unit) {
    if (value == 0.0 || (value >= lower && value <= upper)) return;
    // units are never wrong by so much: such a value is invalid
    constexpr double max_factor_off = 1e12;
    const auto in_unit = [&](double number) { return format_value(number, unit.empty() ? "1" : unit, 3); };
    if (value < lower / max_factor_off || value > upper * max_factor_off)
        reader.fail(key, std::isinf(upper) ? fmt::format("{}, expected {} or above", in_unit(value), in_unit(lower))
                                           : fmt::format("{}, expected 0, or {} to {}", in_unit(value), in_unit(lower),
                                                         in_unit(upper)));
    const double nearest = value < lower ? lower : upper;
    const double thousands = std::log10(nearest / value) / 3.0;
    const double power = 3.0 * (thousands > 0.0 ? std::ceil(thousands) : std::floor(thousands));
    const double corrected = value * std::pow(10.0, power);
    const std::string factor = corrected >= lower && corrected <= upper
                                   ? fmt::format(": the likely factor is 10^{:.0f}", power)
                                   : std::string();
    const auto range = std::isinf(upper) ? fmt::format("is below {}", in_unit(lower))
                                         : fmt::format("lies outside {} to {}", in_unit(lower), in_unit(upper));
    reader.warn(key, fmt::format("{} {}{}", in_unit(value), range, factor));
}

}  // namespace setae::study
