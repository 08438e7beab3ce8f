// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/line_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/uncertain_text.hpp"
#include "setae/core/units.hpp"

namespace setae::answers {
namespace {

using contact_line::ContactLine;

/// The frames of a line within a range of time.
ContactLine within(const ContactLine& line, double from, double to) {
    std::vector<Index> kept;
    for (Index i = 0; i < line.frames(); ++i)
        if (line.time[i] >= from && line.time[i] <= to) kept.push_back(i);
    ContactLine result{.time = Array1D(std::ssize(kept)), .radius = Array2D(std::ssize(kept), line.angles())};
    for (Index i = 0; i < std::ssize(kept); ++i) {
        result.time[i] = line.time[kept[static_cast<std::size_t>(i)]];
        result.radius.row(i) = line.radius.row(kept[static_cast<std::size_t>(i)]);
    }
    return result;
}

/// Less the first harmonic, which is the centre's.
double squares_about_centre(const Array1D& difference) {
    const Index n = difference.size();
    const Array1D angle = Array1D::LinSpaced(n, 0.0, static_cast<double>(n - 1)) * (2.0 * pi / static_cast<double>(n));
    const Array1D cosine = angle.cos(), sine = angle.sin();
    const double scale = 2.0 / static_cast<double>(n);
    return (difference - scale * (difference * cosine).sum() * cosine - scale * (difference * sine).sum() * sine)
        .square()
        .mean();
}

std::string number_of(const std::optional<double>& value, const char* unit) {
    return value ? format_value(*value, unit, 3) : "–";
}

/// A result of one edge, as text.
struct Statement {
    std::string quantity;
    std::function<std::string(const LineAnswer&)> text;
};

Statement of_motion(std::string quantity, std::optional<LineMotion> LineAnswer::*motion,
                    const std::function<std::string(const LineMotion&)>& text) {
    return {std::move(quantity),
            [=](const LineAnswer& answer) { return answer.*motion ? text(*(answer.*motion)) : "–"; }};
}

std::string tail_text(const std::optional<contact_line::PowerLawTail>& tail) {
    return tail ? uncertain_number(tail->exponent) : "–";
}

std::vector<Statement> statements() {
    std::vector<Statement> list{
        {"frames", [](const LineAnswer& a) { return fmt::format("{}", a.recorded.line.frames()); }},
        {"places along the edge", [](const LineAnswer& a) { return fmt::format("{}", a.recorded.line.angles()); }},
        {"roughness exponent",
         [](const LineAnswer& a) { return a.roughness ? uncertain_number(a.roughness->exponent) : "–"; }},
        {"deviation from an ellipse, rms",
         [](const LineAnswer& a) { return number_of(std::sqrt(a.shape.deviation.square().mean()), "m"); }}};
    for (const auto& [direction, motion] :
         {std::pair{"receding", &LineAnswer::receding}, {"advancing", &LineAnswer::advancing}}) {
        const auto add = [&, direction = direction, motion = motion](
                             const char* what, const std::function<std::string(const LineMotion&)>& text) {
            list.push_back(of_motion(fmt::format("{}: {}", direction, what), motion, text));
        };
        add("mean speed", [](const LineMotion& m) { return number_of(m.passage.mean_speed, "m/s"); });
        add("jumps", [](const LineMotion& m) { return fmt::format("{}", m.jumps.size()); });
        add("largest jump",
            [](const LineMotion& m) { return m.jumps.empty() ? "–" : number_of(m.jumps.front().area, "m2"); });
        add("exponent of jumps", [](const LineMotion& m) { return tail_text(m.jump_tail); });
        add("arrests", [](const LineMotion& m) { return fmt::format("{}", m.arrests.size()); });
    }
    for (const auto& [what, rate] : {std::pair{"retracting: release rate", &LineAnswer::retracting_rate},
                                     {"advancing: release rate", &LineAnswer::advancing_rate}})
        list.push_back(
            {what, [rate = rate](const LineAnswer& a) {
                 const auto& found = a.*rate;
                 return found ? number_of(found->mean, "J/m2") + ", scatter " + number_of(found->scatter, "J/m2") : "–";
             }});
    return list;
}

}  // namespace

LineComparison beside(const LineAnswer& answer, RecordedEdge other, const LineRequest& request) {
    auto alike = request;  // roughness over the same modes
    if (answer.roughness)
        alike.largest_mode = std::min<long>(answer.roughness->largest_mode, other.line.line.angles() / 2);
    LineComparison found{.other = contact_line_answer(std::move(other), alike)};
    const auto &own = answer.recorded.line, &theirs = found.other.recorded.line;
    const auto shared = within(own, theirs.time[0], theirs.time[theirs.frames() - 1]);
    found.frames = shared.frames();
    if (found.frames == 0) return found;
    const Index angles = std::min(own.angles(), theirs.angles());
    const auto mine = contact_line::at_fewer_angles(shared, angles),
               beside = contact_line::at_fewer_angles(contact_line::at_times(theirs, shared.time), angles);
    double sum = 0.0;
    for (Index i = 0; i < found.frames; ++i)
        sum += squares_about_centre((mine.radius.row(i) - beside.radius.row(i)).transpose());
    found.difference = std::sqrt(sum / static_cast<double>(found.frames));
    return found;
}

tables::TidyTable comparison_table(const LineAnswer& answer, const LineComparison& comparison, const std::string& name,
                                   const std::string& other_name) {
    tables::TidyTable table;
    table.columns = {"", name, other_name};
    for (const auto& statement : statements()) {
        auto mine = statement.text(answer), theirs = statement.text(comparison.other);
        if (mine == "–" && theirs == "–") continue;
        table.rows.push_back({statement.quantity, std::move(mine), std::move(theirs)});
    }
    return table;
}

}  // namespace setae::answers
