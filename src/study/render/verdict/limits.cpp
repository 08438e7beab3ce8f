// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "answer.hpp"
#include "bearings.hpp"
#include "setae/core/uncertain_text.hpp"
#include "setae/core/units.hpp"
#include "setae/core/words.hpp"
#include "setae/output/verdict.hpp"
#include "setae/study/exact_inputs.hpp"

namespace setae::output {
namespace {

using study::StudyResult;

const auto fine = [](const auto& item) { return !item.failed(); };

/// The pair farthest from its prediction.
const adhesion::PredictionResidual& worst_of(const adhesion::PredictionTest& test) {
    return *std::max_element(test.pairs.begin(), test.pairs.end(), [](const auto& a, const auto& b) {
        return std::abs(a.standardised()) < std::abs(b.standardised());
    });
}

/// Whether the farthest of so many normal deviations is seldom so far out.
bool stands_out(double standardised, int n) {
    return n * std::erfc(std::abs(standardised) / std::sqrt(2.0)) < improbable;
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
        say_of_test();
        say_of_rivals();
        say_of_fits();
        say_of_retraction();
        say_of_design();
        say_of_spectra();
        say_of_alerts();
        say_of_exact_inputs();
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

    void say_of_test() {
        if (!result_.prediction_test) return;
        const auto& test = *result_.prediction_test;
        const auto& worst = worst_of(test);
        const auto name = worst.elastomer + " on " + worst.surface;
        if (test.probability < improbable)
            say(fmt::format(
                "(7) is contradicted by its {} ({}): {} is {:+.1f} standard errors from its prediction, and the "
                "errors of predictions share a spectrum and a modulus, so that one cause can move several.",
                test.n == 1 ? "pair" : "pairs", test_text(test), name, worst.standardised()));
        else if (stands_out(worst.standardised(), test.n))
            say(fmt::format(
                "{} is {:+.1f} standard errors from its prediction, though the pairs together have p = {}. {}", name,
                worst.standardised(), probability_text(test.probability), deviation_note(test)));
        if (test.probability < improbable && test.extra_scatter > 0.0)
            say(fmt::format(
                "A prediction by (7) for another pair is uncertain by {} beyond its own ±: the scatter that "
                "the pairs have.",
                format_value(test.extra_scatter, "J/m2", 2)));
        if (!test.left_out.empty()) say("Not tested: " + listed(test.left_out) + ".");
    }

    void say_of_rivals() {
        const auto rivals = rivals_of(result_);
        if (!rivals.alike.empty())
            say(fmt::format("The pairs do not tell (7) from {}: their likelihoods are alike.", listed(rivals.alike)));
        if (!rivals.better.empty()) say(fmt::format("The pairs speak for {} and against (7).", listed(rivals.better)));
    }

    void say_of_fits() {
        if (const auto apart = loss_less_approach(result_); apart && interval_of(*apart) && !may_be_zero(*apart))
            say(fmt::format(
                "Loss and approach give different W_int, {} apart: (10) or (7) leaves out what the other has.",
                format_uncertain(*apart, "J/m2")));
        if (const auto apart = loss_less_approach(result_);
            apart && may_be_zero(*apart) && !could_have_refused(*apart, result_))
            say(fmt::format(
                "Whether loss goes with true area, (10), is not tested: a W_int of loss half as large or twice "
                "that of approach would agree with these {} as well.",
                pairs_text(result_.loop->through_origin.n)));
        if (result_.pairs.empty()) return;
        if (!result_.modified && result_.work_of_adhesion) say("No fit of approach: " + result_.modified.reason + ".");
        if (!result_.loop) say("No fit of loop energies: " + result_.loop.reason + ".");
        if (!result_.work_of_adhesion) say("No prediction: " + result_.work_of_adhesion.reason + ".");
    }

    void say_of_retraction() {
        int unknown = 0;
        std::vector<std::string> changing;
        for (const auto& pair : result_.pairs) {
            const auto& along = pair.work_along_retraction;
            if (!along) unknown += pair.retraction || pair.pull_off ? 1 : 0;
            else if (interval_of(along->slope) && !may_be_zero(along->slope))
                changing.push_back(fmt::format("{} × {} ({} at the largest contact, {} at pull-off)", pair.surface,
                                               pair.elastomer, format_uncertain(along->at_largest_contact, "J/m2"),
                                               format_uncertain(along->at_pull_off, "J/m2")));
        }
        if (unknown > 0)
            say(
                fmt::format("Whether W_ret is the same during the whole retraction is undetermined for {}: only the "
                            "pull-off is known.",
                            pairs_text(unknown)));
        if (!changing.empty())
            say("W_ret changes along the retraction of " + listed(changing) +
                ": its value at pull-off is not the work of the whole retraction.");
    }

    void say_of_exact_inputs() {
        std::vector<std::string> kinds;
        for (const auto& [what, names] : study::exact_inputs(result_))
            kinds.push_back(names.empty() ? what : fmt::format("{} ({})", what, fmt::join(names, ", ")));
        if (!kinds.empty() && result_.work_of_adhesion)
            say(fmt::format("Taken for exact, as the study gives no ±: {}.", listed(kinds)));
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

    /// Alerts that bear on what can be concluded, each matter in a sentence with whom it concerns.
    void say_of_alerts() {
        const auto groups = grouped_alerts(result_);
        const Subjects concerned(result_);
        for (const auto& bearing : bearings()) {
            std::vector<Subject> subjects;
            for (const auto& group : groups)
                if (std::find(bearing.codes.begin(), bearing.codes.end(), group.code) != bearing.codes.end())
                    for (const auto& alert : group.alerts) subjects.push_back(concerned.of(alert));
            if (!subjects.empty()) say(fmt::format(fmt::runtime(bearing.sentence), listed(names_of(subjects))));
        }
    }

    const StudyResult& result_;
    Tested tested_;
    std::vector<std::string> sentences_;
};

}  // namespace

std::vector<std::string> limits_of(const StudyResult& result) { return Limits(result).take(); }

Verdict verdict(const StudyResult& result) { return {answer_of(result), findings_of(result), limits_of(result)}; }

std::string deviation_note(const adhesion::PredictionTest& test) {
    return test.work_fitted
               ? "A deviation counts the errors of its pair alone, at the W_int stated. The test of all pairs counts what "
                 "they share: one spectrum, modulus or surface energy that is off moves several pairs together, and W_int "
                 "may move to where it suits them all best. One pair far off and a large p can stand side by side."
               : "A deviation counts the errors of its pair alone. The test of all pairs counts what they share: one "
                 "spectrum, modulus, surface energy or W_int that is off moves several pairs together and counts once.";
}

}  // namespace setae::output
