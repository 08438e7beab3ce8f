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
        "Pairs on retraction: predicted from roughness and measured",
        "The column model names the retraction model of each row. Contact is the share of the area in contact without load, from simulated patches; <i>W</i><sub>app</sub> belongs to this "
        "contact. <i>E</i><sub>loss</sub> is the energy loss of a whole loop up to the preload of the study, or up to the force that gives the measured contact area. The testing machine is "
        "the one stated for the loops; otherwise fixed grips are assumed.",
        {{"surface", ""},
         {"elastomer", ""},
         {"model", ""},
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
        "Energy budget of measured loops",
        "The shares follow from the retraction model of each pair, with measured <i>W</i><sub>app</sub> and contact area. In rows from works, the loop energy was not measured: "
        "<i>E</i><sub>loss</sub> follows from <i>W</i><sub>app</sub>, <i>W</i><sub>ret</sub> and the contact area.",
        {{"surface", ""},
         {"elastomer", ""},
         {"from", ""},
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
        "Residual: rms of measured minus model, for all pairs, for surfaces left out and for elastomers left out of the fit. Weight: the share of the model among all models, from "
        "leave-one-surface-out predictions.",
        {{"model", ""},
         {"*W*_ret", ""},
         {"*W*_x", "J/m2"},
         {"*k*", "1"},
         {"residual", "J/m2"},
         {"surface left out", "J/m2"},
         {"elastomer left out", "J/m2"},
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
        "Inputs before and after the joint fit of all loops",
        fmt::format(
            "The joint fit compares <i>E</i><sub>loss</sub> of {} and <i>W</i><sub>ret</sub> of {} with their models, every input free within its ±: "
            "<i>χ</i>² = {:.3g} for {} values. The shares of the energy budget use the inputs after the fit.",
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
        html += as_html(laws("conforming_pairs", "Retraction models of pairs in full contact", study), study);
    html += as_html(laws("all_pairs", "Retraction models of all pairs", study), study);
    return h.by_area.best()
               ? html + as_html(laws("loop_areas", "Retraction models from the energy loss of loops", study), study)
               : html;
}

}  // namespace

std::string retraction_html(const study::StudyResult& result, const Json& study, const std::string& figures) {
    if (!result.work_of_adhesion) return "";
    const auto& hysteresis = result.hysteresis;
    if (!hysteresis)
        return fmt::format("<p class=\"reason\">Retraction is not predicted: {}.</p>", prose(hysteresis.reason));
    return as_html(Fold{.identifier = "way-back",
                        .kind = "family",
                        .title = "Retraction: pull-off and energy loss",
                        .html = contents_html(*hysteresis, study) + figures});
}

}  // namespace setae::report
