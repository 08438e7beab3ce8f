// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/output/persson_answer.hpp"

#include <cmath>
#include <set>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/layout.hpp"
#include "setae/core/units.hpp"

namespace setae::output {
namespace {

constexpr double full = 0.99995;  ///< area that is written as 100 %

std::string plain_sentence(const Table& load, Index i) {
    const double gap = load.at("mean_gap")[i], area = load.at("area_fraction")[i];
    const auto stored = format_value(load.at("stored_energy")[i], "J/m2", 3);
    if (area > full) return fmt::format("full contact, stored energy {}", stored);
    return fmt::format("{:.3g} % of the area in contact, mean gap {}, stiffness {}, stored energy {}", 100.0 * area,
                       format_value(gap, "m", 3), format_value(1e-6 * load.at("contact_stiffness")[i], "Pa", 3) + "/µm",
                       stored);
}

std::string adhesive_sentence(const Table& load, Index i) {
    const double area = load.at("adhesive_area_fraction")[i];
    if (std::isnan(area)) return "the iteration with adhesion did not converge";
    const double left = load.at("effective_work")[i];
    return fmt::format("with adhesion {:.3g} % in contact, effective work of adhesion for the longest waves {}",
                       100.0 * area, left > 0.0 ? format_value(left, "J/m2", 3) : "0");
}

}  // namespace

std::string persson_answer(const Table& load, const persson::Scales& scales, double contact_modulus,
                           std::size_t columns) {
    const Index last = scales.wavevector.size() - 1;
    const double width = std::sqrt(scales.pressure_variance[last]);
    std::string text =
        wrapped(fmt::format("waves from {} to {}: full contact needs an rms pressure of {} ({:.3g} E*) and stores {}",
                            format_value(2.0 * pi / scales.wavevector[0], "m", 3),
                            format_value(2.0 * pi / scales.wavevector[last], "m", 3), format_value(width, "Pa", 3),
                            width / contact_modulus, format_value(scales.stored_energy[last], "J/m2", 3)),
                columns, 2) +
        '\n';
    const auto& pressure = load.at("pressure");
    for (const Index i : std::set<Index>{0, pressure.size() / 2, pressure.size() - 1}) {
        auto line = fmt::format("at {}: ", format_value(pressure[i], "Pa", 3));
        const bool plain = !std::isnan(load.at("area_fraction")[i]), adhesive = load.find("effective_work") != nullptr;
        if (plain) line += plain_sentence(load, i);
        if (adhesive) line += (plain ? "; " : "") + adhesive_sentence(load, i);
        text += wrapped(line, columns, 2) + '\n';
    }
    return text;
}

}  // namespace setae::output
