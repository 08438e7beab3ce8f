// SPDX-License-Identifier: GPL-3.0-or-later
#include "smooth_limit_output.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace setae::output {
namespace {

/// Smallest and largest value of the elastomers.
struct Span {
    double least = std::numeric_limits<double>::infinity(), greatest = -std::numeric_limits<double>::infinity();

    void add(double value) {
        least = std::min(least, value);
        greatest = std::max(greatest, value);
    }
    /// [mJ/m²], one number where both are equal.
    [[nodiscard]] std::string text() const {
        const auto low = fmt::format("{:.0f}", 1e3 * least), high = fmt::format("{:.0f}", 1e3 * greatest);
        return low == high ? low : low + " … " + high;
    }
};

/// W_ret by a model minus that of the references.
Span distance_of(const study::Hysteresis& hysteresis, const hysteresis::RetractionModel& model) {
    Span off;
    for (const auto& of : hysteresis.smooth_limits)
        if (of.limit.model == model) off.add(of.limit.distance.value);
    return off;
}

}  // namespace

tables::TidyTable smooth_limit_table(const study::Hysteresis& hysteresis) {
    tables::TidyTable table{
        "retraction models on a smooth reference, r = 1 and U_el = 0 [mJ/m²]",
        {"model", "predicted W_ret at pull-off", "measured", "difference", "tends to the reference"},
        {}};
    for (const auto& score : hysteresis.all.models) {
        Span model, measured, off;
        bool tends = true, any = false;
        for (const auto& of : hysteresis.smooth_limits) {
            if (of.limit.model != score.fitted.model) continue;
            model.add(of.limit.work_retraction.value);
            measured.add(of.reference.value);
            off.add(of.limit.distance.value);
            tends = of.limit.tends_to_reference;
            any = true;
        }
        if (!any) continue;
        table.rows.push_back({score.fitted.model.name(), model.text(), measured.text(), off.text(),
                              std::string(tends ? "yes" : "no: for comparison only")});
    }
    return table;
}

std::vector<std::string> smooth_limit_sentences(const study::Hysteresis& hysteresis) {
    std::vector<hysteresis::RetractionModel> told;
    std::vector<std::string> sentences;
    for (const auto& pair : hysteresis.pairs) {
        if (!pair.likelier || std::ranges::find(told, pair.likelier->model) != told.end()) continue;
        const auto& model = told.emplace_back(pair.likelier->model);
        const auto off = distance_of(hysteresis, model);
        const auto missed = off.least > off.greatest
                                ? std::string("has no smooth limit")
                                : fmt::format("misses the smooth reference by {} mJ/m²", off.text());
        sentences.push_back(
            fmt::format("Predictions use the model {}, because {} {}", pair.model.name(), model.name(), missed));
    }
    return sentences;
}

}  // namespace setae::output
