// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/fields/describe.hpp"
#include "setae/study/contact_answers.hpp"

/// Contact without load by each theory, as JSON has it.
namespace setae::fields {

template <>
struct Described<study::ContactAnswer> {
    using T = study::ContactAnswer;
    static constexpr std::array rows{
        made<T>("theory", "`full_contact`, `patches`, `persson` or `simulated_cell`",
                [](const T& of) { return study::text_of(of.theory).name; }),
        made<T>("title", "name of the theory", [](const T& of) { return study::text_of(of.theory).title; }),
        made<T>("assumes", "assumptions of the theory", [](const T& of) { return study::text_of(of.theory).assumes; }),
        field<&T::recommended>("recommended", "whether this theory is the answer of all commands"),
        quantity<&T::work_of_adhesion>("work_of_adhesion", "W_app", "J/m2",
                                       "energy gained per nominal area on approach without load, 0 or more")
            .as("apparent_work_of_adhesion"),
        quantity<&T::area_fraction>("area_fraction", "A/A0", "1", "area in contact over nominal area"),
        inner<&T::theory>(),
    };
    static constexpr Description description{"", "contact without load by one theory", rows};
};
static_assert(complete<study::ContactAnswer>);

template <>
struct Described<study::ContactAnswers> {
    using T = study::ContactAnswers;
    static constexpr std::array rows{
        made<T>("recommended", "the theory whose numbers are the answer of all commands",
                [](const T& of) { return study::text_of(of.recommended().theory).name; }),
        field<&T::reason>("reason", "the reason for this theory, in a sentence"),
        field<&T::answers>("theories", "one entry per theory"),
    };
    static constexpr Description description{
        "contact_answers", "work of adhesion of contact without load by each theory, one of them recommended", rows};
};
static_assert(complete<study::ContactAnswers>);

}  // namespace setae::fields
