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

    std::vector<Limit> take() {
        if (result_.surfaces.empty() && result_.experiments.empty() && result_.study.published.empty()) {
            add_limit(
                "The study names no surface and no experiment. Nothing can be concluded about roughness or adhesion.");
            return std::move(limits_);
        }
        add_failures();
        add_test();
        add_rivals();
        add_fits();
        add_retraction();
        add_design();
        add_spectra();
        add_warnings();
        add_exact_inputs();
        return std::move(limits_);
    }

private:
    void add_limit(std::string sentence, std::string note = "") {
        limits_.push_back({std::move(sentence), std::move(note), true});
    }
    /// A limit that the answer also states, or a note on a missing number.
    void add_reservation(std::string sentence) { limits_.push_back({std::move(sentence), "", false}); }

    void add_failures() {
        for (const auto& surface : result_.surfaces)
            if (!surface.likelihood_error.empty())
                add_limit(
                    fmt::format("The numbers of {} come from the average over its measurements, because the likelihood "
                                "fit failed: {}.",
                                surface.name, surface.likelihood_error));
        if (result_.failures() > 0)
            add_limit(fmt::format("{} of the study failed and {} not contribute to any number.",
                                  counted(static_cast<std::size_t>(result_.failures()), "part", "parts"),
                                  result_.failures() == 1 ? "does" : "do"));
    }

    void add_test() {
        if (!result_.prediction_test) return;
        const auto& test = *result_.prediction_test;
        const auto& worst = worst_of(test);
        const auto name = worst.elastomer + " on " + worst.surface;
        if (test.probability < improbable)
            add_reservation(
                fmt::format("The full-contact balance (Eq. 7) does not fit {} within the errors ({}). The largest "
                            "deviation from the prediction is {:+.1f} standard errors, for {}. Predictions share "
                            "spectra and moduli, so one wrong input can shift several pairs.",
                            test.n == 1 ? "the pair" : fmt::format("the {} pairs", test.n), test_text(test),
                            worst.standardised(), name));
        else if (stands_out(worst.standardised(), test.n))
            add_limit(fmt::format(
                          "{} deviates by {:+.1f} standard errors from its prediction, although the test of all pairs "
                          "gives p = {}.",
                          name, worst.standardised(), probability_text(test.probability)),
                      deviation_note(test));
        if (test.probability < improbable && test.extra_scatter > 0.0)
            add_reservation(
                fmt::format("A prediction of the full-contact balance (Eq. 7) for another pair has an additional "
                            "uncertainty of {}, the scatter between pairs.",
                            format_value(test.extra_scatter, "J/m2", 2)));
        if (!test.left_out.empty())
            add_limit("The test of the balance does not include " + listed(test.left_out) + ".");
    }

    void add_rivals() {
        const auto rivals = rivals_of(result_);
        if (!rivals.alike.empty())
            add_limit(fmt::format("The pairs cannot distinguish the full-contact balance (Eq. 7) from {}.",
                                  listed(rivals.alike)));
        if (!rivals.better.empty())
            add_limit(
                fmt::format("The pairs support {} more than the full-contact balance (Eq. 7).", listed(rivals.better)));
    }

    void add_fits() {
        if (const auto apart = loss_minus_approach(result_); apart && interval_of(*apart) && !may_be_zero(*apart))
            add_reservation(fmt::format(
                "The energy loss and the approach give different W_int, with a difference of {} by generalised "
                "least squares. The full-contact balance (Eq. 7) or the true-area loss (Eq. 10) is "
                "incomplete.",
                format_uncertain(*apart, "J/m2")));
        if (const auto apart = loss_minus_approach(result_);
            apart && may_be_zero(*apart) && !could_have_refused(*apart, result_))
            add_limit(
                fmt::format("The data do not test whether the loss is proportional to the true area (Eq. 10). Half or "
                            "twice the W_int of approach would agree with the data of {} as well.",
                            pairs_text(result_.loop->through_origin.n)));
        if (result_.pairs.empty()) return;
        if (!result_.modified && result_.work_of_adhesion)
            add_limit("The approach is not fitted: " + result_.modified.reason + ".");
        if (!result_.loop) add_reservation("The loop energies are not fitted: " + result_.loop.reason + ".");
        if (!result_.work_of_adhesion) add_limit("W_app is not predicted: " + result_.work_of_adhesion.reason + ".");
    }

    void add_retraction() {
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
            add_limit(fmt::format(
                "Whether W_ret is constant along the retraction is undetermined for {}: only the pull-off is "
                "known.",
                pairs_text(unknown)));
        if (!changing.empty())
            add_limit("W_ret changes along the retraction of " + listed(changing) +
                      ". The value at pull-off is not the work of the whole retraction.");
    }

    void add_exact_inputs() {
        std::vector<std::string> kinds;
        for (const auto& [what, names] : study::exact_inputs(result_))
            kinds.push_back(names.empty() ? what : fmt::format("{} ({})", what, fmt::join(names, ", ")));
        if (!kinds.empty() && result_.work_of_adhesion)
            add_limit(
                fmt::format("The study gives no ± for some inputs, which are treated as exact: {}.", listed(kinds)));
    }

    void add_design() {
        const auto surfaces = std::count_if(result_.surfaces.begin(), result_.surfaces.end(), fine);
        const auto experiments = std::count_if(result_.experiments.begin(), result_.experiments.end(), fine);
        if (result_.surfaces.empty())
            add_limit(
                "The study contains no surface. No work of adhesion is predicted or compared with a measured one.");
        else if (surfaces == 0) add_limit("No surface could be analysed. No work of adhesion is predicted.");
        if (tested_.pairs == 0 && surfaces > 0) {
            const std::string none = result_.experiments.empty() ? "The study contains no experiment."
                                     : experiments == 0          ? "No experiment could be analysed."
                                                        : "The study contains no experiment on a rough surface.";
            add_limit(
                none +
                (result_.study.work_of_adhesion
                     ? fmt::format(
                           " W_app is predicted with the given W_int of {}. No measurement tests this prediction.",
                           format_uncertain(*result_.study.work_of_adhesion, "J/m2"))
                     : std::string(" Roughness is known, but a prediction of W_app needs W_int. The study gives no "
                                   "work_of_adhesion.")));
        }
        if (tested_.pairs == 1)
            add_limit(
                "Only one pair is measured. One value of W_int always matches one pair, so the data neither support nor "
                "rule out the balance.");
        else if (tested_.pairs > 1 && tested_.surfaces.size() == 1)
            add_limit(fmt::format(
                "All {} pairs are on one surface, {}. The data do not test how adhesion depends on roughness.",
                tested_.pairs, *tested_.surfaces.begin()));
        if (tested_.pairs > 1 && tested_.elastomers.size() == 1)
            add_limit(fmt::format(
                "All {} pairs are on one elastomer, {}. The data do not test that the stored energy grows with "
                "the modulus.",
                tested_.pairs, *tested_.elastomers.begin()));
        if (result_.experiments.size() == 1)
            add_limit("The study contains one experiment. The scatter between repeated loops is not known.");
    }

    /// Names of the surfaces that something holds for.
    template <class Holds>
    [[nodiscard]] std::vector<std::string> surfaces_where(Holds holds) const {
        std::vector<std::string> names;
        for (const auto& surface : result_.surfaces)
            if (!surface.failed() && holds(surface)) names.push_back(surface.name);
        return names;
    }

    void add_spectra() {
        if (const auto names = surfaces_where([](const auto& s) { return s.reconstructed; }); !names.empty())
            add_limit(fmt::format(
                "The {} of {} {} from published moments, not measured. Stored energy and the balance scale by "
                "scale depend on the self-affine model.",
                names.size() == 1 ? "spectrum" : "spectra", listed(names),
                names.size() == 1 ? "is reconstructed" : "are reconstructed"));
        const auto measured_once = [](const auto& s) {
            return std::count_if(s.measurements.begin(), s.measurements.end(), fine) == 1;
        };
        if (const auto names = surfaces_where(measured_once); !names.empty())
            add_limit(
                fmt::format("The study contains one measurement{} of {}. The variation between places is not known.",
                            names.size() == 1 ? "" : " each", listed(names)));
        std::vector<std::string> nonconforming;
        for (const auto& pair : result_.pairs)
            if (pair.modified && !pair.modified->work.conforms)
                nonconforming.push_back(pair.surface + " × " + pair.elastomer);
        if (!nonconforming.empty())
            add_limit("The full-contact balance (Eq. 7) gives no adhesion for " + listed(nonconforming) +
                      ". The balance applies to full contact only; its value is set to 0.");
    }

    /// Warnings that limit the conclusions, each matter in one sentence with the items concerned.
    void add_warnings() {
        const auto groups = grouped_alerts(result_);
        const Subjects concerned(result_);
        for (const auto& bearing : bearings()) {
            std::vector<Subject> subjects;
            for (const auto& group : groups)
                if (std::find(bearing.codes.begin(), bearing.codes.end(), group.code) != bearing.codes.end())
                    for (const auto& alert : group.alerts) subjects.push_back(concerned.of(alert));
            if (!subjects.empty()) add_limit(fmt::format(fmt::runtime(bearing.sentence), listed(names_of(subjects))));
        }
    }

    const StudyResult& result_;
    Tested tested_;
    std::vector<Limit> limits_;
};

}  // namespace

std::vector<Limit> limits_of(const StudyResult& result) { return Limits(result).take(); }

Verdict verdict(const StudyResult& result) {
    constexpr std::size_t max_reservations = 2;
    Verdict found{answer_of(result), findings_of(result), {}, {}};
    for (const auto& limit : limits_of(result)) {
        found.limits.push_back(limit.note.empty() ? limit.sentence : limit.sentence + " " + limit.note);
        if (limit.reserves && found.reservations.size() < max_reservations)
            found.reservations.push_back(limit.sentence);
    }
    return found;
}

std::string deviation_note(const adhesion::PredictionTest& test) {
    return test.work_fitted
               ? "The deviation of a pair includes only the errors of this pair, at the stated W_int. The test of all pairs "
                 "includes shared errors: one wrong spectrum, modulus or surface energy shifts several pairs together. "
                 "W_int may also shift to fit all pairs best. One large deviation and a large p are compatible."
               : "The deviation of a pair includes only the errors of this pair. The test of all pairs includes shared "
                 "errors: one wrong spectrum, modulus, surface energy or W_int shifts several pairs together and counts "
                 "once.";
}

}  // namespace setae::output
