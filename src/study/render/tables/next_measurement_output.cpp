// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/output/next_measurement_output.hpp"

#include <cmath>

#include <fmt/format.h>

namespace setae::output {
namespace {

/// Percent with one digit; a gain that rounds to 0 has no sign.
std::string gain_text(double gain) {
    const double tenths = std::round(1000.0 * gain);
    return fmt::format("{:.1f}", tenths == 0.0 ? 0.0 : tenths / 10.0);
}

}  // namespace

std::string words_of(const adhesion::Candidate& candidate) {
    using Kind = adhesion::Candidate::Kind;
    switch (candidate.kind) {
        case Kind::input: return fmt::format("{} to half its ±", candidate.name);
        case Kind::loop: return fmt::format("another loop of {} on {}", candidate.elastomer, candidate.name);
        case Kind::spectrum: return fmt::format("the measurements of {} once more", candidate.name);
    }
    return "";
}

tables::TidyTable next_table(const NextMeasurements& next) {
    tables::TidyTable table{fmt::format("± of {} with one further measurement", next.target),
                            {"measurement", "± [mJ/m²]", "smaller by [%]", "hours", "% per hour"},
                            {}};
    for (const auto& [candidate, error, gain] : next.measurements)
        table.rows.push_back(
            {words_of(candidate), fmt::format("{:.4g}", 1e3 * error), gain_text(gain),
             candidate.hours ? fmt::format("{:.3g}", *candidate.hours) : std::string("–"),
             candidate.hours ? fmt::format("{:.2g}", 100.0 * gain / *candidate.hours) : std::string("–")});
    return table;
}

}  // namespace setae::output
