// SPDX-License-Identifier: GPL-3.0-or-later
#include "usual_mark.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

namespace setae::topography {
namespace {

constexpr double single_precision = 1e-7;

bool is_near(double number, double wanted) { return std::abs(number - wanted) <= single_precision * wanted; }

/// Only nines, to seven digits.
bool is_nines(double number) {
    constexpr std::size_t fewest = 3;
    const auto text = fmt::format("{:.6e}", number);
    std::string digits = text.substr(0, text.find('e'));
    std::erase(digits, '.');
    while (!digits.empty() && digits.back() == '0') digits.pop_back();
    const bool nines = std::all_of(digits.begin(), digits.end(), [](char c) { return c == '9'; });
    return nines && digits.size() >= fewest && is_near(number, std::stod(text));
}

}  // namespace

bool is_usual_mark(double number) {
    constexpr double logs_of_wells = 999.25;  // of the Log ASCII Standard
    constexpr double smallest = 99.0, any_from = 1e20, power_from = 1e4;
    number = std::abs(number);
    if (!(number >= smallest)) return false;
    if (number >= any_from || is_nines(number) || is_near(number, logs_of_wells)) return true;
    for (const double power : {0x1p15, 0x1p16, 0x1p31, 0x1p32})
        if (is_near(number, power) || is_near(number, power - 1.0)) return true;
    return number >= power_from * (1.0 - single_precision) &&
           is_near(number, std::pow(10.0, std::round(std::log10(number))));
}

}  // namespace setae::topography
