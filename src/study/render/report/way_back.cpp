// SPDX-License-Identifier: GPL-3.0-or-later
#include "way_back.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "fold.hpp"
#include "markup.hpp"
#include "setae/core/words.hpp"
#include "setae/output/hysteresis_output.hpp"
#include "table.hpp"

namespace setae::report {
namespace {

using output::Json;

/// A quantity that some pairs lack.
Cell quantity_or_none(const Json& study, const std::string& pointer) {
    return entry(study, pointer).is_object() ? Cell(QuantityCell{pointer}) : Cell(TextCell{"–"});
}

DataTable pairs(const study::Hysteresis& h, const Json& study) {
    DataTable table{
        "pairs-way-back",
        "Pairs on the way back: predicted from roughness, and measured",
        "By the law named. Contact: share of the area in contact without load, as simulated patches have it; <i>W</i><sub>app</sub> is that contact's. <i>E</i><sub>loss</sub> is of a "
        "whole loop in the machine that loops state, else under fixed grips, to the preload of the study or the force that the measured contact area takes.",
        {{"surface", ""},
         {"elastomer", ""},
         {"law", ""},
         {"contact", "1"},
         {"*W*_app", "J/m2"},
         {"*W*_ret at pull-off", "J/m2"},
         {"measured *W*_ret at pull-off", "J/m2"},
         {"pull-off force", "N"},
         {"*E*_loss", "J"}},
        {}};
    for (std::size_t i = 0; i < h.pairs.size(); ++i) {
        const auto& pair = h.pairs[i];
        const auto base = fmt::format("/hysteresis/pairs/{}", i);
        const auto quantity = [&](const char* name) { return quantity_or_none(study, joined(base, name)); };
        table.rows.push_back({TextCell{pair.surface}, TextCell{pair.elastomer}, TextCell{pair.model.name()},
                              NumberCell{joined(base, "contact_fraction")}, quantity("work_of_adhesion_approach"),
                              quantity("work_of_adhesion_retraction"), quantity("measured"), quantity("pull_off_force"),
                              quantity("energy_loss")});
    }
    return table;
}

DataTable losses(const study::Hysteresis& h, const Json& study) {
    DataTable table{
        "losses-way-back",
        "Where the joules of measured loops went",
        "By the law of each pair, with <i>W</i><sub>app</sub> and contact area as measured. Works: the loop's own area is not known, <i>E</i><sub>loss</sub> follows from both works "
        "and the contact area.",
        {{"surface", ""},
         {"elastomer", ""},
         {"of", ""},
         {"*E*_loss", "J"},
         {"jump in", "J"},
         {"jump out", "J"},
         {"crack tip", "J"},
         {"roughness", "J"},
         {"bulk", "J"},
         {"unexplained", "J"}},
        {}};
    for (std::size_t i = 0; i < h.pairs.size(); ++i) {
        if (!h.pairs[i].decomposition) continue;
        const auto base = fmt::format("/hysteresis/pairs/{}/decomposition", i);
        const auto quantity = [&](const char* name) { return quantity_or_none(study, joined(base, name)); };
        table.rows.push_back({TextCell{h.pairs[i].surface}, TextCell{h.pairs[i].elastomer},
                              TextCell{h.pairs[i].decomposition->of_works ? "works" : "loop"}, quantity("energy_loss"),
                              quantity("energy_loss_shares/jump_in"), quantity("energy_loss_shares/jump_out"),
                              quantity("energy_loss_shares/crack_tip"), quantity("energy_loss_shares/roughness"),
                              quantity("energy_loss_shares/bulk"), quantity("unexplained")});
    }
    return table;
}

DataTable laws(const char* ranking, const char* title, const Json& study) {
    DataTable table{
        fmt::format("laws-{}", ranking),
        title,
        "Off: measured less law, rms; of all pairs, of surfaces and of elastomers that the fit has not seen. Weight: the law's share among all, by how well the other surfaces "
        "say each surface.",
        {{"law", ""},
         {"*W*_ret", ""},
         {"*W*_x", "J/m2"},
         {"*k*", "1"},
         {"off", "J/m2"},
         {"next surface", "J/m2"},
         {"next elastomer", "J/m2"},
         {"weight", "1"}},
        {}};
    const auto base = fmt::format("/hysteresis/rankings/{}/models", ranking);
    const auto& models = entry(study, base);
    for (std::size_t i = 0; i < models.size(); ++i) {
        const auto at = fmt::format("{}/{}", base, i);
        const auto quantity = [&](const char* name) { return quantity_or_none(study, joined(at, name)); };
        table.rows.push_back({TextCell{models[i].at("model").get<std::string>()},
                              TextCell{models[i].at("formula").get<std::string>()}, quantity("work_per_true_area"),
                              quantity("pinning_coefficient"), quantity("rms_residual"),
                              quantity("rms_residual_surface_left_out"), quantity("rms_residual_elastomer_left_out"),
                              NumberCell{joined(at, "weight")}});
    }
    return table;
}

DataTable joint(const study::JointLossFit& fit, const Json& study) {
    DataTable table{
        "joint-way-back",
        "What one fit of all loops makes of what they rest on",
        fmt::format(
            "<i>E</i><sub>loss</sub> of {} and <i>W</i><sub>ret</sub> of {} against what their laws say, every input within its ±: "
            "<i>χ</i>² {:.3g} of {}. The shares above are those after it.",
            setae::counted(static_cast<std::size_t>(fit.energies), "loop", "loops"),
            setae::counted(static_cast<std::size_t>(fit.works), "pair", "pairs"), fit.chi2, fit.energies + fit.works),
        {{"input", ""}, {"unit", ""}, {"before", ""}, {"after", ""}},
        {}};
    const std::string base = "/hysteresis/joint_fit/inputs";
    const auto& inputs = entry(study, base);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const auto at = fmt::format("{}/{}", base, i);
        table.rows.push_back({TextCell{fit.inputs[i].name}, TextCell{fit.inputs[i].unit},
                              QuantityCell{joined(at, "before")}, QuantityCell{joined(at, "after")}});
    }
    return table;
}

std::string contents_html(const study::Hysteresis& h, const Json& study) {
    std::string html;
    for (const auto& sentence : output::hysteresis_sentences(h)) html += "<p>" + prose(sentence) + "</p>";
    html += as_html(pairs(h, study), study) + as_html(losses(h, study), study);
    if (h.joint && !h.joint->inputs.empty()) html += as_html(joint(*h.joint, study), study);
    if (h.conforming_pairs < h.measured_pairs)
        html += as_html(laws("conforming_pairs", "Laws of pairs in full contact", study), study);
    html += as_html(laws("all_pairs", "Laws of all pairs", study), study);
    return h.by_area.best() ? html + as_html(laws("loop_areas", "Laws of loops, by what they lose", study), study)
                            : html;
}

}  // namespace

std::string way_back_html(const study::StudyResult& result, const Json& study, const std::string& figures) {
    if (!result.work_of_adhesion) return "";
    const auto& hysteresis = result.hysteresis;
    if (!hysteresis)
        return fmt::format("<p class=\"reason\">The way back is not predicted: {}.</p>", prose(hysteresis.reason));
    return as_html(Fold{.identifier = "way-back",
                        .kind = "family",
                        .title = "The way back: retraction, pull-off, energy lost",
                        .html = contents_html(*hysteresis, study) + figures});
}

}  // namespace setae::report
