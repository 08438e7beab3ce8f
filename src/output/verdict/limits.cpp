// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "answer.hpp"
#include "setae/core/uncertain_text.hpp"
#include "setae/core/words.hpp"
#include "setae/output/verdict.hpp"

namespace setae::output {
namespace {

using study::StudyResult;

const auto fine = [](const auto& item) { return !item.failed(); };

/// Surfaces and elastomers of the pairs that have a measured work of adhesion and a prediction.
struct Tested {
    std::set<std::string> surfaces, elastomers;
    std::size_t pairs = 0;
};

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

class Limits {
public:
    explicit Limits(const StudyResult& result) : result_(result), tested_(tested(result)) {}

    std::vector<std::string> take() {
        if (result_.surfaces.empty() && result_.experiments.empty() && result_.study.published.empty()) {
            say("Empty study: it names no surface and no experiment, so nothing can be concluded, neither about roughness nor about adhesion.");
            return std::move(sentences_);
        }
        say_of_failures();
        say_of_fits();
        say_of_design();
        say_of_spectra();
        say_of_alerts();
        return std::move(sentences_);
    }

private:
    void say(std::string sentence) { sentences_.push_back(std::move(sentence)); }

    void say_of_failures() {
        for (const auto& surface : result_.surfaces)
            if (!surface.likelihood_error.empty())
                say(fmt::format("The numbers of {} are averages over its measurements: {}.", surface.name,
                                surface.likelihood_error));
        if (result_.failures() > 0)
            say(fmt::format("{} of the study failed and {} in no number here.",
                            counted(static_cast<std::size_t>(result_.failures()), "part", "parts"),
                            result_.failures() == 1 ? "is" : "are"));
    }

    void say_of_fits() {
        if (result_.prediction_test && result_.prediction_test->probability < 0.05) {
            const auto& pairs = result_.prediction_test->pairs;
            const auto worst = std::max_element(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) {
                return std::abs(a.standardised()) < std::abs(b.standardised());
            });
            say(fmt::format(
                "(7) is contradicted by its pairs: {} on {} is {:+.1f} standard errors from its prediction, and the "
                "errors of predictions share a spectrum and a modulus, so that one cause can move several.",
                worst->elastomer, worst->surface, worst->standardised()));
        }
        if (result_.pairs.empty()) return;
        if (!result_.modified && result_.work_of_adhesion) say("No fit of approach: " + result_.modified.reason + ".");
        if (!result_.loop) say("No fit of loop energies: " + result_.loop.reason + ".");
        if (!result_.work_of_adhesion) say("No prediction: " + result_.work_of_adhesion.reason + ".");
    }

    void say_of_design() {
        const auto surfaces = std::count_if(result_.surfaces.begin(), result_.surfaces.end(), fine);
        const auto experiments = std::count_if(result_.experiments.begin(), result_.experiments.end(), fine);
        if (result_.surfaces.empty())
            say("No surface: nothing is known of roughness, so no work of adhesion is predicted and none of the measured ones is compared with a prediction.");
        else if (surfaces == 0) say("No surface could be analysed: nothing is predicted.");
        if (tested_.pairs == 0 && surfaces > 0) {
            const std::string none = result_.experiments.empty() ? "No experiment"
                                     : experiments == 0          ? "No experiment could be analysed"
                                                                 : "No experiment on a rough surface";
            say(none + (result_.study.work_of_adhesion
                            ? fmt::format(": W_app is predicted with the given W_int of {}; nothing measured tests it.",
                                          format_uncertain(*result_.study.work_of_adhesion, "J/m2"))
                            : std::string(": roughness is known, but W_app is predicted only with a given W_int "
                                          "(work_of_adhesion in the study), and this study gives none.")));
        }
        if (tested_.pairs == 1)
            say("One pair: a single measured work of adhesion can always be matched by some W_int, so it neither supports nor contradicts the balance between adhesion and roughness.");
        else if (tested_.pairs > 1 && tested_.surfaces.size() == 1)
            say(fmt::format(
                "One surface: W_int rests on {} pairs of one surface, {}; the balance is not tested against roughness.",
                tested_.pairs, *tested_.surfaces.begin()));
        if (tested_.pairs > 1 && tested_.elastomers.size() == 1)
            say(fmt::format(
                "One elastomer: every pair is on {}; that the stored energy grows with the modulus is not tested.",
                *tested_.elastomers.begin()));
        if (result_.experiments.size() == 1)
            say("One experiment: there is no scatter between loops to tell how far a repetition would differ.");
    }

    /// Names of the surfaces that something holds for.
    template <class Holds>
    [[nodiscard]] std::vector<std::string> surfaces_where(Holds holds) const {
        std::vector<std::string> names;
        for (const auto& surface : result_.surfaces)
            if (!surface.failed() && holds(surface)) names.push_back(surface.name);
        return names;
    }

    void say_of_spectra() {
        if (const auto names = surfaces_where([](const auto& s) { return s.reconstructed; }); !names.empty())
            say("The spectra of " + listed(names) +
                " are self-affine reconstructions of published moments, not measurements; what rests on their shape (stored energy, scales) is the model's.");
        const auto measured_once = [](const auto& s) {
            return std::count_if(s.measurements.begin(), s.measurements.end(), fine) == 1;
        };
        if (const auto names = surfaces_where(measured_once); !names.empty())
            say("Of " + listed(names) + " there is one measurement; what differs from place to place is not known.");
        std::vector<std::string> nonconforming;
        for (const auto& pair : result_.pairs)
            if (pair.modified && !pair.modified->work.conforms)
                nonconforming.push_back(pair.surface + " × " + pair.elastomer);
        if (!nonconforming.empty())
            say("Balance (7) says that " + listed(nonconforming) +
                " will not conform; it holds for conforming contact only, and 0 stands for them.");
    }

    /// Alerts that bear on what can be concluded, each kind in a sentence with whom it concerns.
    void say_of_alerts() {
        struct Bearing {
            const char *code, *sentence;  ///< {} stands for names
        };
        constexpr Bearing bearings[] = {
            {"INSTRUMENTS_DISAGREE",
             "Instruments disagree on {} beyond chance: its spectrum is a compromise between them."},
            {"NO_INSTRUMENT", "Of {} no instrument is stated: waves that it may have blurred count as seen."},
            {"NO_TIP_RADIUS", "Of {} no tip radius is stated: waves that a tip may have hidden count as seen."},
            {"SAME_MEASUREMENT", "{} lists the same data more than once: its intervals are too narrow."},
            {"WAVES_BEYOND_DATA",
             "Of {} waves shorter than the finest data are in no number; slope, true area and stored energy are lower bounds."},
            {"BAND_LIMITED",
             "Of {} waves longer than the longest measured are in no number; h_rms and stored energy are lower bounds."},
            {"ONE_PLACE", "{} was measured in one place: whether others are like it is not known."},
            {"MEASUREMENTS_SCATTER", "Places of {} differ beyond their waves: few places may not stand for the whole."},
            {"HEIGHT_UNKNOWN",
             "The height of the soft body of {} is not given: its modulus counts as that of a half-space and is too high for a lens."},
            {"SINGLE_INSTRUMENT_DECADE",
             "Some decades of {} are seen by one instrument alone: nothing checks them there."},
            {"MEASURED_SLOPES", "Slopes of {} are not Gaussian: true areas are taken from the measured ones."},
        };
        const auto groups = grouped_alerts(result_);
        for (const auto& [code, sentence] : bearings) {
            const auto group =
                std::find_if(groups.begin(), groups.end(), [&, c = code](const auto& g) { return g.code == c; });
            if (group == groups.end()) continue;
            std::vector<std::string> names;
            for (const auto& alert : group->alerts)
                if (auto name = whom(alert); std::find(names.begin(), names.end(), name) == names.end())
                    names.push_back(std::move(name));
            say(fmt::format(fmt::runtime(sentence), listed(names)));
        }
    }

    /// The surface an alert belongs to where one is named, else its subject's last part.
    [[nodiscard]] std::string whom(const Alert& alert) const {
        for (const auto& surface : result_.surfaces) {
            const auto has = [&alert](const auto& alerts) {
                return std::find(alerts.begin(), alerts.end(), alert) != alerts.end();
            };
            if (has(surface.alerts)) return surface.name;
            for (const auto& m : surface.measurements)
                if (has(m.alerts)) return m.name.empty() ? surface.name : m.name;
        }
        return alert.subject.substr(alert.subject.find_last_of('/') + 1);
    }

    const StudyResult& result_;
    Tested tested_;
    std::vector<std::string> sentences_;
};

}  // namespace

std::vector<std::string> limits_of(const StudyResult& result) { return Limits(result).take(); }

Verdict verdict(const StudyResult& result) { return {answer_of(result), limits_of(result)}; }

}  // namespace setae::output
