// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include <fmt/format.h>

#include "setae/core/units.hpp"
#include "setae/topography/no_data.hpp"

namespace setae::topography {
namespace {

/// A height as in its file: "-9999 µm".
std::string height_text(double height, const std::string& unit) {
    return fmt::format("{:.7g} {}", height / unit_factor(unit, dimension::length), unit);
}

/// A height with as many digits as needed to restore the number.
std::string exact_height_text(double height, const std::string& unit) {
    const double factor = unit_factor(unit, dimension::length), number = height / factor;
    for (int digits = 7; digits < 17; ++digits) {
        const auto text = fmt::format("{:.{}g}", number, digits);
        if (std::stod(text) * factor == height) return fmt::format("{} {}", text, unit);
    }
    return fmt::format("{} m", height);
}

}  // namespace

std::vector<Alert> alerts_of(const NoDataReport& report, const std::string& subject, const std::string& unit) {
    std::vector<Alert> alerts;
    for (const auto& mark : report.values) {
        const auto value = height_text(mark.value, unit);
        const double percent = 100.0 * static_cast<double>(mark.count) / static_cast<double>(report.defined);
        const auto found = fmt::format("{} of {} heights ({:.2g} %) {} {}, the others {} to {}", mark.count,
                                       report.defined, percent, mark.count == 1 ? "is" : "are exactly", value,
                                       height_text(report.least, unit), height_text(report.greatest, unit));
        if (mark.no_height)
            alerts.push_back({"NO_DATA", subject, found + ": this value marks missing heights, which are now undefined",
                              "if they are heights, set `keep_values`"});
        else
            alerts.push_back({"NO_DATA_SUSPECTED", subject,
                              found + ": this value may mark missing heights; it was kept as a height",
                              fmt::format("if it is not a height, add the step `undefine value=\"{}\"`",
                                          exact_height_text(mark.value, unit))});
    }
    return alerts;
}

}  // namespace setae::topography
