// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/output/comparison_answer.hpp"

#include <array>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/layout.hpp"
#include "setae/core/units.hpp"
#include "setae/core/words.hpp"

namespace setae::output {
namespace {

/// A column in words; values of unit "1" are printed in per cent.
struct ColumnWords {
    const char *column, *words, *unit;
    bool when_full;  ///< whether it is defined in full contact, where there is neither a gap nor a finite stiffness
};
constexpr std::array<ColumnWords, 4> columns_in_words{{{"area_fraction", "area", "1", true},
                                                       {"mean_gap", "mean gap", "m", false},
                                                       {"contact_stiffness", "stiffness", "Pa/m", false},
                                                       {"stored_energy", "stored energy", "J/m2", true}}};

bool is_full(const Table& load, Index i) { return load.at("area_fraction")[i] > 0.99995; }

std::string shown(double value, const ColumnWords& what) {
    const std::string_view unit = what.unit;
    if (unit == "1") return fmt::format("{:.3g} %", 100.0 * value);
    if (unit == "Pa/m") return format_value(1e-6 * value, "Pa", 3) + "/µm";
    return format_value(value, unit, 3);
}

/// Least and greatest of theory over solution less one.
std::string deviation(const Table& load, const ColumnWords& what) {
    const std::string column = what.column;
    double least = undefined, greatest = undefined;
    const auto &solved = load.at(column), &theory = load.at(column + "_persson");
    for (Index i = 0; i < solved.size(); ++i) {
        if (is_full(load, i) && !what.when_full) continue;
        const double ratio = theory[i] / solved[i] - 1.0;
        if (!std::isfinite(ratio)) continue;
        least = std::fmin(least, ratio);
        greatest = std::fmax(greatest, ratio);
    }
    if (std::isnan(least)) return fmt::format("{} not compared", what.words);
    if (fmt::format("{:+.1f}", 100.0 * least) == fmt::format("{:+.1f}", 100.0 * greatest))
        return fmt::format("{} {:+.1f} %", what.words, 100.0 * least);
    return fmt::format("{} {:+.1f} to {:+.1f} %", what.words, 100.0 * least, 100.0 * greatest);
}

std::string contact_at(const Table& load, Index i) {
    std::string line;
    for (const auto& what : columns_in_words) {
        if (is_full(load, i) && !what.when_full) continue;
        const std::string column = what.column;
        const double error = load.at(column + "_standard_error")[i];
        line += fmt::format("{}{} {}{} (theory: {})", line.empty() ? "" : ", ", what.words,
                            shown(load.at(column)[i], what), std::isnan(error) ? "" : " ± " + shown(error, what),
                            shown(load.at(column + "_persson")[i], what));
    }
    return line;
}

}  // namespace

std::string comparison_answer(const Table& load, const Band& band, int surfaces, std::size_t columns) {
    std::string deviations;
    for (const auto& what : columns_in_words) deviations += (deviations.empty() ? "" : ", ") + deviation(load, what);
    auto text = wrapped(fmt::format("Persson's theory relative to the solved contact of {}, waves from {} to {}: {}",
                                    counted(static_cast<std::size_t>(surfaces), "surface", "surfaces"),
                                    format_value(2.0 * pi / band.lower, "m", 3),
                                    format_value(2.0 * pi / band.upper, "m", 3), deviations),
                        columns, 2) +
                '\n';
    const auto& pressure = load.at("pressure");
    for (const Index i : std::set<Index>{0, pressure.size() / 2, pressure.size() - 1})
        text += wrapped(fmt::format("at {}: {}", format_value(pressure[i], "Pa", 3), contact_at(load, i)), columns, 2) +
                '\n';
    return text;
}

}  // namespace setae::output
