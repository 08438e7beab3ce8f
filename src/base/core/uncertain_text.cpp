// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/core/uncertain_text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/display_unit.hpp"
#include "setae/core/units.hpp"

namespace setae {
namespace {

constexpr int digits_of_errors = 2, digits_without_error = 4;

/// Power of ten of the first digit of a number rounded to so many digits.
int exponent_of(double value, int digits) {
    const auto text = fmt::format("{:.{}e}", value, digits - 1);
    return std::stoi(text.substr(text.find('e') + 1));
}

/// Numbers of one estimate, written to the same place.
struct Place {
    int decimals = 0;  ///< < 0: tens, hundreds
    int power = 0;     ///< of ten, a common factor

    [[nodiscard]] std::string operator()(double value) const {
        const double unit = std::pow(10.0, -std::min(decimals, 0));
        const double rounded = decimals < 0 ? std::round(value / unit) * unit : value;
        auto text = fmt::format("{:.{}f}", rounded, std::max(decimals, 0));
        // −0.00 is 0.00
        if (text.front() == '-' && text.find_first_of("123456789") == std::string::npos) text.erase(0, 1);
        return text;
    }
};

/// Error that sets the place: the standard error, or half the half width of the interval if there is none.
double error_of(const Estimate& estimate) {
    if (estimate.uncertain()) return estimate.standard_error;
    return estimate.interval ? (estimate.interval->upper - estimate.interval->lower) / 4.0 : undefined;
}

Place place_of(const Estimate& estimate) {
    const double error = error_of(estimate);
    const bool known = error > 0.0 && std::isfinite(error);
    const double largest = std::max(std::abs(estimate.value), known ? error : 0.0);
    const double decisive = known ? error : std::abs(estimate.value);
    if (!(decisive > 0.0)) return {.decimals = 0};
    const int last = exponent_of(decisive, known ? digits_of_errors : digits_without_error) -
                     (known ? digits_of_errors : digits_without_error) + 1;
    const int first = exponent_of(largest, digits_without_error);
    const int power = first < -3 || first >= 6 ? first : 0;
    return {.decimals = power - last, .power = power};
}

Estimate in_units_of(const Estimate& estimate, double factor) { return scaled(estimate, 1.0 / factor); }

std::string with_power(const std::string& text, const Place& place) {
    if (place.power == 0) return text;
    const bool several = text.find(' ') != std::string::npos;
    return fmt::format("{}×10{}", several ? "(" + text + ")" : text, superscript(place.power));
}

/// Parts of an estimate that are written.
struct Parts {
    bool error = false, interval = false;
};

std::string written(const Estimate& in_si, double factor, Parts parts) {
    if (std::isnan(in_si.value)) return "–";
    if (std::isinf(in_si.value)) return in_si.value > 0 ? "infinite" : "−infinite";
    const auto place = place_of(in_units_of(in_si, factor));
    const auto estimate = in_units_of(in_si, factor * std::pow(10.0, place.power));
    auto text = place(estimate.value);
    const auto interval = parts.interval ? interval_of(estimate) : std::nullopt;
    if (std::isinf(estimate.standard_error)) text += " ± infinite";
    else if (estimate.uncertain() && (parts.error || !interval)) text += " ± " + place(estimate.standard_error);
    if (interval) text += fmt::format(" [{}, {}]", place(interval->lower), place(interval->upper));
    return with_power(text, place);
}

std::string with_unit(const Estimate& estimate, std::string_view si_unit, Parts parts) {
    const double error = error_of(estimate);
    const auto unit =
        display_unit(error > std::abs(estimate.value) && std::isfinite(error) ? error : estimate.value, si_unit);
    const auto number = written(estimate, unit.factor, parts);
    return unit.name == "1" || !std::isfinite(estimate.value) ? number : number + " " + unit.name;
}

}  // namespace

std::string uncertain_number(const Estimate& estimate, double factor) {
    return written(estimate, factor, {.error = true});
}

std::string number_with_interval(const Estimate& estimate, double factor) {
    return written(estimate, factor, {.interval = true});
}

std::string full_number(const Estimate& estimate, double factor) {
    return written(estimate, factor, {.error = true, .interval = true});
}

std::string format_uncertain(const Estimate& estimate, std::string_view si_unit) {
    return with_unit(estimate, si_unit, {.error = true});
}

std::string format_interval(const Estimate& estimate, std::string_view si_unit) {
    return with_unit(estimate, si_unit, {.interval = true});
}

std::string format_full(const Estimate& estimate, std::string_view si_unit) {
    return with_unit(estimate, si_unit, {.error = true, .interval = true});
}

std::string probability_text(double probability) {
    if (std::isnan(probability)) return "–";
    if (probability == 0.0 || probability >= 1e-3) return fmt::format("{:.2g}", probability);
    const int power = exponent_of(probability, 1);
    return fmt::format("{:.0f}·10{}", probability / std::pow(10.0, power), superscript(power));
}

}  // namespace setae
