// SPDX-License-Identifier: GPL-3.0-or-later
#include "summary.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "markup.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/units.hpp"
#include "setae/core/words.hpp"
#include "setae/output/verdict.hpp"
#include "table.hpp"

namespace setae::report {
namespace {

using output::Json;
using study::StudyResult;

std::size_t count_measurements(const StudyResult& result) {
    std::size_t n = 0;
    for (const auto& surface : result.surfaces) n += surface.measurements.size();
    return n;
}

std::string sentence_of_contents(const StudyResult& result) {
    const auto references = static_cast<std::size_t>(std::count_if(result.experiments.begin(), result.experiments.end(),
                                                                   [](const auto& e) { return e.input.reference; }));
    const auto published =
        static_cast<std::size_t>(std::count_if(result.study.published.begin(), result.study.published.end(),
                                               [](const auto& p) { return !p.surface.empty(); }));
    std::string text =
        fmt::format("The study contains {} with {}, {} and {}", counted(result.surfaces.size(), "surface", "surfaces"),
                    counted(count_measurements(result), "measurement", "measurements"),
                    counted(result.elastomers.size(), "elastomer", "elastomers"),
                    counted(result.experiments.size(), "experiment", "experiments"));
    if (references > 0) text += fmt::format(" ({} on the smooth reference)", references);
    if (published > 0)
        text += fmt::format(". Values of {} come from published tables", counted(published, "pair", "pairs"));
    return text + ".";
}

std::string sentence_of_failures(const StudyResult& result) {
    std::vector<std::string> failed;
    for (const auto& surface : result.surfaces) {
        if (surface.failed()) failed.push_back("surface " + surface.name);
        for (const auto& m : surface.measurements)
            if (m.failed()) failed.push_back("measurement " + (m.file.empty() ? m.name : m.file));
    }
    for (const auto& e : result.experiments)
        if (e.failed()) failed.push_back("experiment " + e.input.file);
    if (failed.empty()) return result.surfaces.empty() && result.experiments.empty() ? "" : " Nothing failed.";
    return fmt::format(
        " <strong>{} failed</strong>: {}. The section <a href=\"#cut\">Excluded data</a> gives the reasons.",
        failed.size(), escaped(listed(failed)));
}

std::string r_squared(const Json& study, const std::string& fit) {
    const auto pointer = joined(fit, "r_squared/value");
    return entry(study, pointer).is_number() ? fmt::format("<i>R</i>² = {}", number_html(study, pointer, {}, 3)) : "";
}

/// "reported: W_int = 37.0 ± 3.7 mJ m⁻², R² = 0.6700 ([D19], Fig. 4A)"; empty where nothing is reported for a fit.
std::string reported_of(const StudyResult& result, const Json& study, const std::string& fit) {
    std::string text, source;
    for (std::size_t i = 0; i < result.study.reported.size(); ++i) {
        const auto& reported = result.study.reported[i];
        if (reported.fit != fit) continue;
        text += fmt::format("{}{} = {}", text.empty() ? "reported: " : ", ",
                            reported.quantity == "work_of_adhesion" ? "<i>W</i><sub>int</sub>" : "<i>R</i>²",
                            quantity_html(study, fmt::format("/reported/{}/reported", i), false));
        source = escaped(reported.source);
    }
    return text.empty() ? "" : fmt::format("{} ({})", text, source);
}

std::string work_sentences(const StudyResult& result, const Json& study) {
    std::string text;
    if (result.work_of_adhesion)
        text += fmt::format(
            "<p>Predictions use the intrinsic work of adhesion <i>W</i><sub>int</sub> = <strong>{}</strong> (source: {}; ± from {}).</p>",
            quantity_html(study, "/work_of_adhesion"), escaped(result.work_of_adhesion_source),
            escaped(result.work_of_adhesion->method.empty() ? "the study" : result.work_of_adhesion->method));
    std::string items;
    const auto item = [&](const std::string& key, const std::string& lead) {
        const auto place = joined("/fits", key);
        const auto reported = reported_of(result, study, key);
        if (!entry(study, place).is_object()) {
            if (!reported.empty()) items += fmt::format("<li>{}: not fitted; {}.</li>", lead, reported);
            return;
        }
        const auto stated = joined(
            place, entry(study, joined(place, "posterior")).is_object() ? "posterior" : "generalised/work_of_adhesion");
        items += fmt::format("<li>{}: <i>W</i><sub>int</sub> = {}, {}, from {} pairs{}.</li>", lead,
                             quantity_html(study, stated), r_squared(study, joined(place, "generalised")),
                             number_html(study, joined(place, "n"), {}, 0), reported.empty() ? "" : "; " + reported);
    };
    item("modified", "Approach, full-contact balance (Eq. 7)");
    item(
        "persson_tosatti",
        "Approach, Persson–Tosatti balance (Eq. S13), with the area of small slopes and without the cost of stretching the soft surface");
    item("without_area_change",
         "Approach, small-slope balance (Eq. 2), without the cost of stretching the soft surface");
    item("loop", "Energy loss of loops, true-area loss (Eq. 10)");
    if (!items.empty())
        text += "<details><summary><i>W</i><sub>int</sub> from each balance and from the energy loss</summary><ul>" +
                items + "</ul></details>";
    return text;
}

/// "24 measurements", "1 of 3 measurements".
std::string counted_measurements(const study::SurfaceResult& surface) {
    const auto all = surface.measurements.size();
    const auto failed = static_cast<std::size_t>(std::count_if(surface.measurements.begin(), surface.measurements.end(),
                                                               [](const auto& m) { return m.failed(); }));
    return (failed > 0 ? fmt::format("{} of ", all - failed) : "") + counted(all, "measurement", "measurements");
}

std::string surface_sentences(const StudyResult& result, const Json& study) {
    constexpr std::size_t max_sentences = 8;  // the table of surfaces has all
    if (result.surfaces.size() > max_sentences) return "";
    std::string items;
    for (const auto& surface : result.surfaces) {
        if (surface.failed()) {
            items +=
                fmt::format("<li><strong>{}</strong> failed: {}.</li>", escaped(surface.name), prose(surface.error));
            continue;
        }
        const auto base = named("/surfaces", surface.name);
        const auto said = [&](const char* key) { return quantity_html(study, joined(base, key), false); };
        const auto& band = surface.used().curve.band;
        items += fmt::format(
            "<li><strong>{}</strong>: <i>h</i><sub>rms</sub> = {}, <i>h</i>′<sub>rms</sub> = {}, <i>A</i><sub>true</sub>/<i>A</i><sub>app</sub> = {}, "
            "for wavelengths from {} to {}; {}.</li>",
            escaped(surface.name), said("rms_height"), said("rms_slope"), said("true_area_ratio"),
            format_value(2.0 * pi / band.upper, "m", 3), format_value(2.0 * pi / band.lower, "m", 3),
            surface.measurements.empty()
                ? surface.reconstructed ? "reconstructed from published moments" : "from a given power spectrum"
                : counted_measurements(surface));
    }
    return items.empty() ? "" : "<p>Roughness (± is one standard error):</p><ul>" + items + "</ul>";
}

}  // namespace

std::string verdict_html(const StudyResult& result) {
    const auto said = output::verdict(result);
    std::string html;
    for (const auto& sentence : said.answer) html += "<p class=\"lead\">" + prose(sentence) + "</p>";
    if (!said.reservations.empty()) {
        html += fmt::format("<p>The most important of <a href=\"#limits\">{}</a>:</p><ul>",
                            counted(said.limits.size(), "reservation", "reservations"));
        for (const auto& sentence : said.reservations) html += "<li>" + prose(sentence) + "</li>";
        html += "</ul>";
    }
    html += "<p>" + sentence_of_contents(result) + sentence_of_failures(result);
    if (said.reservations.empty() && !said.limits.empty())
        html += fmt::format(" The answer has <a href=\"#limits\">{}</a>.",
                            counted(said.limits.size(), "reservation", "reservations"));
    return html + "</p>";
}

std::string numbers_html(const StudyResult& result, const Json& study) {
    return work_sentences(result, study) + surface_sentences(result, study);
}

std::string limits_html(const StudyResult& result) {
    const auto said = output::verdict(result);
    const auto listed = [](const auto first, const auto last) {
        std::string items;
        for (auto sentence = first; sentence != last; ++sentence) items += "<li>" + prose(*sentence) + "</li>";
        return "<ul>" + items + "</ul>";
    };
    std::string html;
    if (!said.findings.empty())
        html += "<p>Conclusions that the tests support:</p>" + listed(said.findings.begin(), said.findings.end());
    if (said.limits.empty())
        return html +
               "<p>Several surfaces and elastomers test the balance against roughness and modulus. No part of the study failed.</p>";
    constexpr std::size_t seen = 5;
    const auto folded = said.limits.begin() + static_cast<std::ptrdiff_t>(std::min(seen, said.limits.size()));
    html += "<p>Limits of the conclusions:</p>" + listed(said.limits.begin(), folded);
    if (folded != said.limits.end())
        html += fmt::format("<details><summary>{} more</summary>{}</details>", said.limits.end() - folded,
                            listed(folded, said.limits.end()));
    return html;
}

}  // namespace setae::report
