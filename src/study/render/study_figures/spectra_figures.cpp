// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "curves.hpp"
#include "drawing.hpp"
#include "setae/core/errors.hpp"
#include "setae/spectra/combination.hpp"

namespace setae::study_figures {
namespace {

using figures::Mark;
using figures::Panel;
using study::MeasurementResult;
using study::StudyResult;
using study::SurfaceResult;

const figures::Axis wavevector_axis{.quantity = "wavevector *q*", .unit = "1/m", .logarithmic = true};
const figures::Axis C1D_axis{.quantity = "power spectral density *C*_{1D}", .unit = "m3", .logarithmic = true};

std::vector<const SurfaceResult*> surfaces_of(const StudyResult& result) {
    std::vector<const SurfaceResult*> surfaces;
    for (const auto& surface : result.surfaces) surfaces.push_back(&surface);
    return surfaces;
}

/// A curve with its band of uncertainty below it.
void add_curve(Panel& panel, const SurfaceCurve& curve, const std::string& label, int place) {
    const int colour = colour_of_place(static_cast<std::size_t>(place));
    if (curve.lower.size() > 0)
        panel.series.push_back({.label = label + ", 95 %",
                                .x = curve.wavevector,
                                .lower = curve.lower,
                                .upper = curve.upper,
                                .mark = Mark::band,
                                .colour = colour,
                                .in_legend = false});
    panel.series.push_back(
        {.label = label, .x = curve.wavevector, .y = curve.values, .mark = Mark::line, .colour = colour, .dash = 0});
}

/// Methods of the curves of a study, "NAME fitted to …".
class Methods {
public:
    void add(const SurfaceResult& surface, const SurfaceCurve& curve) {
        const auto words = method_in_words(curve.method);
        for (auto& [known, names] : names_)
            if (known == words) {
                names += ", " + surface.name;
                return;
            }
        names_.emplace_back(words, surface.name);
    }
    [[nodiscard]] std::string text() const {
        std::string text;
        for (const auto& [words, names] : names_) text += (text.empty() ? "" : "; ") + names + " " + words;
        return text;
    }

private:
    std::vector<std::pair<std::string, std::string>> names_;
};

/// Bars with the reliable wavevectors of each instrument, in a strip above the data.
void add_bars(Panel& panel, const std::vector<InstrumentBand>& bands) {
    if (bands.empty()) return;
    double least = HUGE_VAL, most = 0.0;
    for (const auto& series : panel.series)
        for (const double y : series.y)
            if (y > 0.0 && std::isfinite(y)) {
                least = std::min(least, y);
                most = std::max(most, y);
            }
    double highest = 0.0;
    for (const auto& bar : bands) highest = std::max(highest, bar.band.upper);
    const double decades = std::log10(most / least), step = 0.065 * decades;
    for (std::size_t i = 0; i < bands.size(); ++i) {
        const auto& [name, band] = bands[i];
        const double height =
            most * std::pow(10.0, 0.05 * decades + step * (static_cast<double>(bands.size() - 1 - i) + 0.6));
        panel.series.push_back({.label = "reliable band of " + name,
                                .x = Array1D{{band.lower, band.upper}},
                                .y = Array1D{{height, height}},
                                .mark = Mark::line,
                                .colour = figures::instrument_look(name).colour,
                                .dash = 0,
                                .line_width = 3.5,
                                .in_legend = false});
        // to the left of a bar without space to its right
        const bool right =
            std::log(band.upper / bands.front().band.lower) < 0.8 * std::log(highest / bands.front().band.lower);
        panel.notes.push_back({.text = name,
                               .x = right ? band.upper : band.lower,
                               .y = height,
                               .side = right ? figures::Note::Side::right : figures::Note::Side::left,
                               .colour = figures::instrument_look(name).colour});
    }
    panel.y.from = least * std::pow(10.0, -0.04 * decades);
    panel.y.to = most * std::pow(10.0, 0.05 * decades + step * (static_cast<double>(bands.size()) + 0.3));
}

/// A unit for lengths, with its number per metre.
struct LengthUnit {
    std::string name;
    double per_metre;
};
LengthUnit length_unit(double length) {
    if (length >= 1e-3) return {"mm", 1e3};
    return length >= 2e-6 ? LengthUnit{"um", 1e6} : LengthUnit{"nm", 1e9};
}

bool is_map(const MeasurementResult& m) { return !m.failed() && m.preview.map.size() > 0; }
bool is_contour(const MeasurementResult& m) {
    return !m.failed() && instrument_of(m) == "TEM" && m.preview.heights.size() > 1 && m.preview.positions.size() > 1;
}

/// The first surface that has both kinds of picture, else the first that has one.
const SurfaceResult* pictured_surface(const StudyResult& result) {
    const SurfaceResult* best = nullptr;
    int most = 0;
    for (const auto& surface : result.surfaces) {
        const auto& all = surface.measurements;
        const int kinds = (std::any_of(all.begin(), all.end(), is_map) ? 1 : 0) +
                          (std::any_of(all.begin(), all.end(), is_contour) ? 1 : 0);
        if (kinds > most) {
            most = kinds;
            best = &surface;
        }
    }
    return best;
}

Panel map_panel(const std::string& title, const std::string& surface, const MeasurementResult& m) {
    const auto& preview = m.preview;
    const auto across = length_unit(preview.size[0]);
    const auto heights = length_unit(preview.map.isFinite().select(preview.map.abs(), 0.0).maxCoeff());
    const figures::Axis length{.quantity = "*x*", .unit = across.name};
    Panel panel{.title = title,
                .shows = surface + ", " + instrument_of(m),
                .x = length,
                .y = {.quantity = "*y*", .unit = across.name},
                .legend = false};
    panel.map = figures::HeatMap{preview.map * heights.per_metre,
                                 preview.size[0] * across.per_metre,
                                 preview.size[1] * across.per_metre,
                                 {.quantity = "height *h*", .unit = heights.name}};
    return panel;
}

Panel contour_panel(const std::string& title, const std::string& surface, const MeasurementResult& m) {
    const auto& preview = m.preview;
    const auto across = length_unit(preview.size[0]),
               heights = length_unit(preview.heights.isFinite().select(preview.heights.abs(), 0.0).maxCoeff());
    Panel panel{.title = title,
                .shows = surface + ", TEM",
                .x = {.quantity = "*x*", .unit = across.name},
                .y = {.quantity = "height *h*", .unit = heights.name},
                .legend = false};
    const Array1D x = (preview.positions - preview.positions[0]) * across.per_metre;
    panel.x.from = 0.0;
    panel.x.to = x[x.size() - 1];
    panel.series.push_back({.label = m.name,
                            .x = x,
                            .y = preview.heights * heights.per_metre,
                            .mark = Mark::line,
                            .colour = figures::instrument_look("tem").colour,
                            .dash = 0,
                            .line_width = 1.0});
    return panel;
}

/// Pictures next to the spectra: a map and a contour of one surface. Returns their part of the caption.
std::string add_pictures(figures::Figure& figure, const StudyResult& result) {
    const auto* surface = pictured_surface(result);
    if (!surface) return {};
    std::vector<std::pair<Panel, std::string>> pictures;
    const auto& all = surface->measurements;
    if (const auto map = std::find_if(all.begin(), all.end(), is_map); map != all.end())
        pictures.emplace_back(map_panel("B", surface->name, *map),
                              fmt::format("{} map {} of {}", instrument_of(*map), map->name, surface->name));
    if (const auto contour = std::find_if(all.begin(), all.end(), is_contour); contour != all.end())
        pictures.emplace_back(contour_panel(pictures.empty() ? "B" : "C", surface->name, *contour),
                              fmt::format("TEM contour {} of {}", contour->name, surface->name));
    constexpr double share = 0.64;
    figure.panels[0].title = "A";
    figure.panels[0].shows = "every surface";
    figure.panels[0].place = figures::Place{0.0, 0.0, share, 1.0};
    std::string words;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        auto& [panel, text] = pictures[i];
        // a map needs a square, a contour the rest
        const double upper = pictures.size() == 1 ? 1.0 : 0.56;
        panel.place = i == 0 ? figures::Place{share, 0.0, 1.0 - share, upper}
                             : figures::Place{share, upper, 1.0 - share, 1.0 - upper};
        words += fmt::format(" {}: {}.", panel.title, text);
        figure.panels.push_back(panel);
    }
    return words;
}

std::string failed_surfaces(const StudyResult& result) {
    std::string names;
    for (const auto& surface : drawn_surfaces(result))
        if (surface.failed()) names += (names.empty() ? "" : ", ") + surface.name;
    return names.empty() ? "" : " Failed and not drawn: " + names + ".";
}

bool nothing_to_show(const FigureRequest& request, StudyFigure& drawn) {
    if (request.result.surfaces.empty()) drawn.reason = "the study has no surface";
    else if (std::all_of(request.result.surfaces.begin(), request.result.surfaces.end(),
                         [](const SurfaceResult& s) { return s.failed(); }))
        drawn.reason = "every surface failed";
    return !drawn.drawable();
}

/// The curve of one instrument on one surface: its measurements averaged within their reliable bands.
std::optional<SurfaceCurve> curve_of_instrument(const SurfaceResult& surface, const std::string& instrument) {
    std::vector<spectra::MeasuredSpectrum> spectra;
    for (const auto& m : surface.measurements)
        if (!m.failed() && instrument_of(m) == instrument && m.spectrum.band.upper > m.spectrum.band.lower)
            spectra.push_back(m.spectrum);
    if (spectra.empty()) return std::nullopt;
    const auto combined = spectra::combine(spectra);
    return SurfaceCurve{.wavevector = combined.wavevector, .values = combined.density, .method = "average"};
}

}  // namespace

void combined_spectra(const FigureRequest& request, StudyFigure& drawn) {
    if (nothing_to_show(request, drawn)) return;
    const auto& result = request.result;
    Panel panel{.x = wavevector_axis, .y = C1D_axis};
    Methods methods;
    bool bands = false;
    std::size_t n = 0;
    const auto shown = drawn_surfaces(result);
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const auto& surface = shown[i];
        const auto curve = C1D_of(surface);
        if (!curve) continue;
        ++n;
        add_curve(panel, *curve, label_of(surface), static_cast<int>(i));
        methods.add(surface, *curve);
        bands = bands || curve->lower.size() > 0;
    }
    if (n == 0) {
        drawn.reason = "no spectrum has two points";
        return;
    }
    const auto instruments = instrument_bands(surfaces_of(result));
    panel.legend_corner = figures::Corner::bottom_left;
    add_bars(panel, instruments);
    const bool pictures = wide(request) && pictured_surface(result) != nullptr;
    drawn.figure = {.panels = {panel},
                    .width_mm = !wide(request) ? column_mm
                                : pictures     ? page_mm
                                               : 120.0,
                    .height_mm = !wide(request) ? 75.0
                                 : pictures     ? 95.0
                                                : 85.0};
    const auto pictured = pictures ? add_pictures(drawn.figure, result) : std::string();
    drawn.caption = fmt::format(
        "{}C1D against wavevector q of {} ({}).{}{}{}{}{} Conventions of C1D: Jacobs et al. 2017; compare Fig. 1 of Dalvi et al. 2019.",
        pictures ? "A: " : "", counted(n, "surface"), methods.text(), bands ? " Shaded: 95 %." : "",
        instruments.empty() ? "" : " Bars: reliable wavevectors of each instrument.", pictured,
        left_out_surfaces(result) + failed_surfaces(result), reconstruction_note(result) + floored_note(result));
}

void isotropic_spectra(const FigureRequest& request, StudyFigure& drawn) {
    if (nothing_to_show(request, drawn)) return;
    const auto& result = request.result;
    const auto conversion = result.study.analysis.conversion;
    Panel panel{.x = wavevector_axis,
                .y = {.quantity = "isotropic power spectral density *C*_{iso}", .unit = "m4", .logarithmic = true}};
    Methods methods;
    bool bands = false, converted = false;
    std::size_t n = 0;
    const auto shown = drawn_surfaces(result);
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const auto curve = C_iso_of(shown[i], conversion);
        if (!curve) continue;
        ++n;
        add_curve(panel, *curve, label_of(shown[i]), static_cast<int>(i));
        methods.add(shown[i], *curve);
        bands = bands || curve->lower.size() > 0;
        converted = converted || curve->method == "average" || curve->method == "given";
    }
    if (n == 0) {
        drawn.reason = "no spectrum has two points";
        return;
    }
    panel.legend_corner = figures::Corner::bottom_left;
    drawn.figure = {
        .panels = {panel}, .width_mm = wide(request) ? 120.0 : column_mm, .height_mm = wide(request) ? 85.0 : 70.0};
    drawn.caption = fmt::format("C_iso against wavevector q of {} ({}).{}{}{}{} Compare Fig. S3 of Dalvi et al. 2019.",
                                counted(n, "surface"), methods.text(),
                                !converted ? ""
                                : conversion == roughness::Conversion::exact
                                    ? " Averages are converted to C_iso by the inverse Abel integral."
                                    : " Averages are converted to C_iso by Eq. 11.",
                                bands ? " Shaded: 95 %." : "", left_out_surfaces(result) + failed_surfaces(result),
                                reconstruction_note(result) + floored_note(result));
}

void spectra_by_instrument(const FigureRequest& request, StudyFigure& drawn) {
    if (nothing_to_show(request, drawn)) return;
    const auto& result = request.result;
    const auto instruments = instrument_bands(surfaces_of(result));
    if (instruments.empty()) {
        drawn.reason = "no surface has measurements: all spectra are published or given";
        return;
    }
    double lowest = HUGE_VAL, highest = 0.0, least = HUGE_VAL, most = 0.0;
    for (const auto& surface : drawn_surfaces(result)) {
        Panel panel{.title = surface.name, .x = wavevector_axis, .y = C1D_axis};
        panel.legend_corner = figures::Corner::bottom_left;
        for (const auto& [instrument, band] : instruments) {
            const auto curve = curve_of_instrument(surface, instrument);
            if (!curve) continue;
            const auto look = figures::instrument_look(instrument);
            panel.series.push_back({.label = surface.name + ", " + instrument,
                                    .x = curve->wavevector,
                                    .y = curve->values,
                                    .mark = Mark::line,
                                    .colour = look.colour,
                                    .dash = look.symbol,
                                    .in_legend = false});
            lowest = std::min(lowest, curve->wavevector.minCoeff());
            highest = std::max(highest, curve->wavevector.maxCoeff());
            for (const double value : curve->values)
                if (value > 0.0) {
                    least = std::min(least, value);
                    most = std::max(most, value);
                }
        }
        if (!panel.series.empty()) drawn.figure.panels.push_back(std::move(panel));
    }
    if (drawn.figure.panels.empty()) {
        drawn.reason = "no measurement has a reliable band";
        return;
    }
    for (const auto& [instrument, band] : instruments) {
        const auto look = figures::instrument_look(instrument);
        drawn.figure.panels.front().series.push_back(
            {.label = instrument, .mark = Mark::line, .colour = look.colour, .dash = look.symbol, .legend_only = true});
    }
    // all panels in one frame: they are to be compared
    const double margin = most > least ? std::pow(most / least, 0.04) : 2.0;
    for (auto& panel : drawn.figure.panels) {
        panel.x.from = lowest / 1.5;
        panel.x.to = 1.5 * highest;
        panel.y.from = least / margin;
        panel.y.to = most * margin;
    }
    arrange(drawn.figure, request.options.width, 75.0);
    drawn.caption = fmt::format(
        "C1D of each surface by technique: the mean over the measurements of a technique, each within its own reliable band, "
        "in ten bins per decade. Techniques disagree where their lines differ.{} Compare Fig. S2 of Dalvi et al. 2019.",
        left_out_surfaces(result) + failed_surfaces(result));
}

}  // namespace setae::study_figures
