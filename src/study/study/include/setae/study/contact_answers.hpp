// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/study/study_result.hpp"

namespace setae::study {

/// A theory of what contact gains without load.
enum class ContactTheory {
    full_contact,    ///< full-contact balance (Eq. 7), floored at 0
    patches,         ///< simulated patches of the pair's U_el/(A W), adhesion::unloaded_contact()
    persson,         ///< Persson's theory of the spectrum with adhesion, persson::adhesive_contact_at_scales()
    simulated_cell,  ///< patches with the surface's own spectrum, `setae lab conform`
};

/// What a theory is called in JSON and for readers, and what it assumes.
struct TheoryText {
    const char *name, *title, *assumes;
};
[[nodiscard]] TheoryText text_of(ContactTheory theory);

/// What one theory gives for a pair.
struct ContactAnswer {
    ContactTheory theory = ContactTheory::patches;
    Estimate work_of_adhesion;  ///< W_app, what contact gains per area without load, >= 0 [J/m²]
    Estimate area_fraction;     ///< of the nominal area in contact, 0 to 1
    bool recommended = false;
};

/// The answer of the program for a pair, the same in every command: what simulated patches of the pair's U_el/(A W)
/// gain.
///
/// Up to U_el = 0.15 A W patches are in full contact, and the answer is the full-contact balance; beyond, it counts the
/// area in contact, where that balance counts all of it. The other theories agree in the first case and assume more in
/// the second: Persson's the branch of retraction, with all contact that can hold; a simulated cell one band of the
/// spectrum and a range of the attraction of some tenths of the height. pair: with a prediction. @throws InternalError
/// without.
[[nodiscard]] ContactAnswer recommended_answer(const PairResult& pair);

/// What theories give for a pair, side by side.
struct ContactAnswers {
    std::vector<ContactAnswer> answers;  ///< one of them recommended
    std::string reason;                  ///< why that one, in a sentence

    [[nodiscard]] const ContactAnswer& recommended() const;
};

/// Full contact and patches, which cost nothing. pair: with a prediction.
[[nodiscard]] ContactAnswers contact_answers(const PairResult& pair);

/// These and Persson's theory without load, W = W_int r − γ1 (r − 1) for its w.
/// Cost: 0.1 to 1 s.
[[nodiscard]] ContactAnswers contact_answers(const StudyResult& result, const PairResult& pair);

}  // namespace setae::study
