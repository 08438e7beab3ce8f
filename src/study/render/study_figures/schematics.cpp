// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "drawing.hpp"
#include "setae/core/constants.hpp"

namespace setae::study_figures {
namespace {

using figures::Mark;
using figures::Note;
using figures::Panel;
using figures::Series;

constexpr int soft = colour::sky, rough = colour::black, metal = colour::orange;

Panel sketch(const std::string& title, const std::string& shows, double width, double height) {
    return {.title = title,
            .shows = shows,
            .x = {.quantity = "x", .from = 0.0, .to = width},
            .y = {.quantity = "y", .from = 0.0, .to = height},
            .legend = false,
            .sketch = true};
}

Series filled(const std::string& label, const Array1D& x, const Array1D& y, int colour, double opacity) {
    return {.label = label, .x = x, .y = y, .mark = Mark::area, .colour = colour, .opacity = opacity};
}

Series stroke(const std::string& label, const Array1D& x, const Array1D& y, int colour, double width = 1.3) {
    return {.label = label, .x = x, .y = y, .mark = Mark::line, .colour = colour, .dash = 0, .line_width = width};
}

Array1D box_x(double left, double right) { return Array1D{{left, right, right, left}}; }
Array1D box_y(double lower, double upper) { return Array1D{{lower, lower, upper, upper}}; }

/// A line down with a head at its end.
void add_arrow(Panel& panel, const std::string& label, double x, double from, double to, int colour) {
    panel.series.push_back(stroke(label, Array1D{{x, x, NAN, x - 0.18, x, x + 0.18}},
                                  Array1D{{from, to, NAN, to + 0.3, to, to + 0.3}}, colour, 1.6));
}

/// The rough surface of all three states.
Array1D profile(const Array1D& x) {
    return 1.6 + 0.32 * (1.9 * x).sin() + 0.14 * (5.3 * x + 1.0).sin() + 0.06 * (11.7 * x).sin();
}

/// Between a lower and an upper curve over the same x.
Series between(const std::string& label, const Array1D& x, const Array1D& lower, const Array1D& upper, int colour,
               double opacity) {
    Array1D along(2 * x.size()), y(2 * x.size());
    along << x, x.reverse();
    y << lower, upper.reverse();
    return filled(label, along, y, colour, opacity);
}

enum class State { before, stretched, joined };

Panel state_panel(const std::string& title, const std::string& shows, State state) {
    constexpr double width = 6.0;
    const Array1D x = Array1D::LinSpaced(241, 0.3, width - 0.3), solid = profile(x);
    const auto flat = [&](double y) { return Array1D(Array1D::Constant(x.size(), y)); };
    auto panel = sketch(title, shows, width, 5.4);
    panel.series.push_back(between("rough solid", x, flat(0.3), solid, rough, 0.35));
    panel.series.push_back(stroke("surface of the rough solid", x, solid, rough));
    const Array1D lower = state == State::before ? flat(3.1) : state == State::stretched ? Array1D(solid + 1.5) : solid;
    const double top = state == State::joined ? 3.4 : 4.9;
    panel.series.push_back(between("soft solid", x, lower, flat(top), soft, 0.45));
    panel.series.push_back(stroke("surface of the soft solid", x, lower, state == State::joined ? rough : soft, 2.0));
    const auto note = [&](const std::string& text, double y) {
        panel.notes.push_back({.text = text, .x = 0.5 * width, .y = y});
    };
    if (state == State::before) note("soft, apparent area, γ1", 4.2);
    if (state == State::stretched) note("true area, γ1s, elastic energy", 4.4);
    if (state == State::joined) note("interface, true area, γ1s2", 2.9);
    note(state == State::joined ? "rough solid" : "rough, true area, γ2", 0.75);
    return panel;
}

}  // namespace

void states_of_the_balance(const FigureRequest& request, StudyFigure& drawn) {
    drawn.figure = {
        .panels = {state_panel("A", "undeformed", State::before), state_panel("B", "stretched", State::stretched),
                   state_panel("C", "joined", State::joined)},
        .columns = wide(request) ? 3 : 1,
        .width_mm = wide(request) ? page_mm : column_mm,
        .height_mm = wide(request) ? 62.0 : highest_column_mm};
    drawn.caption =
        "States of the energy balance. A: the soft side is flat and has the energy γ1 A_app, the rough side has γ2 A_true. B: the soft side is stretched to the "
        "true area and bent, which needs work against its surface stress and U_el. C: both surfaces are joined to one interface with the energy γ1s2 A_true. "
        "From A to C, the energy decreases by W_app A_app = W_int A_true − γ1 (A_true − A_app) − (γ1s2 − γ12) A_true − U_el, for any dependence of γ1 on stretch. "
        "This figure does not depend on the study. Compare Fig. 3 of Dalvi et al. 2019.";
}

void apparatus(const FigureRequest& request, StudyFigure& drawn) {
    auto panel = sketch("", "", 12.0, 9.6);
    constexpr double middle = 5.4;
    // from above: microscope, glass on the arm of the stage, lens, rough solid, force sensor
    panel.series.push_back(filled("microscope", Array1D{{middle - 0.7, middle + 0.7, middle + 0.4, middle - 0.4}},
                                  Array1D{{9.5, 9.5, 8.4, 8.4}}, metal, 1.0));
    panel.series.push_back(filled("arm of the stage", Array1D{{7.6, 9.6, 9.6, 9.1, 9.1, 7.6}},
                                  Array1D{{7.1, 7.1, 3.2, 3.2, 6.7, 6.7}}, metal, 1.0));
    panel.series.push_back(filled("glass", box_x(3.0, 7.8), box_y(6.8, 7.0), colour::green, 0.8));
    const Array1D angle = Array1D::LinSpaced(121, 0.0, pi);
    constexpr double flattened = 4.28;  // the contact is flat
    panel.series.push_back(
        filled("soft lens", middle + 1.55 * angle.cos(), (6.8 - 2.65 * angle.sin()).max(flattened), soft, 1.0));
    const Array1D x = Array1D::LinSpaced(241, 2.8, 8.0);
    panel.series.push_back(between("rough solid", x, Array1D::Constant(x.size(), 3.4),
                                   4.2 + 0.07 * (14.0 * x).sin() + 0.03 * (37.0 * x).sin(), rough, 0.6));
    const Array1D turns = Array1D::LinSpaced(161, 0.0, 1.0);
    panel.series.push_back(
        stroke("force sensor", middle + 0.45 * (turns * (10.0 * pi)).sin(), 3.4 - 1.9 * turns, rough, 1.0));
    panel.series.push_back(filled("base", box_x(3.0, 7.8), box_y(1.1, 1.5), metal, 1.0));
    for (const double side : {-1.0, 1.0})
        panel.series.push_back(stroke("view", Array1D{{middle + 0.4 * side, middle + 0.55 * side}},
                                      Array1D{{8.4, 4.35}}, colour::green, 0.8));
    add_arrow(panel, "displacement", 10.0, 6.9, 5.2, colour::blue);
    add_arrow(panel, "force", 2.3, 5.9, 4.3, colour::vermilion);
    const auto note = [&](const std::string& text, double at, double y, Note::Side side = Note::Side::right) {
        panel.notes.push_back({.text = text, .x = at, .y = y, .side = side});
    };
    note("microscope: radius a", 6.3, 9.0);
    note("stage: δ, v", 10.0, 7.5, Note::Side::centre);
    note("force F", 2.1, 5.1, Note::Side::left);
    note("soft lens", middle, 6.3, Note::Side::centre);
    note("E, R, h", middle, 5.8, Note::Side::centre);
    note("rough solid", 2.6, 3.8, Note::Side::left);
    note("force sensor, stiffness k", 6.1, 2.5);
    const double width = wide(request) ? 120.0 : column_mm;
    drawn.figure = {.panels = {panel}, .width_mm = width, .height_mm = 0.8 * width};
    drawn.caption =
        "Apparatus. A stage presses a soft lens on glass against a rough solid and retracts it. The rough solid is mounted on a force sensor of stiffness k. Force, "
        "displacement and, through the lens, the contact radius are recorded. These commands measure the parts: setae jkr lens (R, shape, h), jkr "
        "stiffness (k), jkr camera (scale). This figure does not depend on the study. Compare Fig. S4 of Dalvi et al. 2019.";
}

}  // namespace setae::study_figures
