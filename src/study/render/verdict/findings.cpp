// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "answer.hpp"
#include "setae/core/units.hpp"
#include "setae/core/words.hpp"
#include "setae/spectral_fit/likelihood_spectrum.hpp"

namespace setae::output {
namespace {

using study::StudyResult;

/// The full-contact balance over enough pairs to test it.
std::string finding_of_test(const StudyResult& result) {
    const auto over = tested(result);
    if (!result.prediction_test || result.prediction_test->probability < improbable) return "";
    if (over.surfaces.size() < 2 || over.elastomers.size() < 2) return "";
    return fmt::format(
        "The full-contact balance (Eq. 7) with one W_int fits {} of {} surfaces and {} elastomers within the errors ({}).",
        pairs_text(result.prediction_test->n), over.surfaces.size(), over.elastomers.size(),
        test_text(*result.prediction_test));
}

std::string finding_of_rivals(const StudyResult& result) {
    const auto rivals = rivals_of(result);
    if (rivals.worse.empty()) return "";
    return fmt::format("The pairs support the full-contact balance (Eq. 7) more than {}.", listed(rivals.worse));
}

std::string finding_of_loss(const StudyResult& result) {
    const auto apart = loss_minus_approach(result);
    if (!apart || !may_be_zero(*apart) || !could_have_refused(*apart, result)) return "";
    return "The energy loss of loops is proportional to the true area (Eq. 10), with the W_int of approach.";
}

/// Whether some decade was measured by two instruments, and none of them deviates from the fitted spectrum anywhere.
bool instruments_agree(const std::vector<spectral_fit::Agreement>& rows) {
    const bool overlap = std::any_of(rows.begin(), rows.end(), [&](const auto& row) {
        return std::any_of(rows.begin(), rows.end(), [&](const auto& other) {
            return other.decade == row.decade && other.instrument != row.instrument;
        });
    });
    return overlap && std::all_of(rows.begin(), rows.end(), [](const auto& row) {
               return row.probability >= spectral_fit::improbable_agreement;
           });
}

std::string finding_of_instruments(const StudyResult& result) {
    std::vector<std::string> names;
    for (const auto& surface : result.surfaces)
        if (!surface.failed() && surface.fitted && instruments_agree(surface.fitted->agreement))
            names.push_back(surface.name);
    return names.empty() ? "" : fmt::format("Instruments agree on {} where their bands overlap.", listed(names));
}

std::string finding_of_references(const StudyResult& result) {
    std::vector<std::string> names;
    for (const auto& reference : result.references)
        if (reference.hysteresis.verdict == statistics::Verdict::equivalent &&
            std::find(names.begin(), names.end(), reference.elastomer) == names.end())
            names.push_back(reference.elastomer);
    if (names.empty()) return "";
    return fmt::format(
        "Smooth references on {} have the same W on both branches to within {}. Larger hysteresis on rough surfaces is "
        "due to roughness.",
        listed(names), format_value(result.study.comparison.margin, "J/m2", 2));
}

}  // namespace

Tested tested(const StudyResult& result) {
    Tested found;
    for (const auto& pair : result.pairs) {
        if (!pair.approach || result.surface(pair.surface).failed()) continue;
        ++found.pairs;
        found.surfaces.insert(pair.surface);
        found.elastomers.insert(pair.elastomer);
    }
    return found;
}

Rivals rivals_of(const StudyResult& result) {
    // twice a difference of ln L has the χ² distribution with one degree of freedom: 2 is compatible with chance
    constexpr double telling_difference = 2.0;
    const auto as_taken = [&](const char* balance) {
        return std::find_if(result.balances.begin(), result.balances.end(), [&](const auto& compared) {
            return compared.balance == balance && compared.shortest_wavelength == 0.0 &&
                   compared.surface_energy_factor == 1.0;
        });
    };
    Rivals rivals;
    const auto own = as_taken("modified");
    if (own == result.balances.end()) return rivals;
    for (const auto& [balance, name] : {std::pair{"without_area_change", "the small-slope balance (Eq. 2)"},
                                        {"persson_tosatti", "the Persson–Tosatti balance (Eq. S13)"},
                                        {"partial_contact", "the full-contact balance with partial contact"}}) {
        const auto other = as_taken(balance);
        if (other == result.balances.end()) continue;
        const double behind = own->score.log_likelihood - other->score.log_likelihood;
        (behind > telling_difference    ? rivals.worse
         : behind < -telling_difference ? rivals.better
                                        : rivals.alike)
            .emplace_back(name);
    }
    return rivals;
}

std::vector<std::string> findings_of(const StudyResult& result) {
    std::vector<std::string> sentences;
    for (const auto& find :
         std::array{finding_of_test, finding_of_rivals, finding_of_loss, finding_of_instruments, finding_of_references})
        if (auto sentence = find(result); !sentence.empty()) sentences.push_back(std::move(sentence));
    return sentences;
}

}  // namespace setae::output
