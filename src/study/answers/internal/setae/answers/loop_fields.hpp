// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Outputs of `setae jkr fit` and `setae jkr energy` for loops.

#include <optional>
#include <string>
#include <vector>

#include "setae/answers/loops.hpp"
#include "setae/fields/describe.hpp"
#include "setae/loops/global_fit.hpp"
#include "setae/output/loop_model_fields.hpp"

namespace setae::answers {

/// A fit of several loops with parameters that they share; the loops are added later.
struct SharedLoops {
    const loops::GlobalFit* fit;
};

/// The energies of a loop.
struct LoopEnergies {
    const AnalysedLoop* loop;
};
/// Those of a later contact in the same record.
struct ContactEnergies {
    const loops::Outcome<loops::ContactAnalysis>* contact;
};
/// That of a cycle of unloading and loading.
struct CycleEnergy {
    const loops::CycleAnalysis* cycle;
};

}  // namespace setae::answers

namespace setae::fields {

template <>
struct Described<answers::FittedLoop> {
    using T = answers::FittedLoop;
    static constexpr std::array rows{
        fields_of<T>([](const T& of) -> const loops::LoopAnalysis& { return of.loop->analysis; }),
        made<T>("file", "name of the file as it was given",
                [](const T& of) -> const std::string& { return of.loop->file; }),
        field<&T::models>("models", "contact models that are fitted in addition to JKR"),
        inner<&T::loop>(),
    };
    static constexpr Description description{"fitted_loop", "fits to a loop", rows};
};
static_assert(complete<answers::FittedLoop>);

template <>
struct Described<answers::SharedLoops> {
    using T = answers::SharedLoops;
    static constexpr std::array rows{
        list_filled_later<answers::FittedLoop>("loops", "one entry per loop"),
        made<T>("shared", "fit with parameters that the loops share",
                [](const T& of) -> const loops::GlobalFit& { return *of.fit; }),
        inner<&T::fit>(),
    };
    static constexpr Description description{"", "fits to loops that share parameters", rows};
};
static_assert(complete<answers::SharedLoops>);

template <>
struct Described<answers::ContactEnergies> {
    using T = answers::ContactEnergies;
    static constexpr std::array rows{
        fields_of<T>(Described<loops::ContactAnalysis>::energies,
                     [](const T& of) -> const loops::Outcome<loops::ContactAnalysis>& { return *of.contact; }),
        made<T>("reason", "reason for which the contact was not analysed",
                [](const T& of) { return *of.contact ? std::nullopt : std::optional(of.contact->reason); }),
        inner<&T::contact>(),
    };
    static constexpr Description description{"", "energies of a later contact", rows};
};
static_assert(complete<answers::ContactEnergies>);

template <>
struct Described<answers::CycleEnergy> {
    using T = answers::CycleEnergy;
    static constexpr std::array rows{
        fields_of<T>(Described<loops::CycleAnalysis>::energies,
                     [](const T& of) -> const loops::CycleAnalysis& { return *of.cycle; }),
        inner<&T::cycle>(),
    };
    static constexpr Description description{"", "energy of one cycle of unloading and loading", rows};
};
static_assert(complete<answers::CycleEnergy>);

template <>
struct Described<answers::LoopEnergies> {
    using T = answers::LoopEnergies;
    template <class Entry, class Results>
    static std::vector<Entry> entries(const Results& results) {
        std::vector<Entry> list;
        for (const auto& result : results) list.push_back({&result});
        return list;
    }
    static constexpr std::array rows{
        fields_of<T>(Described<loops::ContactAnalysis>::energies,
                     [](const T& of) -> const loops::ContactAnalysis& { return of.loop->analysis; }),
        made<T>("further_contacts", "later contacts in the same record",
                [](const T& of) { return entries<answers::ContactEnergies>(of.loop->analysis.further_contacts); }),
        made<T>("cycles", "further loading and unloading within one contact",
                [](const T& of) { return entries<answers::CycleEnergy>(of.loop->analysis.cycles); }),
        made<T>("alerts", "warnings", [](const T& of) -> const auto& { return of.loop->analysis.alerts; }),
        made<T>("file", "name of the file as it was given",
                [](const T& of) -> const std::string& { return of.loop->file; }),
        inner<&T::loop>(),
    };
    static constexpr Description description{"", "energies of a loop", rows};
};
static_assert(complete<answers::LoopEnergies>);

}  // namespace setae::fields
