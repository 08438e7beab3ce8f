// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/report/report.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "assets.hpp"
#include "figures.hpp"
#include "markup.hpp"
#include "sections.hpp"
#include "setae/output/verdict.hpp"
#include "summary.hpp"
#include "table.hpp"
#include "tables.hpp"
#include "way_back.hpp"

namespace setae::report {
namespace {

using output::Json;

template <class Items, class Condition>
std::size_t count_if(const Items& items, Condition condition) {
    return static_cast<std::size_t>(std::ranges::count_if(items, condition));
}

struct Chapter {
    std::string identifier, title, html;
};

std::string tables_html(const study::StudyResult& result, const Json& study) {
    std::string html;
    for (const auto& table : parameter_tables(result, study)) html += as_html(table, study);
    return html.empty() ? "<p>The study has no numbers to show.</p>" : html;
}

/// Chapters of the report, in order; empty ones are left out.
std::vector<Chapter> chapters_of(const study::StudyResult& result,
                                 const std::vector<study_figures::StudyFigure>& figures, const RunRecord& run,
                                 const Json& study) {
    FigurePage page{.study = result.study.path, .remarks = {}};
    page.of_a_kind = {{"spectra", count_if(result.surfaces, [](const auto& s) { return !s.measurements.empty(); })},
                      {"loop", count_if(result.experiments, [](const auto& e) { return e.analysis.has_value(); })}};
    if (result.prediction_test) page.remarks["prediction"] = prose(output::deviation_note(*result.prediction_test));
    const auto parts = figures_html(figures, page);
    const std::string undrawn =
        "<noscript><p>A script in this page draws the figures. This browser does not run scripts.</p></noscript>";
    std::vector<Chapter> chapters{
        {"verdict", "Verdict", verdict_html(result)},
        {"figures", "Figures", parts.carrying.empty() ? "<p>No figures were requested.</p>" : undrawn + parts.carrying},
        {"limits", "Conclusions and limits", limits_html(result)},
        {"tables", "Numbers",
         numbers_html(result, study) + retraction_html(result, study, parts.way_back) + tables_html(result, study)},
        {"more-figures", "More figures", parts.others},
        {"cut", "Excluded data", cut_html(result)},
        {"alerts", "Warnings", alerts_html(result)},
        {"steps", "Steps and methods", steps_html(result) + methods_html(result)},
        {"provenance", "Provenance", provenance_html(result, run)},
        {"references", "References", references_html()},
    };
    std::erase_if(chapters, [](const Chapter& chapter) { return chapter.html.empty(); });
    return chapters;
}

}  // namespace

std::string as_html(const study::StudyResult& result, const std::vector<study_figures::StudyFigure>& figures,
                    const RunRecord& run) {
    const auto study = output::json_without_curves(result, max_rows, max_experiments);
    const auto chapters = chapters_of(result, figures, run, study);
    const auto title = escaped(result.study.title.empty() ? "Study" : result.study.title);
    std::string page =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        // only content of the page is loaded, for any name in it
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<meta name=\"generator\" content=\"setae " +
        escaped(study::version()) + "\">\n<link rel=\"icon\" href=\"data:,\">\n<title>" + title + "</title>\n<style>\n";
    page += assets::style;
    page +=
        "</style>\n</head>\n<body>\n<a class=\"skip\" href=\"#main\">To the text</a>\n<header><h1>" + title + "</h1>";
    if (!result.study.description.empty())
        page += "<p class=\"description\">" + escaped(result.study.description) + "</p>";
    page += fmt::format("<p class=\"made\">setae {} · {}</p></header>\n<nav aria-label=\"Contents\"><ul>",
                        escaped(study::version()), escaped(run.time));
    for (const auto& chapter : chapters)
        page += fmt::format("<li><a href=\"#{}\">{}</a></li>", chapter.identifier, chapter.title);
    page +=
        "</ul><button type=\"button\" id=\"unfold\" aria-pressed=\"false\">Unfold everything</button></nav>\n<main id=\"main\">\n";
    for (const auto& chapter : chapters)
        page += fmt::format(
            "<section id=\"{0}\" aria-labelledby=\"{0}-heading\"><h2 id=\"{0}-heading\">{1}</h2>\n{2}</section>\n",
            chapter.identifier, chapter.title, chapter.html);
    page += "</main>\n<script type=\"application/json\" id=\"study\">" + script_json(study) + "</script>\n<script>\n";
    page += assets::plotly;
    page += "\n</script>\n<script>\n";
    page += assets::program;
    return page + "</script>\n</body>\n</html>\n";
}

std::string as_html(const Quantity& quantity) { return quantity_html(output::to_json(quantity), "", true); }

}  // namespace setae::report
