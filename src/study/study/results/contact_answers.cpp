// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/contact_answers.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/rectified.hpp"
#include "setae/persson/adhesive.hpp"

namespace setae::study {
namespace {

constexpr double full_contact_share = 0.15;  ///< of U_el/(A W): patches close to the last point up to it

void require_prediction(const PairResult& pair) {
    if (!pair.modified || !pair.partial_contact)
        throw InternalError(pair.surface + " × " + pair.elastomer + ": no theory was evaluated for this pair");
}

/// W_int r − γ1 (r − 1): energy gained in full contact, without the stored energy [J/m²].
double full_contact_gain(const PairResult& pair) { return pair.modified->work.raw + pair.stored_energy.value; }

double energy_share(const PairResult& pair) {
    const double gain = full_contact_gain(pair);
    return gain > 0.0 ? pair.stored_energy.value / gain : INFINITY;
}

ContactAnswer full_contact(const PairResult& pair) {
    return {ContactTheory::full_contact, pair.modified->estimate, {.value = 1.0}, false};
}

std::optional<ContactAnswer> by_persson(const StudyResult& result, const PairResult& pair) {
    const double gain = full_contact_gain(pair);
    if (!(gain > 0.0)) return {};
    const auto scales = persson::scales_of(result.surface(pair.surface).used().curve,
                                           {.contact_modulus = result.elastomer(pair.elastomer).contact_modulus.value});
    const auto contact = persson::adhesive_contact_at_scales(0.0, gain, scales);
    if (!contact.converged) return {};
    const Index last = scales.wavevector.size() - 1;
    return ContactAnswer{
        ContactTheory::persson, {.value = contact.effective_work[0]}, {.value = contact.area_fraction[last]}, false};
}

std::string reason_for(const PairResult& pair) {
    const double e = energy_share(pair), area = 100.0 * pair.contact.area_fraction;
    if (!std::isfinite(e))
        return "stretching the soft side costs more energy than full contact gains, so that no contact forms";
    if (e <= full_contact_share)
        return fmt::format(
            "roughness stores {:.2g} of what full contact gains: the contact closes spontaneously, and the "
            "full-contact balance (Eq. 7) gives the same",
            e);
    return fmt::format(
        "roughness stores {:.2g} of what full contact gains: without load {:.3g} % of the area is in contact; "
        "the full-contact balance (Eq. 7) counts all of it",
        e, area);
}

}  // namespace

TheoryText text_of(ContactTheory theory) {
    switch (theory) {
        case ContactTheory::full_contact:
            return {"full_contact", "full-contact balance (Eq. 7)", "the bodies touch everywhere"};
        case ContactTheory::patches:
            return {"patches", "simulated patches",
                    "self-affine roughness (H = 0.8) with the pair's stored energy, approach from far, no load"};
        case ContactTheory::persson:
            return {"persson", "Persson's theory",
                    "Gaussian roughness with the surface's spectrum, no load, attraction without range, the branch of "
                    "retraction"};
        case ContactTheory::simulated_cell:
            return {"simulated_cell", "simulated cell",
                    "the band of the surface's spectrum that stores most energy, attraction with a range of tenths "
                    "of the height"};
    }
    throw InternalError("a theory of contact without a name");
}

ContactAnswer recommended_answer(const PairResult& pair) {
    require_prediction(pair);
    return {
        ContactTheory::patches,
        rectified(pair.partial_contact->estimate()),
        {.value = pair.contact.area_fraction, .standard_error = pair.contact.area_error, .method = "simulated patches"},
        true};
}

const ContactAnswer& ContactAnswers::recommended() const {
    return *std::ranges::find(answers, true, &ContactAnswer::recommended);
}

ContactAnswers contact_answers(const PairResult& pair) {
    return {.answers = {recommended_answer(pair), full_contact(pair)}, .reason = reason_for(pair)};
}

ContactAnswers contact_answers(const StudyResult& result, const PairResult& pair) {
    auto found = contact_answers(pair);
    if (auto answer = by_persson(result, pair)) found.answers.push_back(std::move(*answer));
    return found;
}

}  // namespace setae::study
