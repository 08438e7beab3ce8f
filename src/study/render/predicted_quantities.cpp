// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/output/predicted_quantities.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/uncertain_text.hpp"
#include "setae/core/units.hpp"
#include "setae/output/json.hpp"
#include "setae/study/contact_answers.hpp"

namespace setae::output {
namespace {

/// Unmeasured waves are worth a sentence where they move W_app by more than this share.
constexpr double noted_share = 0.01;

std::string band_text(const Band& band) {
    return fmt::format("waves from {} to {}", format_value(2.0 * pi / band.lower, "m"),
                       format_value(2.0 * pi / band.upper, "m"));
}

/// The recommended answer, and how the roughness closes.
std::string work_sentence(const study::StudyResult& result) {
    const auto& pair = result.pairs.front();
    const auto answer = study::recommended_answer(pair);
    return fmt::format("W_app {} on approach without load, {:.3g} % of the area in contact ({}), of {}: {}\n",
                       format_interval(answer.work_of_adhesion, "J/m2"), 100.0 * answer.area_fraction.value,
                       study::text_of(answer.theory).title, band_text(result.surfaces.front().used().curve.band),
                       adhesion::name(pair.closing()));
}

std::string unmeasured_sentence(const study::PairResult& pair) {
    if (!pair.with_unmeasured_waves) return {};
    const auto& all = *pair.with_unmeasured_waves;
    const double measured = pair.modified->work.raw;
    const double change = std::max(std::abs(all.interval->lower - measured), std::abs(all.interval->upper - measured));
    if (change <= noted_share * std::abs(measured)) return {};
    return fmt::format(
        "  full-contact balance (Eq. 7) with the waves that were not measured, if the spectrum goes on as it ends: {}\n",
        format_interval(all, "J/m2"));
}

std::string loop_sentence(const study::StudyResult& result) {
    const auto& pair = result.pairs.front();
    if (!pair.loop) return {};
    const auto& loop = *pair.loop;
    return fmt::format(
        "pressed with {}: contact radius {}, pull-off at {} or more, loss {} or more (JKR with this W_app)\n",
        format_value(*result.elastomers.front().input.preload, "N"), format_uncertain(loop.contact_radius, "m"),
        format_uncertain(loop.reversible.pull_off_force, "N"),
        format_uncertain(loop.reversible.energy_loss.estimate(), "J"));
}

}  // namespace

std::vector<Quantity> loop_quantities(const adhesion::PredictedLoop& loop) {
    std::vector<Quantity> list;
    const auto add = [&](const char* name, const char* symbol, const Estimate& value, const char* unit,
                         const char* source) {
        list.push_back(quantity(name, symbol, value, unit));
        list.back().source = source;
    };
    add("contact_radius", "a_max", loop.contact_radius, "m", "[D19], Eq. 1 with W_app");
    const auto& [loss, work, force, smooth] = loop.reversible;
    add("energy_loss", "E_loss", loss.estimate(), "J", "jumps of JKR under fixed grips with W_app: a lower bound");
    add("work_of_adhesion_retraction", "W_ret", work, "J/m2", "W_app: reversible, a lower bound");
    add("pull_off_force", "F_po", force, "N", "[D19], Eq. S1 with W_app: a lower bound");
    add("smooth_sphere_pull_off_force", "F_po", {.value = smooth}, "N", "[D19], Eq. S1 with W_int: JKR");
    const char* no_limit = "[D19], Eq. 10; for comparison, no smooth limit";
    const auto& other = loop.conformal_loss;
    add("conformal_energy_loss", "E_loss", other.energy_loss.estimate(), "J", no_limit);
    add("conformal_work_of_adhesion_retraction", "W_ret", other.work_retraction, "J/m2", no_limit);
    add("conformal_pull_off_force", "F_po", other.pull_off_force, "N", no_limit);
    add("conformal_smooth_sphere_pull_off_force", "F_po", {.value = other.smooth_pull_off_force}, "N",
        "[D19], Eq. 10 of a smooth sphere, where JKR has smooth_sphere_pull_off_force");
    return list;
}

Quantity unmeasured_quantity(const Estimate& work) {
    auto result = quantity("work_of_adhesion_with_unmeasured_waves", "W_app", work, "J/m2");
    result.source = "[D19], Eq. 7, with the spectrum continued at both ends";
    return result;
}

std::string adhesion_answer(const study::StudyResult& result) {
    return work_sentence(result) + unmeasured_sentence(result.pairs.front()) + loop_sentence(result);
}

}  // namespace setae::output
