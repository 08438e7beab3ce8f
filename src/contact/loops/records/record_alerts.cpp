// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "alert_list.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/units.hpp"

namespace setae::loops {
namespace {

/// The power of 1000 that brings a value, which is proportional to a power of the factor, next to its usual value.
double likely_factor(double value, double usual, double power) {
    const double decades = std::log10(usual / value) / power;
    return std::pow(10.0, 3.0 * std::round(decades / 3.0));
}

std::string times(double factor) { return fmt::format("10^{:.0f}", std::log10(factor)); }

std::string described(const std::vector<IndexRange>& ranges) {
    std::string text;
    constexpr std::size_t most = 3;
    for (std::size_t i = 0; i < std::min(ranges.size(), most); ++i)
        text += fmt::format("{}{} to {}", i == 0 ? "" : ", ", ranges[i].first, ranges[i].last);
    return ranges.size() > most ? text + fmt::format(" and {} more", ranges.size() - most) : text;
}

void check_faults(AlertList& list, const RecordFaults& faults, const Loop& loop, const AlertLimits& limits) {
    if (faults.time_backwards)
        list.add(
            "TIME_BACKWARDS",
            fmt::format("time runs backwards at sample {}: the drift is computed along the sample number, not along "
                        "time",
                        *faults.time_backwards),
            "sort the rows, or split a file that contains several records");
    for (const auto& [ranges, end] :
         {std::pair(&faults.saturated_high, "largest"), std::pair(&faults.saturated_low, "smallest")})
        if (!ranges->empty())
            list.add("FORCE_SATURATED",
                     fmt::format(
                         "the force stays at its {} value, {}, without any noise in samples {}: every fit leaves these "
                         "samples out, and the loop energy lacks the forces beyond this value",
                         end, format_value(loop.force[ranges->front().first], "N"), described(*ranges)),
                     "use a larger range of the force sensor");
    const double share =
        faults.frames > 0 ? static_cast<double>(faults.frames_missing) / static_cast<double>(faults.frames) : 0.0;
    if (share > limits.frames_missing)
        list.add(
            "FRAME_MISSING",
            fmt::format("{:.0f} % of the frames in contact have no contact radius; the longest gap is samples {} to {}",
                        100.0 * share, faults.longest_gap->first, faults.longest_gap->last),
            "look at the images of the gap; within the gap, the results depend only on force and "
            "displacement");
}

void check_units(AlertList& list, const LoopAnalysis& analysis, const Loop& loop, const LensAndCounterBody& bodies,
                 const AlertLimits& limits) {
    const auto implausible = [&](const std::string& message, const std::string& action) {
        list.add("UNITS_IMPLAUSIBLE", message, action);
    };
    constexpr double usual_share = 0.1, usual_modulus = 1e6, usual_work = 0.05;
    const double largest = loop.contact_radius.size() > 0
                               ? loop.contact_radius.unaryExpr([](double a) { return a > 0.0 ? a : 0.0; }).maxCoeff()
                               : 0.0;
    if (largest > bodies.radius)
        implausible(
            fmt::format("the contact radius reaches {}, more than the sphere radius {}: one of them is wrong, and the "
                        "likely factor of the contact radius is {}",
                        format_value(largest, "m"), format_value(bodies.radius, "m"),
                        times(likely_factor(largest, usual_share * bodies.radius, 1.0))),
            "check the units of contact radius and sphere radius");
    const JkrFit& fit = analysis.loading.primary();
    const double modulus = fit.contact_modulus.value, work = fit.work_of_adhesion.value;
    if (!(modulus >= limits.contact_modulus_min && modulus <= limits.contact_modulus_max)) {
        // E* ∝ F R^(−1/2) δ^(−3/2) or F R a^(−3)
        const bool by_radius = fit.method != "force_displacement" && loop.contact_radius.size() > 0;
        implausible(
            fmt::format("E* = {} lies outside {} to {}: the likely factor of the force is {}, or that of the {} {}",
                        format_value(modulus, "Pa", 3), format_value(limits.contact_modulus_min, "Pa", 1),
                        format_value(limits.contact_modulus_max, "Pa", 1),
                        times(likely_factor(modulus, usual_modulus, 1.0)),
                        by_radius ? "contact radius" : "displacement",
                        times(likely_factor(modulus, usual_modulus, by_radius ? -3.0 : -1.5))),
            "check the units of the columns and of the sphere radius");
    }
    if (std::abs(work) > limits.work_of_adhesion_max)
        implausible(
            fmt::format(
                "W = {} exceeds {}: forces of {} are too large for this sphere radius, and the likely factor is "
                "{}",
                format_value(work, "J/m2", 3), format_value(limits.work_of_adhesion_max, "J/m2", 3),
                format_value(1.5 * pi * bodies.radius * std::abs(work), "N"),
                times(likely_factor(std::abs(work), usual_work, 1.0))),
            "check the units of force and sphere radius");
}

void check_contacts(AlertList& list, const LoopAnalysis& analysis) {
    const auto& contacts = analysis.segments.contacts;
    if (contacts.size() < 2) return;
    std::string where;
    constexpr std::size_t most = 5;
    for (std::size_t k = 0; k < std::min(contacts.size(), most); ++k)
        where += fmt::format("{}samples {} to {}", k == 0 ? "" : ", ", contacts[k].loading.first,
                             contacts[k].unloading ? contacts[k].unloading->last : contacts[k].loading.last);
    if (contacts.size() > most) where += ", …";
    std::string failed;
    for (std::size_t k = 0; k < analysis.further_contacts.size(); ++k)
        if (!analysis.further_contacts[k])
            failed += fmt::format("; contact {} is not analysed: {}", k + 2, analysis.further_contacts[k].reason);
    list.add(
        "TWO_CONTACTS",
        fmt::format("the record contains {} contacts, {}: each is analysed, and the results of the record are those "
                    "of the first{}",
                    contacts.size(), where, failed),
        "split the file, or use the results of the contact you need");
}

}  // namespace

void check_record(AlertList& list, const LoopAnalysis& analysis, const Loop& loop, const LensAndCounterBody& bodies,
                  const AlertLimits& limits) {
    check_faults(list, analysis.faults, loop, limits);
    check_units(list, analysis, loop, bodies, limits);
    check_contacts(list, analysis);
}

}  // namespace setae::loops
