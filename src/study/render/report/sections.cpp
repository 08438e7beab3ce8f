// SPDX-License-Identifier: GPL-3.0-or-later
#include "sections.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "fold.hpp"
#include "markup.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/units.hpp"
#include "setae/core/words.hpp"
#include "setae/output/verdict.hpp"
#include "table.hpp"

namespace setae::report {
namespace {

using study::MeasurementResult;
using study::StudyResult;

/// A table of texts, the last column one of sentences.
std::string plain_table(const std::string& identifier, const std::string& title,
                        const std::vector<std::string>& columns, const std::vector<std::vector<std::string>>& rows,
                        bool open = false) {
    DataTable table{.identifier = identifier, .title = title, .open = open};
    for (const auto& column : columns) table.columns.push_back({column, ""});
    for (const auto& row : rows) {
        table.rows.emplace_back();
        for (std::size_t i = 0; i < row.size(); ++i)
            table.rows.back().push_back(i + 1 < row.size() ? Cell(TextCell{row[i]}) : Cell(ProseCell{row[i]}));
    }
    return as_html(table, output::Json());
}

std::string name_of(const MeasurementResult& m) { return m.file.empty() ? m.name : m.file; }

std::string wavelengths(const MeasurementResult& m) {
    return format_value(2.0 * pi / m.spectrum.band.upper, "m", 3) + " … " +
           format_value(2.0 * pi / m.spectrum.band.lower, "m", 3);
}

/// Warnings that concern excluded or changed data.
std::string cuts_of(const MeasurementResult& m) {
    static const std::set<std::string> codes{"TIP_CUTOFF", "REENTRANT",   "CONTOUR_STEPS",     "TRACE_NOISE",
                                             "UNDEFINED",  "PIXEL_NOISE", "LIKELIHOOD_FAILED", "COVERAGE_GAP"};
    std::string text;
    for (const auto& alert : m.alerts)
        if (codes.contains(alert.code)) text += (text.empty() ? "" : "; ") + alert.code + ": " + alert.message;
    return text.empty() ? "size at long wavelengths, sampling at short wavelengths" : text;
}

/// The study's inputs of each file of a surface.
std::map<std::string_view, const study::MeasurementInput*> inputs_of(const StudyResult& result,
                                                                     const std::string& surface) {
    std::map<std::string_view, const study::MeasurementInput*> inputs;
    if (const auto* input = result.study.surface(surface))
        for (const auto& measurement : input->measurements) inputs.emplace(measurement.file, &measurement);
    return inputs;
}

std::string steps_of(const MeasurementResult& m, const study::MeasurementInput* input) {
    std::string text = "read" + (m.spectrum.metadata.format.empty() ? "" : " as " + m.spectrum.metadata.format);
    if (input && !input->references.empty())
        text += fmt::format("; artefact of the instrument subtracted, from {} of a smooth reference",
                            counted(input->references.size(), "scan", "scans"));
    for (const auto& step : m.processing) text += "; " + step.step;
    for (const auto& alert : m.alerts) {
        if (alert.code == "REENTRANT") text += "; contour cleaned: " + alert.message;
        if (alert.code == "UNDEFINED") text += "; undefined points: " + alert.message;
    }
    text += m.trend == topography::Trend::none ? "; no trend removed"
                                               : fmt::format("; {} removed", topography::name(m.trend));
    text += fmt::format("; window {}", m.spectrum.window.empty() ? "none" : m.spectrum.window);
    if (input && input->tip_radius)
        text += fmt::format("; tip radius of {} included", format_value(input->tip_radius->value, "m", 3));
    if (input && input->resolution)
        text += fmt::format("; cut at the instrument's resolution of {}", format_value(*input->resolution, "m", 3));
    return text + "; reliable for wavelengths " + wavelengths(m);
}

}  // namespace

std::string cut_html(const StudyResult& result) {
    std::vector<std::vector<std::string>> failed, rows;
    for (const auto& surface : result.surfaces) {
        if (surface.failed()) failed.push_back({"surface", surface.name, surface.name, surface.error});
        for (const auto& m : surface.measurements) {
            if (m.failed()) failed.push_back({"measurement", surface.name, name_of(m), m.error});
            else
                rows.push_back(
                    {surface.name, name_of(m), m.spectrum.metadata.instrument.type, wavelengths(m), cuts_of(m)});
        }
    }
    for (const auto& e : result.experiments)
        if (e.failed())
            failed.push_back({"experiment", e.input.reference ? "reference" : e.input.surface, e.input.file, e.error});
    std::string html = failed.empty() ? "<p>No part of the study failed.</p>"
                                      : plain_table("failed", "Failed parts, with the reason",
                                                    {"kind", "surface", "file", "reason"}, failed, true);
    std::vector<std::vector<std::string>> excluded;
    for (const auto& e : result.experiments)
        if (e.input.excluded())
            excluded.push_back({e.input.reference ? "reference" : e.input.surface, e.input.elastomer, e.input.file,
                                e.input.exclusion});
    if (!excluded.empty())
        html += plain_table("excluded", "Loops excluded from every mean, with the reason",
                            {"surface", "elastomer", "file", "reason"}, excluded);
    const auto limits = result.study.analysis.limits();
    if (limits.shortest || limits.longest)
        html += fmt::format("<p>The study limits every spectrum to wavelengths from {} to {}.</p>",
                            limits.shortest ? format_value(*limits.shortest, "m", 3) : "the shortest measured",
                            limits.longest ? format_value(*limits.longest, "m", 3) : "the longest measured");
    if (rows.empty()) return html + "<p>The study contains no measurement of a surface.</p>";
    return html + plain_table("cuts", "Reliable band of each measurement, with its limits",
                              {"surface", "file", "instrument", "reliable wavelengths", "limited by"}, rows);
}

std::string alerts_html(const StudyResult& result) {
    std::string html;
    for (const auto& [code, alerts] : output::grouped_alerts(result)) {
        const auto& action = alerts.front().action;
        const bool one_action =
            std::all_of(alerts.begin(), alerts.end(), [&](const auto& alert) { return alert.action == action; });
        html += fmt::format(
            "<details class=\"warnings\"><summary><span class=\"code\">{}</span> <span class=\"count\">{}</span> {}</summary><ul>",
            escaped(code), alerts.size() == 1 ? "once" : fmt::format("{} times", alerts.size()),
            one_action ? "What to do: " + prose(action) : "");
        for (const auto& alert : std::span(alerts).first(std::min(alerts.size(), max_rows)))
            html += fmt::format("<li><strong>{}</strong>: {}{}</li>", escaped(alert.subject), prose(alert.message),
                                one_action ? "" : " — " + prose(alert.action));
        if (alerts.size() > max_rows)
            html +=
                fmt::format("<li>{} more. The file alerts.csv contains all warnings.</li>", alerts.size() - max_rows);
        html += "</ul></details>\n";
    }
    return html.empty() ? "<p>No warning.</p>" : "<p>Warnings by kind, the most important first.</p>" + html;
}

std::string steps_html(const StudyResult& result) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& surface : result.surfaces) {
        const auto inputs = inputs_of(result, surface.name);
        for (const auto& m : surface.measurements) {
            const auto input = inputs.find(m.file);
            rows.push_back(
                {surface.name, name_of(m),
                 m.failed() ? "failed: " + m.error : steps_of(m, input == inputs.end() ? nullptr : input->second)});
        }
    }
    return rows.empty()
               ? "<p>The study contains no measurement of a surface.</p>"
               : plain_table("steps", "Steps from file to spectrum", {"surface", "file", "steps in order"}, rows);
}

std::string methods_html(const StudyResult& result) {
    const auto& options = result.study.analysis;
    const bool fitted = std::any_of(result.surfaces.begin(), result.surfaces.end(),
                                    [](const auto& surface) { return surface.fitted.has_value(); });
    const bool measured = std::any_of(result.surfaces.begin(), result.surfaces.end(),
                                      [](const auto& surface) { return !surface.measurements.empty(); });
    std::string html = "<ul>";
    const auto say = [&html](const std::string& sentence) { html += "<li>" + sentence + "</li>"; };
    if (measured)
        say("Power spectral density <i>C</i><sub>1D</sub>(<i>q</i>) = |<i>h̃</i>(<i>q</i>)|²/<i>L</i>, two-sided, <i>q</i> = 2π/wavelength, so that <i>h</i>²<sub>rms</sub> = (1/π) ∫ "
            "<i>C</i><sub>1D</sub> d<i>q</i> [J17]. The table above gives the trend and the window of each measurement.");
    if (fitted)
        say("The spectrum of a surface is fitted to all its measurements together (Whittle likelihood). The fit includes the window, trend, sampling and tip of each measurement. The "
            "plain average over the measurements is given for comparison.");
    say(options.conversion == roughness::Conversion::exact
            ? std::string(
                  "Rms height, slope, curvature and stored energy are moments of the spectrum. The conversion from line to area is exact for isotropic surfaces.")
            : std::string(
                  "Rms height, slope, curvature and stored energy are moments of the spectrum, converted from line to area by Eq. 11 of [D19]."));
    say("<i>A</i><sub>true</sub>/<i>A</i><sub>app</sub> is the true area ratio of a surface with Gaussian slopes, Eq. 9 of [D19].");
    say("The work of adhesion of loops follows from JKR fits [JKR]. The energy loss is ∮ <i>F</i> d<i>δ</i>.");
    if (!result.replicates.empty())
        say("Measured values of pairs are means of a linear mixed model over lenses, spots and repeats. The fit by restricted likelihood includes the errors of the loops. Degrees of "
            "freedom follow Satterthwaite's formula.");
    say("Full-contact balance (Eq. 7 of [D19]): <i>W</i><sub>app</sub> = <i>W</i><sub>int</sub> <i>A</i><sub>true</sub>/<i>A</i><sub>app</sub> − <i>γ</i><sub>1</sub> (<i>A</i><sub>true</sub>/<i>A</i><sub>app</sub> − 1) − "
        "<i>U</i><sub>el</sub>/<i>A</i><sub>app</sub>. The small-slope balance (Eq. 2) omits the term with <i>γ</i><sub>1</sub> of the soft side. The Persson–Tosatti balance (Eq. S13, [PT01]) omits this term too and uses the area of small slopes, "
        "1 + <i>h</i>′²/2. True-area loss (Eq. 10): <i>E</i><sub>loss</sub> = <i>W</i><sub>int</sub> <i>A</i><sub>true</sub>. One <i>W</i><sub>int</sub> is fitted to all pairs.");
    return as_html(Fold{.identifier = "methods", .kind = "text", .title = "Methods", .html = html + "</ul>"});
}

std::string provenance_html(const StudyResult& result, const RunRecord& run) {
    const auto& options = result.study.analysis;
    std::string html = "<dl>";
    const auto line = [&html](const std::string& term, const std::string& definition) {
        html += "<dt>" + term + "</dt><dd>" + definition + "</dd>";
    };
    line("Program", "setae " + escaped(study::version()));
    line("Command", "<code>" + escaped(run.command) + "</code>");
    line("Time", escaped(run.time));
    line("Study", "<code>" + escaped(result.study.path) + "</code>");
    line("Conversion from line to area",
         options.conversion == roughness::Conversion::exact ? "exact moments" : "Eq. 11 of [D19]");
    line("Spectrum", options.spectrum
                         ? *options.spectrum == study::SpectrumMethod::likelihood ? "likelihood" : "average"
                         : "likelihood for surfaces with several measurements, average for a single measurement");
    line("Bootstrap resamples", std::to_string(options.bootstrap_resamples));
    line("Seed", std::to_string(options.seed));
    if (options.tip_percentile > 0.0) line("Tip percentile", fmt::format("{}", options.tip_percentile));
    line("Rough solid", format_value(result.study.counter_youngs_modulus, "Pa", 4) +
                            fmt::format(", Poisson ratio {}", result.study.counter_poisson_ratio));
    line("Given <i>W</i><sub>int</sub>", result.study.work_of_adhesion
                                             ? escaped(format_value(result.study.work_of_adhesion->value, "J/m2"))
                                             : std::string("no"));
    html = as_html(
        Fold{.identifier = "run", .kind = "text", .title = "Program, command and options", .html = html + "</dl>"});
    std::vector<std::vector<std::string>> rows;
    for (const auto& input : result.inputs)
        rows.push_back({input.path,
                        input.changed          ? "changed during the run"
                        : input.sha256.empty() ? "could not be read"
                                               : fmt::format("{}", input.size),
                        input.sha256});
    if (rows.empty()) return html;
    return html + plain_table("inputs", "Inputs", {"file", "size [bytes]", "SHA-256"}, rows);
}

std::string references_html() {
    const auto list =
        "<ul class=\"references\">"
        "<li>[D19] S. Dalvi, A. Gujrati, S. R. Khanal, L. Pastewka, A. Dhinojwala, T. D. B. Jacobs: Linking energy loss in soft adhesion to surface roughness. Proc. Natl. Acad. Sci. USA 116 "
        "(2019) 25484. doi:10.1073/pnas.1913126116</li>"
        "<li>[J17] T. D. B. Jacobs, T. Junge, L. Pastewka: Quantitative characterization of surface topography using spectral analysis. Surf. Topogr.: Metrol. Prop. 5 (2017) 013001. "
        "doi:10.1088/2051-672X/aa51f8</li>"
        "<li>[PT01] B. N. J. Persson, E. Tosatti: The effect of surface roughness on the adhesion of elastic solids. J. Chem. Phys. 115 (2001) 5597. doi:10.1063/1.1398300</li>"
        "<li>[JKR] K. L. Johnson, K. Kendall, A. D. Roberts: Surface energy and the contact of elastic solids. Proc. R. Soc. Lond. A 324 (1971) 301. doi:10.1098/rspa.1971.0141</li>"
        "<li>[setae] The setae developers: setae, from measured roughness to soft adhesion, version " +
        escaped(study::version()) + ". GPL-3.0-or-later.</li></ul>";
    return "<p>Publications with numbers or figures of this page should cite the paper of the method and setae.</p>" +
           as_html(Fold{.identifier = "cited", .kind = "text", .title = "References to cite", .html = list}) +
           "<p class=\"note\">plotly.js 4.1.1 (© 2012–2026 Plotly, Inc., MIT licence) draws the figures. It is part of this page, and the page loads nothing from the network.</p>";
}

}  // namespace setae::report
