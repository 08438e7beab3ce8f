// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/levelling.hpp"

#include <algorithm>

namespace setae::study {
namespace {

using topography::Trend;

Trend usual_trend(const std::string& instrument) { return instrument == "stylus" ? Trend::parabola : Trend::tilt; }

bool levels(const processing::Pipeline& pipeline) {
    return std::any_of(pipeline.entries.begin(), pipeline.entries.end(), [](const processing::Entry& entry) {
        const auto name = processing::name(entry.step);
        return entry.on && name.starts_with("level_") && name != "level_mean";
    });
}

}  // namespace

Trend trend_after(const processing::Pipeline& pipeline, const LevellingAsked& asked) {
    if (asked.given) return *asked.given;
    if (levels(pipeline)) return Trend::none;
    return asked.recommended.value_or(usual_trend(asked.instrument));
}

}  // namespace setae::study
