// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/output/predicted_quantities.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/uncertain_text.hpp"
#include "setae/core/units.hpp"
#include "setae/output/json.hpp"

namespace setae::output {
namespace {

/// Unmeasured waves are worth a sentence where they move W_app by more than this share.
constexpr double noted_share = 0.01;

std::string band_text(const Band& band) {
    return fmt::format("waves from {} to {}", format_value(2.0 * pi / band.lower, "m"),
                       format_value(2.0 * pi / band.upper, "m"));
}

std::string work_sentence(const study::StudyResult& result) {
    const auto& pair = result.pairs.front();
    return fmt::format("W_app {} on approach by (7), of {}: {}\n", format_interval(pair.modified->estimate, "J/m2"),
                       band_text(result.surfaces.front().used().curve.band),
                       pair.modified->work.conforms ? "it conforms" : "it does not conform");
}

std::string unmeasured_sentence(const study::PairResult& pair) {
    if (!pair.with_unmeasured_waves) return {};
    const auto& all = *pair.with_unmeasured_waves;
    const double measured = pair.modified->work.raw;
    const double change = std::max(std::abs(all.interval->lower - measured), std::abs(all.interval->upper - measured));
    if (change <= noted_share * std::abs(measured)) return {};
    return fmt::format("  with the waves that were not measured, if the spectrum goes on as it ends: {}\n",
                       format_interval(all, "J/m2"));
}

std::string loop_sentence(const study::StudyResult& result) {
    const auto& pair = result.pairs.front();
    if (!pair.loop) return {};
    const auto& loop = *pair.loop;
    return fmt::format("pressed with {}: contact radius {}, loss {} by (10) (a smooth sphere {}), pull-off at {}\n",
                       format_value(*result.elastomers.front().input.preload, "N"),
                       format_uncertain(loop.contact_radius, "m"), format_uncertain(loop.energy_loss.estimate(), "J"),
                       format_uncertain(loop.ideal_loss, "J"), format_uncertain(loop.pull_off_force, "N"));
}

}  // namespace

std::vector<Quantity> loop_quantities(const adhesion::PredictedLoop& loop) {
    std::vector<Quantity> list;
    const auto add = [&](const char* name, const char* symbol, const Estimate& value, const char* unit,
                         const char* source) {
        list.push_back(quantity(name, symbol, value, unit));
        list.back().source = source;
    };
    add("contact_radius", "a_max", loop.contact_radius, "m", "[D19] (1) with W_app");
    add("energy_loss", "E_loss", loop.energy_loss.estimate(), "J", "[D19] (10)");
    add("ideal_smooth_sphere_loss", "E_0", loop.ideal_loss, "J", "jumps of JKR under fixed grips");
    add("work_of_adhesion_retraction", "W_ret", loop.work_retraction, "J/m2", "edge and jumps lose E_loss");
    add("pull_off_force", "F_po", loop.pull_off_force, "N", "[D19] (S1) with W_ret");
    add("pull_off_force_reversible", "F_po", loop.pull_off_force_reversible, "N", "[D19] (S1) with W_app");
    return list;
}

Quantity unmeasured_quantity(const Estimate& work) {
    auto result = quantity("work_of_adhesion_with_unmeasured_waves", "W_app", work, "J/m2");
    result.source = "[D19] (7), the spectrum continued at both ends";
    return result;
}

std::string adhesion_answer(const study::StudyResult& result) {
    return work_sentence(result) + unmeasured_sentence(result.pairs.front()) + loop_sentence(result);
}

}  // namespace setae::output
