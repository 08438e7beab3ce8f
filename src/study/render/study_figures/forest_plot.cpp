// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study_figures/forest_plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"
#include "setae/core/text.hpp"

namespace setae::study_figures {
namespace {

using namespace statistics;

using figures::Mark;
using figures::Series;

/// At most so many letters, the rest as an ellipsis.
std::string shortened(const std::string& text, std::size_t most) {
    std::size_t letters = 0, at = 0;
    while (at < text.size() && letters < most) {
        at += std::max<std::size_t>(1, utf8_length(std::string_view(text).substr(at)));
        ++letters;
    }
    return at >= text.size() ? text : text.substr(0, at) + "…";
}

Array1D single(double value) { return Array1D::Constant(1, value); }

/// Black is the means' colour.
int colour_of(std::size_t surface) {
    constexpr std::array colours{0, 1, 2, 3, 5, 6};
    return colours[surface % colours.size()];
}

/// Lines of the plot from the top; gnuplot counts categories from below.
class Lines {
public:
    explicit Lines(std::size_t count) : labels_(count) {}
    /// The height of the next line.
    double add(const std::string& label) {
        constexpr std::size_t longest = 30;
        labels_[labels_.size() - 1 - used_] = shortened(label, longest);
        return static_cast<double>(labels_.size() - 1 - used_++);
    }
    [[nodiscard]] const std::vector<std::string>& labels() const { return labels_; }

private:
    std::vector<std::string> labels_;
    std::size_t used_ = 0;
};

/// Rows of a surface: groups together, in order of their first row.
std::vector<std::size_t> ordered_rows(const ReplicateData& data, const std::string& surface) {
    std::vector<std::size_t> rows;
    std::vector<std::string> outer;
    const bool grouped = data.levels.size() > 1;
    for (std::size_t i = 0; i < data.rows.size(); ++i) {
        if (data.rows[i].groups[0] != surface) continue;
        rows.push_back(i);
        if (grouped && std::find(outer.begin(), outer.end(), data.rows[i].groups[1]) == outer.end())
            outer.push_back(data.rows[i].groups[1]);
    }
    if (grouped)
        std::stable_sort(rows.begin(), rows.end(), [&](std::size_t a, std::size_t b) {
            return std::find(outer.begin(), outer.end(), data.rows[a].groups[1]) <
                   std::find(outer.begin(), outer.end(), data.rows[b].groups[1]);
        });
    return rows;
}

/// "lens 1 · spot 2", numbered where several rows have the same groups; a row without groups by its name.
std::vector<std::string> row_labels(const ReplicateData& data, const std::vector<std::size_t>& rows) {
    std::map<std::string, int> of_label, seen;
    const auto plain = [&](std::size_t row) {
        std::string label;
        for (std::size_t k = 1; k < data.levels.size(); ++k)
            if (const auto& group = data.rows[row].groups[k]; !group.empty())
                label += fmt::format("{}{} {}", label.empty() ? "" : " · ", data.levels[k], group);
        return label.empty() ? data.rows[row].name : label;
    };
    for (const auto row : rows) ++of_label[plain(row)];
    std::vector<std::string> labels;
    for (const auto row : rows) {
        const auto label = plain(row);
        labels.push_back(of_label[label] > 1 ? fmt::format("{} ({})", label, ++seen[label]) : label);
    }
    return labels;
}

/// A diamond as wide as an interval.
Series diamond(const Interval& interval, double middle, double height, const std::string& label, Mark mark) {
    constexpr double half = 0.32;
    return {.label = label,
            .x = Array1D{{interval.lower, middle, interval.upper, middle, interval.lower}},
            .y = Array1D{{height, height + half, height, height - half, height}},
            .mark = mark,
            .colour = 4,
            .dash = 0,
            .line_width = 0.9,
            .in_legend = false};
}

void add_mean(figures::Panel& panel, Lines& lines, const ForestPlotOptions& options, const std::string& label,
              const Estimate& mean, const std::optional<Interval>& prediction, const std::string& surface,
              bool hollow) {
    const double height = lines.add(label), value = mean.value * options.factor;
    const auto name = surface + ", " + label;
    if (prediction)
        panel.series.push_back({.label = name + ", prediction",
                                .x = Array1D{{prediction->lower * options.factor, prediction->upper * options.factor}},
                                .y = Array1D::Constant(2, height),
                                .mark = Mark::line,
                                .colour = 4,
                                .dash = 0,
                                .line_width = 0.6,
                                .in_legend = false});
    if (mean.interval) {
        const Interval drawn{mean.interval->lower * options.factor, mean.interval->upper * options.factor,
                             mean.interval->level};
        if (!hollow) panel.series.push_back(diamond(drawn, value, height, name, Mark::area));
        panel.series.push_back(diamond(drawn, value, height, hollow ? name : name + ", outline", Mark::line));
    } else
        panel.series.push_back({.label = name,
                                .x = single(value),
                                .y = single(height),
                                .mark = Mark::points,
                                .colour = 4,
                                .symbol = 3,
                                .hollow = hollow,
                                .in_legend = false});
}

/// The prefix that puts the largest value into [1, 1000).
void choose_unit(ForestPlotOptions& options, const ReplicateData& data) {
    options.unit = data.unit;
    options.factor = 1.0;
    double largest = 0.0;
    for (const auto& row : data.rows) largest = std::max(largest, std::abs(row.value));
    constexpr std::array units{"J/m2", "J", "Pa", "N", "m"};
    if (largest == 0.0 || std::find(units.begin(), units.end(), data.unit) == units.end()) return;
    constexpr std::array prefixes{"f", "p", "n", "u", "m", "", "k", "M", "G"};
    const long place = std::clamp(static_cast<long>(std::floor(std::log10(largest) / 3.0)), -5L, 3L);
    options.unit = prefixes[static_cast<std::size_t>(place + 5)] + data.unit;
    options.factor = std::pow(10.0, -3.0 * static_cast<double>(place));
}

void check(const ReplicateData& data, const MixedModel& model) {
    for (const auto& surface : model.surfaces) {
        const auto rows = std::count_if(data.rows.begin(), data.rows.end(), [&](const Replicate& row) {
            return row.groups.size() == data.levels.size() && row.groups[0] == surface.surface;
        });
        if (rows != surface.n + surface.excluded)
            throw InvalidArgument(
                fmt::format("a forest plot of {} rows on {} with a model of {}; expected the model of the same data",
                            rows, surface.surface, surface.n + surface.excluded));
    }
}

}  // namespace

figures::Figure forest_plot(const ReplicateData& data, const MixedModel& model, const ForestPlotOptions& wanted) {
    check(data, model);
    auto options = wanted;
    if (options.unit.empty()) choose_unit(options, data);
    std::vector<std::string> surfaces;
    for (const auto& row : data.rows)
        if (std::find(surfaces.begin(), surfaces.end(), row.groups[0]) == surfaces.end())
            surfaces.push_back(row.groups[0]);
    const auto mean_of = [&](const std::string& name) -> const SurfaceMean* {
        const auto found = std::find_if(model.surfaces.begin(), model.surfaces.end(),
                                        [&](const SurfaceMean& s) { return s.surface == name; });
        return found == model.surfaces.end() ? nullptr : &*found;
    };
    // a heading and a mean for each surface, a second mean where rows are excluded
    std::size_t count = data.rows.size() + surfaces.size();
    for (const auto& surface : model.surfaces) count += surface.with_excluded ? 2 : 1;
    Lines lines(count);
    figures::Panel panel{.x = {.quantity = options.quantity, .unit = options.unit}, .legend = false};
    const double reach = normal_quantile(0.5 * (1.0 + options.interval_level));
    double least = HUGE_VAL, most = -HUGE_VAL;
    const auto see = [&](double value) {
        least = std::min(least, value);
        most = std::max(most, value);
    };
    struct Reason {
        std::string text;
        double from, to, height;
    };
    std::vector<Reason> reasons;
    for (std::size_t place = 0; place < surfaces.size(); ++place) {
        const auto& name = surfaces[place];
        (void)lines.add(name);
        const auto rows = ordered_rows(data, name);
        const auto labels = row_labels(data, rows);
        for (const bool excluded : {false, true}) {
            std::vector<double> x, y, left, right;
            std::vector<std::string> names;
            Lines counted = lines;
            for (std::size_t i = 0; i < rows.size(); ++i) {
                const auto& row = data.rows[rows[i]];
                const double height = counted.add(labels[i]);
                const auto exclusion = std::find_if(data.exclusions.begin(), data.exclusions.end(),
                                                    [&](const Exclusion& e) { return e.row == rows[i]; });
                if ((exclusion != data.exclusions.end()) != excluded) continue;
                const double half = std::isnan(row.standard_error) ? 0.0 : reach * row.standard_error;
                x.push_back(row.value * options.factor);
                y.push_back(height);
                left.push_back((row.value - half) * options.factor);
                right.push_back((row.value + half) * options.factor);
                see(left.back());
                see(right.back());
                names.push_back(row.name + (excluded
                                                ? (row.name.empty() ? "excluded: " : ", excluded: ") + exclusion->reason
                                                : ""));
                if (excluded) reasons.push_back({exclusion->reason, left.back(), right.back(), height});
            }
            if (excluded) lines = counted;
            if (x.empty()) continue;
            const auto array = [](const std::vector<double>& values) {
                return Array1D(Eigen::Map<const Array1D>(values.data(), static_cast<Index>(values.size())));
            };
            panel.series.push_back({.label = name + (excluded ? ", excluded" : ""),
                                    .x = array(x),
                                    .y = array(y),
                                    .mark = Mark::points,
                                    .colour = colour_of(place),
                                    .symbol = 0,
                                    .hollow = excluded,
                                    .left = array(left),
                                    .right = array(right),
                                    .in_legend = false,
                                    .names = names});
        }
        if (const auto* surface = mean_of(name)) {
            add_mean(panel, lines, options, "mean", surface->mean, surface->prediction, name, false);
            if (surface->with_excluded)
                add_mean(panel, lines, options, "mean with excluded", *surface->with_excluded, std::nullopt, name,
                         true);
        }
    }
    panel.y.tick_labels = lines.labels();
    // a mean of few lenses may have an interval much wider than all rows: the rows must stay visible
    const double spread = most > least ? most - least : std::max(std::abs(most), 1.0);
    double from = least, to = most;
    for (const auto& series : panel.series)
        for (const double value : series.x) {
            from = std::min(from, std::max(value, least - 1.5 * spread));
            to = std::max(to, std::min(value, most + 1.5 * spread));
        }
    panel.x.from = from - 0.04 * (to - from) - 1e-12 * std::abs(from);
    panel.x.to = to + 0.04 * (to - from) + 1e-12 * std::abs(to);
    if (!(*panel.x.from < *panel.x.to)) panel.x.from = panel.x.to = std::nullopt;
    // the reason is placed where there is more space
    for (const auto& reason : reasons) {
        const bool right = to - reason.to >= reason.from - from;
        panel.notes.push_back({.text = shortened(reason.text, 44),
                               .x = right ? reason.to : reason.from,
                               .y = reason.height,
                               .side = right ? figures::Note::Side::right : figures::Note::Side::left});
    }
    constexpr double line_mm = 4.2, margins_mm = 14.0;
    return {.panels = {panel},
            .width_mm = options.width_mm,
            .height_mm = std::clamp(line_mm * static_cast<double>(count) + margins_mm, 40.0, 500.0)};
}

}  // namespace setae::study_figures
