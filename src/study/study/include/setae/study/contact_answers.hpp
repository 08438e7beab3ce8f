// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/study/study_result.hpp"

namespace setae::study {

/// A theory of the energy gained in contact without load.
enum class ContactTheory {
    full_contact,    ///< full-contact balance (Eq. 7), floored at 0
    patches,         ///< simulated patches of the pair's U_el/(A W), adhesion::unloaded_contact()
    persson,         ///< Persson's theory of the spectrum with adhesion, persson::adhesive_contact_at_scales()
    simulated_cell,  ///< patches with the spectrum of the surface, `setae lab conform`
};

/// Names of a theory in JSON and for readers, and its assumptions.
struct TheoryText {
    const char *name, *title, *assumes;
};
[[nodiscard]] TheoryText text_of(ContactTheory theory);

/// Result of one theory for a pair.
struct ContactAnswer {
    ContactTheory theory = ContactTheory::patches;
    Estimate work_of_adhesion;  ///< W_app, energy gained per area without load, >= 0 [J/m²]
    Estimate area_fraction;     ///< share of the nominal area in contact, 0 to 1
    bool recommended = false;
};

/// The recommended result for a pair, equal in all commands: the gain of simulated patches with the pair's U_el/(A W).
///
/// Up to U_el = 0.15 A W patches are in full contact, and the result is the full-contact balance; above, it includes
/// only the area in contact, whereas that balance includes all of it. The other theories agree in the first case and
/// assume more in the second: Persson's theory the branch of retraction, with all stable contact; a simulated cell one
/// band of the spectrum and a range of the attraction of some tenths of the height. pair: with a prediction. @throws
/// InternalError without.
[[nodiscard]] ContactAnswer recommended_answer(const PairResult& pair);

/// Results of several theories for a pair.
struct ContactAnswers {
    std::vector<ContactAnswer> answers;  ///< one of them is recommended
    std::string reason;                  ///< reason of the recommendation, in one sentence

    [[nodiscard]] const ContactAnswer& recommended() const;
};

/// Full contact and patches, at negligible cost. pair: with a prediction.
[[nodiscard]] ContactAnswers contact_answers(const PairResult& pair);

/// These results and that of Persson's theory without load, W = W_int r − γ1 (r − 1) for its w.
/// Cost: 0.1 to 1 s.
[[nodiscard]] ContactAnswers contact_answers(const StudyResult& result, const PairResult& pair);

}  // namespace setae::study
