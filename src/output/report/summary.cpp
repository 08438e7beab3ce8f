// SPDX-License-Identifier: GPL-3.0-or-later
#include "summary.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "markup.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/units.hpp"
#include "table.hpp"
#include "tables.hpp"

namespace setae::report {
namespace {

using output::Json;
using study::StudyResult;

std::string counted(std::size_t n, const std::string& one, const std::string& many) {
    return fmt::format("{} {}", n == 0 ? "no" : std::to_string(n), n == 1 ? one : many);
}

/// "A, B and C".
std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
        text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + escaped(names[i]);
    return text;
}

std::size_t count_measurements(const StudyResult& result) {
    std::size_t n = 0;
    for (const auto& surface : result.surfaces) n += surface.measurements.size();
    return n;
}

/// Surfaces and elastomers of the pairs that have a measured work of adhesion and a prediction.
struct Tested {
    std::set<std::string> surfaces, elastomers;
    std::size_t pairs = 0;
};

Tested tested(const StudyResult& result) {
    Tested found;
    for (const auto& pair : result.pairs) {
        const auto& surface = result.surface(pair.surface);
        if (!pair.approach || surface.failed()) continue;
        ++found.pairs;
        found.surfaces.insert(pair.surface);
        found.elastomers.insert(pair.elastomer);
    }
    return found;
}

std::string sentence_of_contents(const StudyResult& result) {
    const auto references = static_cast<std::size_t>(std::count_if(result.experiments.begin(), result.experiments.end(),
                                                                   [](const auto& e) { return e.input.reference; }));
    const auto published =
        static_cast<std::size_t>(std::count_if(result.study.published.begin(), result.study.published.end(),
                                               [](const auto& p) { return !p.surface.empty(); }));
    std::string text =
        fmt::format("This study holds {} with {}, {} and {}", counted(result.surfaces.size(), "surface", "surfaces"),
                    counted(count_measurements(result), "measurement", "measurements"),
                    counted(result.elastomers.size(), "elastomer", "elastomers"),
                    counted(result.experiments.size(), "experiment", "experiments"));
    if (references > 0) text += fmt::format(" ({} on the smooth reference)", references);
    if (published > 0)
        text += fmt::format("; {} of surface and elastomer come from published tables",
                            counted(published, "pair", "pairs"));
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
        " <strong>{} failed</strong>: {}; the reasons stand under <a href=\"#cut\">What was cut and why</a>.",
        failed.size(), listed(failed));
}

std::string r_squared(const Json& study, const std::string& fit) {
    const auto pointer = joined(fit, "r_squared/value");
    return entry(study, pointer).is_number() ? fmt::format("<i>R</i>² = {}", number_html(study, pointer, {}, 3)) : "";
}

std::string work_sentences(const StudyResult& result, const Json& study) {
    std::string text;
    const auto found = tested(result);
    if (result.work_of_adhesion)
        text += fmt::format(
            "<p>Intrinsic work of adhesion used for predictions: <i>W</i><sub>int</sub> = <strong>{}</strong> ({}; ± by {}).</p>",
            quantity_html(study, "/work_of_adhesion"), escaped(result.work_of_adhesion_source),
            escaped(result.work_of_adhesion->method.empty() ? "the study" : result.work_of_adhesion->method));
    std::string items;
    const auto item = [&](const std::string& key, const std::string& lead, const std::string& tail) {
        const auto place = joined("/fits", key);
        if (!entry(study, place).is_object()) return;
        items += fmt::format("<li>{}: <i>W</i><sub>int</sub> = {}, {}, from {} pairs{}.</li>", lead,
                             quantity_html(study, joined(place, "work_of_adhesion")), r_squared(study, place),
                             number_html(study, joined(place, "n"), {}, 0), tail);
    };
    item("modified", "By approach, balance (7)",
         fmt::format(" of {} and {}", counted(found.surfaces.size(), "surface", "surfaces"),
                     counted(found.elastomers.size(), "elastomer", "elastomers")));
    item("persson_tosatti",
         "By approach, balance (S13), area for small slopes, nothing for stretching the soft surface", "");
    item("without_area_change", "By approach, balance (2), nothing for stretching the soft surface", "");
    item("loop", "By the energy lost in loops, (10)", "");
    for (std::size_t i = 0; i < result.study.reported.size(); ++i) {
        const auto& reported = result.study.reported[i];
        const bool work = reported.quantity == "work_of_adhesion";
        items +=
            fmt::format("<li>Reported for {}: {} = {} ({}).</li>", escaped(balance_name(reported.fit)),
                        work ? "<i>W</i><sub>int</sub>" : "<i>R</i>²",
                        quantity_html(study, fmt::format("/reported/{}/reported", i), false), escaped(reported.source));
    }
    if (!items.empty()) text += "<ul>" + items + "</ul>";
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

std::string summary_html(const StudyResult& result, const Json& study) {
    return "<p class=\"lead\">" + sentence_of_contents(result) + sentence_of_failures(result) + "</p>" +
           work_sentences(result, study) + surface_sentences(result, study);
}

std::string limits_html(const StudyResult& result, const Json& study) {
    std::vector<std::string> limits;
    const auto say = [&limits](std::string sentence) { limits.push_back(std::move(sentence)); };
    const auto found = tested(result);
    const auto fine = [](const auto& item) { return !item.failed(); };
    const auto surfaces = std::count_if(result.surfaces.begin(), result.surfaces.end(), fine);
    const auto experiments = std::count_if(result.experiments.begin(), result.experiments.end(), fine);
    const bool measured = std::any_of(result.pairs.begin(), result.pairs.end(),
                                      [](const auto& pair) { return pair.approach.has_value(); });

    if (result.surfaces.empty() && result.experiments.empty() && result.study.published.empty()) {
        say("Empty study: it names no surface and no experiment, so nothing can be concluded, neither about roughness nor about adhesion.");
    } else {
        if (result.surfaces.empty())
            say("No surface: nothing is known of roughness, so no work of adhesion is predicted and none of the measured ones is compared with a prediction.");
        else if (surfaces == 0) say("No surface could be analysed: nothing is predicted. The reasons stand below.");
        if (!measured && surfaces > 0) {
            const std::string none = result.experiments.empty() ? "No experiment"
                                     : experiments == 0         ? "No experiment could be analysed"
                                                                : "No experiment on a rough surface";
            if (result.study.work_of_adhesion)
                say(none + ": <i>W</i><sub>app</sub> is predicted with the given <i>W</i><sub>int</sub> = " +
                    quantity_html(study, "/work_of_adhesion", false) + "; nothing measured tests it.");
            else
                say(none +
                    ": roughness is known, but <i>W</i><sub>app</sub> is predicted only with a given <i>W</i><sub>int</sub> (<code>work_of_adhesion</code> in the study), and this study gives none.");
        }
        if (measured && found.pairs == 1)
            say("One pair: a single measured work of adhesion can always be matched by some <i>W</i><sub>int</sub>, so it neither supports nor contradicts the balance between adhesion and roughness.");
        else if (found.pairs > 1 && found.surfaces.size() == 1)
            say(fmt::format(
                "One surface: <i>W</i><sub>int</sub> rests on {} pairs of one surface, {}; the balance is not tested against roughness.",
                found.pairs, escaped(*found.surfaces.begin())));
        if (found.pairs > 1 && found.elastomers.size() == 1)
            say(fmt::format(
                "One elastomer: every pair is on {}; that the stored energy grows with the modulus is not tested.",
                escaped(*found.elastomers.begin())));
        if (result.experiments.size() == 1)
            say("One experiment: there is no scatter between loops to tell how far a repetition would differ.");
    }
    if (result.failures() > 0)
        say(fmt::format("{} of the study failed and {} in no number here.",
                        counted(static_cast<std::size_t>(result.failures()), "part", "parts"),
                        result.failures() == 1 ? "is" : "are"));
    if (!result.modified && result.work_of_adhesion && !result.pairs.empty())
        say("No fit of approach: " + prose(result.modified.reason) + ".");
    if (!result.loop && !result.pairs.empty()) say("No fit of loop energies: " + prose(result.loop.reason) + ".");
    if (!result.work_of_adhesion && !result.pairs.empty())
        say("No prediction: " + prose(result.work_of_adhesion.reason) + ".");

    std::vector<std::string> reconstructed, disagreeing, one_measurement;
    for (const auto& surface : result.surfaces) {
        if (surface.reconstructed) reconstructed.push_back(surface.name);
        if (std::any_of(surface.alerts.begin(), surface.alerts.end(),
                        [](const Alert& alert) { return alert.code == "INSTRUMENTS_DISAGREE"; }))
            disagreeing.push_back(surface.name);
        if (!surface.failed() && std::count_if(surface.measurements.begin(), surface.measurements.end(), fine) == 1)
            one_measurement.push_back(surface.name);
    }
    if (!reconstructed.empty())
        say("The spectra of " + listed(reconstructed) +
            " are self-affine reconstructions of published moments, not measurements; what rests on their shape (stored energy, scales) is the model's.");
    if (!one_measurement.empty())
        say("Of " + listed(one_measurement) +
            " there is one measurement; what differs from place to place is not known.");
    if (!disagreeing.empty())
        say("Instruments disagree on " + listed(disagreeing) +
            " beyond chance: its spectrum is a compromise between them.");
    std::vector<std::string> nonconforming;
    for (const auto& pair : result.pairs)
        if (pair.modified && !pair.modified->work.conforms)
            nonconforming.push_back(pair.surface + " × " + pair.elastomer);
    if (!nonconforming.empty())
        say("Balance (7) says that " + listed(nonconforming) +
            " will not conform; it holds for conforming contact only, and 0 stands for them.");
    if (limits.empty())
        return "<p>Several surfaces and elastomers test the balance against roughness and modulus; nothing failed. How certain each number is stands beside it.</p>";
    std::string items;
    for (const auto& sentence : limits) items += "<li>" + sentence + "</li>";
    return "<ul class=\"limits\">" + items + "</ul>";
}

}  // namespace setae::report
