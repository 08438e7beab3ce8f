// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/blind_tip.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/output/json.hpp"

namespace setae::answers {

topography::BlindTipOptions BlindTipRequest::options(parallel::Threads threads) const {
    topography::BlindTipOptions options{.points_x = points, .points_y = points, .rounds = rounds, .threads = threads};
    if (!threshold.empty()) options.noise_threshold = parse_quantity(threshold, dimension::length);
    return options;
}

BlindTipAnswer blind_tip(const std::string& file, const topography::Measurement& measurement,
                         const BlindTipRequest& request, parallel::Threads threads) {
    const auto* map = std::get_if<topography::HeightMap>(&measurement);
    if (!map) throw InvalidArgument(fmt::format("{}: a line does not show a tip; expected a map", file));
    BlindTipAnswer answer{.file = file,
                          .blind = topography::blind_tip(*map, request.options(threads)),
                          .tip = {},
                          .surface = {},
                          .quantities = {},
                          .alerts = {}};
    const auto& tip = answer.blind.tip;
    auto certainty = topography::certainty_map(*map, tip, {.threads = threads});
    answer.tip = {-tip.heights,
                  {static_cast<double>(tip.heights.rows()) * tip.pixel_size[0],
                   static_cast<double>(tip.heights.cols()) * tip.pixel_size[1]},
                  false,
                  map->metadata};
    answer.surface = std::move(certainty.reconstruction);
    answer.surface.heights = (certainty.certain > 0).select(answer.surface.heights, undefined).eval();
    answer.quantities = {output::quantity("tip_radius", "R", topography::apex_radius(tip), "m"),
                         output::quantity("tip_height", "t", tip.heights.maxCoeff(), "m"),
                         output::quantity("certain_share", "", certainty.share, "1")};
    if (!answer.blind.converged)
        answer.alerts.push_back(
            {"TIP_NOT_CONVERGED", topography::label(map->metadata),
             fmt::format("the estimate still sharpened in round {}: the tip may be sharper", answer.blind.rounds),
             "allow more with `rounds`"});
    const double radius = answer.quantities.front().estimate.value,
                 pixel = std::max(tip.pixel_size[0], tip.pixel_size[1]);
    if (radius < pixel)
        answer.alerts.push_back(
            {"TIP_BELOW_PIXEL", topography::label(map->metadata),
             fmt::format("the apex radius of {} is below the pixel size of {}: a map with such pixels cannot show it",
                         format_value(radius, "m", 3), format_value(pixel, "m", 3)),
             "use the pixel size as an upper limit of the radius, or scan with smaller pixels"});
    return answer;
}

}  // namespace setae::answers
