// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include <nanobind/stl/pair.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/tuple.h>
#include <nlohmann/json.hpp>

#include "request.hpp"
#include "setae/answers/draft_fields.hpp"
#include "setae/answers/patch_survey_fields.hpp"
#include "setae/answers/run_time.hpp"
#include "setae/bytes/protected_inputs.hpp"
#include "setae/output/budget.hpp"
#include "setae/output/field_json.hpp"
#include "setae/output/hysteresis_fields.hpp"
#include "setae/output/json.hpp"
#include "setae/output/next_measurement_output.hpp"
#include "setae/output/screen.hpp"
#include "setae/output/study_tables.hpp"
#include "setae/parallel/cancellation.hpp"
#include "setae/report/report.hpp"
#include "setae/study/hysteresis.hpp"
#include "setae/study/next_measurement.hpp"
#include "setae/study/provenance.hpp"
#include "setae/study/study_draft.hpp"
#include "setae/study_figures/write_figures.hpp"

namespace setae::python {
namespace {

/// The result of a study, with its figures and the store of results.
struct Study {
    explicit Study(const std::optional<std::string>& folder)
        : store(folder ? std::make_unique<cache::Store>(folder->empty() ? cache::default_folder() : *folder,
                                                        study::version())
                       : std::make_unique<cache::Store>()) {}

    std::unique_ptr<cache::Store> store;
    study::StudyResult result;
    std::vector<study_figures::StudyFigure> figures;
};
using Run = std::shared_ptr<Study>;

/// A figure of a study.
struct Figure {
    Run study;
    const study_figures::StudyFigure* figure;
};

study::Study read(const std::string& file, const std::string& output, const std::string& mapping_folder) {
    auto study = study::read_study(file, mapping_folder);
    if (!output.empty()) study.output = output;
    return study;
}

/// cache: folder of results; empty: the folder of the user; absent: no results are kept.
Run run(const std::string& file, const std::string& output, const std::optional<std::string>& cache,
        const std::string& mapping_folder, const std::atomic<bool>& cancelled) {
    auto done = std::make_shared<Study>(cache);
    done->result =
        study::run_study(read(file, output, mapping_folder), {.store = done->store.get(), .cancelled = &cancelled});
    done->figures = study_figures::study_figures(done->result);
    return done;
}

void bind_patches(nb::module_& module) {
    using Request = answers::PatchSurveyRequest;
    nb::class_<Request> request(module, "PatchSurveyRequest");
    request.def(nb::init<>());
    bind_asked(request);
    module.def(
        "conform",
        [](const Run& study, const Request& request) {
            return unlocked([&](const std::atomic<bool>& cancelled) {
                const parallel::CancellationScope scope(cancelled);
                return output::as_text(output::described(study ? answers::patch_survey(study->result, request)
                                                               : answers::patch_survey(request)));
            });
        },
        nb::arg("study").none(), nb::arg("request"), "as printed by `setae lab conform --json`");
}

void bind_figures(nb::module_& module) {
    nb::class_<Figure>(module, "StudyFigure")
        .def_prop_ro("identifier", [](const Figure& f) { return f.figure->identifier; })
        .def_prop_ro("name", [](const Figure& f) { return f.figure->name; })
        .def_prop_ro("title", [](const Figure& f) { return f.figure->title; })
        .def_prop_ro("caption", [](const Figure& f) { return f.figure->caption; })
        .def_prop_ro(
            "reason", [](const Figure& f) { return f.figure->reason; },
            "reason why the figure cannot be drawn; empty if it can be drawn")
        .def(
            "drawn",
            [](const Figure& f, const std::string& ending) {
                const auto bytes = unlocked([&](const auto&) {
                    return ending == "csv" ? study_figures::data_of(*f.figure, f.study->result.study.path)
                                           : study_figures::bytes_of(*f.figure, ending, f.study->store.get());
                });
                return nb::bytes(bytes.data(), bytes.size());
            },
            nb::arg("ending"), "bytes of the figure as svg, pdf or png, or its numbers as csv");
}

}  // namespace

void bind_studies(nb::module_& module) {
    bind_patches(module);
    bind_figures(module);
    nb::class_<Study>(module, "StudyRun")
        .def("json", [](const Study& study) { return output::as_text(output::to_json(study.result)); })
        .def(
            "summary", [](const Study& study, std::size_t width) { return output::summary(study.result, width); },
            nb::arg("width"))
        .def(
            "budget", [](const Study& study, std::size_t width) { return output::budget_text(study.result, width); },
            nb::arg("width"))
        .def(
            "next_measurements",
            [](const Study& study, const std::string& target) {
                return unlocked([&](const auto&) {
                    return output::as_text(output::described(
                        output::NextMeasurements{target, study::next_measurements(study.result, target)}));
                });
            },
            nb::arg("target"))
        .def(
            "predict",
            [](const Study& study, int trials, std::uint64_t seed, int threads) {
                return unlocked([&](const auto& cancelled) {
                    std::optional<hysteresis::TrialOptions> options;
                    if (trials > 0)
                        options = {.runs = trials, .seed = seed, .threads = {threads}, .cancelled = &cancelled};
                    const auto& known = study.result.hysteresis;
                    const auto found =
                        known && !options ? *known : study::hysteresis_of(study.result, options, {threads});
                    return output::as_text(output::described(output::HysteresisEntry{&found}));
                });
            },
            nb::arg("trials"), nb::arg("seed"), nb::arg("threads"))
        .def(
            "report",
            [](const Study& study, const std::string& command) {
                return unlocked([&](const auto&) {
                    return report::as_html(study.result, study.figures, {command, answers::time_of_run()});
                });
            },
            nb::arg("command"))
        .def("write_tables",
             [](const Study& study) {
                 return unlocked([&](const auto&) {
                     const bytes::ProtectedInputs inputs;  // no output replaces a file that the study read
                     return output::write_results(study.result);
                 });
             })
        .def_prop_ro("output", [](const Study& study) { return study.result.study.output; })
        .def_prop_ro("successes", [](const Study& study) { return study.result.successes(); })
        .def_prop_ro("failures", [](const Study& study) { return study.result.failures(); });
    module.def("figures_of", [](const Run& study) {
        std::vector<Figure> figures;
        for (const auto& figure : study->figures) figures.push_back({study, &figure});
        return figures;
    });
    module.def(
        "quantity_html",
        [](double value, double standard_error, const std::string& unit,
           const std::optional<std::tuple<double, double, double>>& interval) {
            Quantity quantity =
                output::quantity("", "", Estimate{.value = value, .standard_error = standard_error}, unit);
            if (interval) {
                const auto [lower, upper, level] = *interval;
                quantity.estimate.interval = Interval{lower, upper, level};
            }
            return report::as_html(quantity);
        },
        nb::arg("value"), nb::arg("standard_error"), nb::arg("unit"), nb::arg("interval").none(),
        "a number in SI as in the report of a study");
    module.def(
        "title_of_study",
        [](const std::string& file, const std::string& mapping_folder) { return read(file, {}, mapping_folder).title; },
        nb::arg("file"), nb::arg("mapping_folder"), "reads a study; raises an error for a wrong file");
    module.def(
        "draft_study",
        [](const std::vector<std::string>& paths, const std::string& file, const std::string& mapping_folder) {
            return unlocked([&](const auto&) {
                const auto draft = study::draft_study(paths, file, mapping_folder);
                return std::pair(draft.text, output::as_text(output::described(answers::DraftEntry{file, &draft})));
            });
        },
        nb::arg("paths"), nb::arg("file"), nb::arg("mapping_folder"),
        "text of the draft, and the JSON of `setae study init --json`");
    module.def(
        "run_study",
        [](const std::string& file, const std::string& output, const std::optional<std::string>& cache,
           const std::string& mapping_folder) {
            return unlocked([&](const std::atomic<bool>& cancelled) {
                return run(file, output, cache, mapping_folder, cancelled);
            });
        },
        nb::arg("file"), nb::arg("output"), nb::arg("cache").none(), nb::arg("mapping_folder"));
}

}  // namespace setae::python
