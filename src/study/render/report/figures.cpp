// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "fold.hpp"
#include "markup.hpp"
#include "setae/core/text.hpp"
#include "setae/core/words.hpp"
#include "setae/figures/typesetting.hpp"

namespace setae::report {
namespace {

using output::Json;

Json values(const ArrayView1D& array) { return output::numbers(array); }

/// Quantity and unit as HTML, as text, and as the CSV names them.
Json axis_json(const figures::Axis& axis) {
    const auto unit = typeset_unit(axis.unit);
    Json json{{"quantity", figures::plain_text(axis.quantity)},
              {"unit", axis.unit.empty() ? "1" : axis.unit},
              {"html", typeset(axis.quantity)},
              {"shown_unit", unit}};
    if (axis.logarithmic) json["log"] = true;
    if (axis.from) json["from"] = *axis.from;
    if (axis.to) json["to"] = *axis.to;
    if (!axis.tick_labels.empty()) json["ticks"] = axis.tick_labels;
    return json;
}

const char* name_of(figures::Mark mark) {
    switch (mark) {
        case figures::Mark::points: return "points";
        case figures::Mark::line: return "line";
        case figures::Mark::both: return "both";
        case figures::Mark::band: return "band";
        case figures::Mark::area: return "area";
    }
    return "both";
}

/// Largest number of points of a series in a page; smaller for a figure with many series.
Index max_points(const figures::Figure& figure) {
    constexpr std::size_t of_a_figure = 20000, of_a_series = 1200, at_least = 9;
    std::size_t series = 1;
    for (const auto& panel : figure.panels) series += panel.series.size();
    return static_cast<Index>(std::clamp(of_a_figure / series, at_least, of_a_series));
}

/// Points to be drawn for a given number: of each section the first, the lowest and the highest.

std::vector<Index> seen_points(const figures::Series& series, Index most) {
    const Index n = series.x.size(), stretches = most / 3;
    std::vector<Index> places;
    for (Index k = 0; k < stretches; ++k) {
        const Index first = n * k / stretches, count = n * (k + 1) / stretches - first;
        Index lowest = 0, highest = 0;
        const auto part = series.y.segment(first, count);
        part.minCoeff<Eigen::PropagateNumbers>(&lowest);
        part.maxCoeff<Eigen::PropagateNumbers>(&highest);
        std::set<Index> wanted{first, first + lowest, first + highest};
        places.insert(places.end(), wanted.begin(), wanted.end());
    }
    if (places.back() != n - 1) places.push_back(n - 1);
    return places;
}

/// The series, reduced to these points.
figures::Series thinned(const figures::Series& series, Index most) {
    if (series.x.size() <= most || series.y.size() != series.x.size()) return series;
    const auto places = seen_points(series, most);
    auto thin = series;
    const auto pick = [&](Array1D& values) {
        if (values.size() == series.x.size()) values = Array1D(values(places));
    };
    for (auto* values : {&thin.x, &thin.y, &thin.lower, &thin.upper, &thin.left, &thin.right}) pick(*values);
    if (static_cast<Index>(series.names.size()) == series.x.size()) {
        thin.names.clear();
        for (const auto place : places) thin.names.push_back(series.names[static_cast<std::size_t>(place)]);
    }
    return thin;
}

bool is_thinned(const study_figures::StudyFigure& figure) {
    const auto most = max_points(figure.figure);
    return std::any_of(figure.figure.panels.begin(), figure.figure.panels.end(), [&](const figures::Panel& panel) {
        return std::any_of(panel.series.begin(), panel.series.end(), [&](const figures::Series& series) {
            return series.x.size() > most && series.y.size() == series.x.size();
        });
    });
}

Json series_json(const figures::Series& full, std::size_t place, Index most) {
    const auto series = thinned(full, most);
    const int colour = series.colour >= 0 ? series.colour : static_cast<int>(place);
    const int symbol = series.symbol >= 0 ? series.symbol : colour;
    Json json{{"label", series.label},
              {"mark", name_of(series.mark)},
              {"colour", colour},
              {"symbol", symbol},
              {"dash", series.dash >= 0 ? series.dash : symbol},
              {"x", values(series.x)}};
    if (series.y.size() > 0) json["y"] = values(series.y);
    if (series.lower.size() > 0) json["lower"] = values(series.lower);
    if (series.upper.size() > 0) json["upper"] = values(series.upper);
    if (series.left.size() > 0) json["left"] = values(series.left);
    if (series.right.size() > 0) json["right"] = values(series.right);
    if (!series.names.empty()) json["names"] = series.names;
    if (series.hollow) json["hollow"] = true;
    if (!series.in_legend) json["unlisted"] = true;
    if (series.legend_only) json["legend_only"] = true;
    json["width"] = series.line_width;
    json["opacity"] = series.opacity;
    return json;
}

Json map_json(const figures::HeatMap& map) {
    Json json{
        {"width", map.width}, {"height", map.height}, {"axis", axis_json(map.values_axis)}, {"columns", Json::array()}};
    for (Index i = 0; i < map.values.rows(); ++i) {
        const Array1D column = map.values.row(i);
        json["columns"].push_back(values(column));
    }
    return json;
}

/// "A  residuals": text above a panel.
std::string heading_text(const figures::Heading& heading) {
    return heading.letter + (heading.letter.empty() || heading.words.empty() ? "" : "  ") + heading.words;
}

Json panel_json(const figures::Figure& figure, std::size_t index, Index most) {
    const auto& panel = figure.panels[index];
    Json json{{"title", panel.title},    {"heading", heading_text(figures::heading_of(figure, index))},
              {"x", axis_json(panel.x)}, {"y", axis_json(panel.y)},
              {"legend", panel.legend},  {"series", Json::array()}};
    for (std::size_t i = 0; i < panel.series.size(); ++i)
        json["series"].push_back(series_json(panel.series[i], i, most));
    if (!panel.horizontal_lines.empty()) json["lines"] = panel.horizontal_lines;
    if (panel.legend_corner) {
        static constexpr std::array<const char*, 4> corners{"top right", "top left", "bottom right", "bottom left"};
        json["corner"] = corners[static_cast<std::size_t>(*panel.legend_corner)];
    }
    if (panel.sketch) json["x"]["hidden"] = json["y"]["hidden"] = true;
    if (panel.legend_right) json["beside"] = true;
    if (panel.place) json["place"] = {panel.place->left, panel.place->top, panel.place->width, panel.place->height};
    if (panel.map) json["map"] = map_json(*panel.map);
    for (const auto& note : panel.notes) {
        const char* side = note.side == figures::Note::Side::left    ? "left"
                           : note.side == figures::Note::Side::right ? "right"
                                                                     : "centre";
        json["notes"].push_back(
            {{"text", note.text}, {"x", note.x}, {"y", note.y}, {"side", side}, {"colour", note.colour}});
    }
    return json;
}

Json figure_json(const study_figures::StudyFigure& figure) {
    Json json{{"name", figure.name},
              {"title", figure.title},
              {"columns", figure.figure.columns},
              {"width", figure.figure.width_mm},
              {"height", figure.figure.height_mm},
              {"panels", Json::array()}};
    for (std::size_t p = 0; p < figure.figure.panels.size(); ++p)
        json["panels"].push_back(panel_json(figure.figure, p, max_points(figure.figure)));
    return json;
}

/// "figure-4", "figure-prediction", "figure-spectra_UNCD": the stem of its files, which no other figure has.
std::string anchor_of(const study_figures::StudyFigure& figure) {
    constexpr std::string_view numbered = "figure_";
    const std::string_view name = figure.name;
    return "figure-" + escaped(name.starts_with(numbered) ? name.substr(numbered.size()) : name);
}

std::string title_of(const study_figures::StudyFigure& figure) {
    return fmt::format("Figure {}: {}", escaped(figure.identifier), escaped(figure.title));
}

std::string caption_html(const study_figures::StudyFigure& figure, const FigurePage& page) {
    std::string html = "<p class=\"caption\">" + prose(figure.caption) +
                       (is_thinned(figure) ? " This page contains the points that the eye can distinguish; figures/" +
                                                 escaped(figure.name) + ".csv contains all points."
                                           : "") +
                       "</p>";
    if (const auto remark = page.remarks.find(figure.identifier); remark != page.remarks.end())
        html += "<p class=\"caption\">" + remark->second + "</p>";
    return html + fmt::format("<p class=\"command\">Command: <code>{}</code></p>",
                              escaped(fmt::format("setae plot {} --figure {}", shell_word(page.study),
                                                  shell_word(figure.identifier))));
}

/// Buttons, panels, caption, command, data; report.js draws them from the JSON.
std::string drawing_html(const study_figures::StudyFigure& figure, const FigurePage& page) {
    constexpr double page_mm = 178.0;  // a figure is as wide for the page's text as for a journal's
    const double share = std::min(1.0, figure.figure.width_mm / page_mm);
    std::string html = fmt::format(
        "<div class=\"tools\" role=\"group\" aria-label=\"Figure {0}\">"
        "<button type=\"button\" data-action=\"x\" aria-pressed=\"false\">log x</button><button type=\"button\" data-action=\"y\" aria-pressed=\"false\">log y</button>"
        "<button type=\"button\" data-action=\"legend\" aria-pressed=\"true\">legend</button><button type=\"button\" data-action=\"reset\">whole view</button>"
        "<button type=\"button\" data-action=\"svg\">SVG</button>"
        "<button type=\"button\" data-action=\"csv\">CSV</button></div>",
        escaped(figure.identifier));
    html += fmt::format(
        "<div class=\"drawing{}\" style=\"--share: {:.3f}\"><div class=\"plots\" style=\"--ratio: {:.3f}\" data-label=\"{}\"></div><div class=\"words\">{}</div></div>",
        share < 0.7 ? " narrow" : "", share, figure.figure.width_mm / figure.figure.height_mm,
        escaped(figure.title + ". " + figure.caption), caption_html(figure, page));
    html += fmt::format(
        "<details class=\"data\"><summary>Data of figure {0}</summary><div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"Data of figure {0}\"><pre></pre></div></details>",
        escaped(figure.identifier));
    return html + "<script type=\"application/json\" class=\"figure-data\">" + script_json(figure_json(figure)) +
           "</script>";
}

/// Part before the colon of "spectra:NAME"; empty where there is none.
std::string_view family_of(const study_figures::StudyFigure& figure) {
    const std::string_view identifier = figure.identifier;
    const auto colon = identifier.find(':');
    return colon == std::string_view::npos ? std::string_view() : identifier.substr(0, colon);
}

using Figures = std::vector<const study_figures::StudyFigure*>;

/// 4, prediction and 1, as far as they can be drawn; where none can, the first that can.
Figures carrying(const std::vector<study_figures::StudyFigure>& figures) {
    Figures found;
    for (const char* wanted : {"4", "prediction", "1"})
        for (const auto& figure : figures)
            if (figure.drawable() && figure.identifier == wanted) found.push_back(&figure);
    const auto first = std::find_if(figures.begin(), figures.end(), [](const auto& f) { return f.drawable(); });
    if (found.empty() && first != figures.end()) found.push_back(&*first);
    return found;
}

/// Figures of a family, with those that were not made.
std::size_t count_of(std::string_view family, const Figures& figures, const FigurePage& page) {
    const auto known = page.of_a_kind.find(family);
    return known == page.of_a_kind.end() ? figures.size() : std::max(known->second, figures.size());
}

/// One after the other, each folded.
std::string folded_html(const Figures& figures, const FigurePage& page, int level) {
    constexpr std::size_t max_bytes = 3'000'000;
    std::string html;
    std::size_t shown = 0;
    const auto family = std::string(figures.empty() ? "" : family_of(*figures.front()));
    for (const auto* figure : figures) {
        // one for each surface or loop: of many the first
        if (!family.empty() && (html.size() > max_bytes || shown == study_figures::max_of_a_kind_in_reports)) break;
        ++shown;
        html += as_html(Fold{.identifier = anchor_of(*figure),
                             .kind = "figure",
                             .title = title_of(*figure),
                             .html = drawing_html(*figure, page),
                             .level = level});
    }
    if (const auto all = count_of(family, figures, page); all > shown)
        html += fmt::format(
            "<p class=\"reason\">Figures of {} are not in this page, to keep it small. The folder figures contains "
            "them, and <code>setae plot {} --figure {}:NAME</code> draws one.</p>",
            family == "loop" ? counted(all - shown, "more loop", "more loops")
                             : counted(all - shown, "more surface", "more surfaces"),
            escaped(shell_word(page.study)), escaped(family));
    return html;
}

/// The figures by family; many of one family, such as one per loop, in a fold of their own.
std::string by_family_html(const Figures& figures, const FigurePage& page) {
    constexpr std::ptrdiff_t many = 3;
    std::string html;
    for (auto from = figures.begin(); from != figures.end();) {
        const auto family = family_of(**from);
        const auto to = family.empty() ? from + 1 : std::find_if(from, figures.end(), [&](const auto* figure) {
            return family_of(*figure) != family;
        });
        const Figures members(from, to);
        html += to - from > many ? as_html(Fold{.identifier = "figures-" + escaped(family),
                                                .kind = "family",
                                                .title = fmt::format("Figures {}:…", escaped(family)),
                                                .remark = fmt::format("{} figures", count_of(family, members, page)),
                                                .html = folded_html(members, page, 4)})
                                 : folded_html(members, page, 3);
        from = to;
    }
    return html;
}

std::string undrawable_html(const Figures& figures) {
    if (figures.empty()) return "";
    std::string items;
    for (const auto* figure : figures)
        items += fmt::format("<li id=\"{}\"><strong>{}</strong>. <span class=\"reason\">Not drawn: {}.</span></li>",
                             anchor_of(*figure), title_of(*figure), escaped(figure->reason));
    return as_html(Fold{.identifier = "not-drawn",
                        .kind = "text",
                        .title = "Figures not drawn",
                        .remark = counted(figures.size(), "figure", "figures"),
                        .html = "<ul>" + items + "</ul>"});
}

}  // namespace

FigureParts figures_html(const std::vector<study_figures::StudyFigure>& figures, const FigurePage& page) {
    FigureParts parts;
    const auto first = carrying(figures);
    for (const auto* figure : first)
        parts.carrying += unfolded_html(Fold{.identifier = anchor_of(*figure),
                                             .kind = "figure",
                                             .title = title_of(*figure),
                                             .html = drawing_html(*figure, page)});
    Figures others, way_back, undrawable;
    for (const auto& figure : figures)
        if (!figure.drawable()) undrawable.push_back(&figure);
        else if (figure.identifier == "hysteresis" || figure.identifier == "losses") way_back.push_back(&figure);
        else if (std::find(first.begin(), first.end(), &figure) == first.end()) others.push_back(&figure);
    parts.way_back = folded_html(way_back, page, 4);
    parts.others = by_family_html(others, page) + undrawable_html(undrawable);
    return parts;
}

}  // namespace setae::report
