// SPDX-License-Identifier: GPL-3.0-or-later
#include "axes.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace setae::file_figures {
namespace {

double largest(const Array1D& values) {
    double most = 0.0;
    for (const double value : values)
        if (std::isfinite(value)) most = std::max(most, std::abs(value));
    return most;
}

}  // namespace

DisplayUnit axis_unit(const Array1D& values, std::string_view si_unit) {
    const double most = largest(values);
    if (si_unit == "m2") {
        const auto length = display_unit(std::sqrt(most), "m");
        return {length.factor * length.factor, length.name + "2"};
    }
    if (si_unit == "1/m" && most > 0.0) {
        const auto length = display_unit(1.0 / most, "m");
        return {1.0 / length.factor, "1/" + length.name};
    }
    auto unit = display_unit(most, si_unit);
    if (const auto at = unit.name.find("²"); at != std::string::npos) unit.name.replace(at, sizeof "²" - 1, "2");
    return unit;
}

std::string in_words(std::string quantity) {
    std::replace(quantity.begin(), quantity.end(), '_', ' ');
    return quantity;
}

std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }
std::string stem(const std::string& path) { return std::filesystem::path(path).stem().string(); }

}  // namespace setae::file_figures
