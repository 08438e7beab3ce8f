// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <utility>

#include <nanobind/stl/map.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/shared_ptr.h>
#include <nlohmann/json.hpp>

#include "request.hpp"
#include "setae/answers/curve_fields.hpp"
#include "setae/answers/fitted_points.hpp"
#include "setae/answers/loop_fields.hpp"
#include "setae/answers/machine_stiffness.hpp"
#include "setae/output/field_json.hpp"
#include "setae/tables/loop_file.hpp"

namespace setae::python {
namespace {

/// A loop and its file.
struct Loop {
    std::string file;
    study::OpenedLoop opened;
};

/// JSON of `setae jkr fit` and `setae jkr energy` for a loop, and the points of the fits.
struct LoopAnswer {
    std::string fit, energy;
    Table record, loading, unloading;
};

/// JSON of `setae jkr fit` for a force curve or for every curve of a file, and the points of the fits of one curve.
struct CurveAnswer {
    std::string json;
    std::map<std::string, Table> segments{};
};

CurveAnswer answer_of(const std::string& file, const loops::ForceCurveAnalysis& analysis) {
    CurveAnswer answer{.json = output::as_text(output::described(answers::FittedCurve{file, &analysis}))};
    for (const auto& segment : analysis.segments)
        if (segment.fit) answer.segments.emplace(segment.name, answers::fitted_segment(*segment.fit));
    return answer;
}

/// The columns of a table that `owner` keeps alive, under a name.
template <class Answer>
void bind_table(nb::class_<Answer>& answer, const char* name, Table Answer::*table) {
    answer.def_prop_ro(name, [table](nb::handle self) { return columns(nb::cast<const Answer&>(self).*table, self); });
}

void bind_requests(nb::module_& module) {
    using answers::LoopBodies, answers::LoopFiles, answers::LoopModelsRequest, answers::LoopSettings;
    nb::class_<LoopFiles> files(module, "LoopFiles");
    files.def(nb::init<>()).def_rw("mapping_folder", &LoopFiles::mapping_folder);
    bind_options(files, fields::Asked<LoopFiles>::mapping);
    bind_asked(files);
    bind_asked<LoopFiles, answers::CameraPictures>(files);
    nb::class_<LoopBodies> bodies(module, "LoopBodies");
    bodies.def(nb::init<>())
        .def(
            "check", [](const LoopBodies& given) { (void)given.without_radius({}); },
            "raises an error for wrong values");
    bind_asked(bodies);
    nb::class_<LoopSettings> settings(module, "LoopSettings");
    settings.def(nb::init<>());
    bind_asked(settings);
    nb::class_<LoopModelsRequest> models(module, "LoopModels");
    models.def(nb::init<>()).def_rw("contact_point", &LoopModelsRequest::contact_point);
    bind_asked(models);
}

void bind_force_curves(nb::module_& module) {
    using Request = answers::CurveRequest;
    nb::class_<Request> request(module, "CurveRequest");
    request.def(nb::init<>()).def_rw("range", &Request::range);
    bind_asked(request);
    nb::class_<CurveAnswer>(module, "CurveAnswer")
        .def_ro("json", &CurveAnswer::json)
        .def_prop_ro("segments", [](nb::handle self) {
            nb::typed<nb::dict, nb::str, nb::typed<nb::dict, nb::str, ReadOnly1D>> segments;
            for (const auto& [name, table] : nb::cast<const CurveAnswer&>(self).segments)
                segments[name.c_str()] = columns(table, self);
            return segments;
        });
    module.def(
        "fit_force_curves",
        [](const std::string& file, const answers::LoopFiles& files, const answers::LoopBodies& bodies,
           const answers::CurveRequest& request) {
            return unlocked([&](const auto&) {
                if (request.concerns_map(file, files))
                    return CurveAnswer{
                        .json = output::as_text(output::described(answers::fit_map(file, files, bodies, request)))};
                return answer_of(file, answers::fit_curve(file, files, bodies, request));
            });
        },
        nb::arg("file"), nb::arg("files"), nb::arg("bodies"), nb::arg("request"),
        "fits of one force curve, or of every curve of a file, as printed by `setae jkr fit --curve --json`");
}

/// One loop of a fit of several.
using LoopOfMany = std::pair<Loop*, answers::LoopBodies*>;

std::string fitted_together(const std::vector<LoopOfMany>& loops, const answers::LoopSettings& settings,
                            const answers::LoopModelsRequest& models) {
    const auto options = models.options();
    std::vector<loops::GlobalBranch> shared;
    auto entries = output::Json::array();
    for (const auto& [loop, bodies] : loops) {
        const auto one = answers::analysed_loop(loop->opened, loop->file, *bodies, settings);
        shared.push_back(study::branch_to_share(one.file, one.analysis, one.bodies, one.options, options));
        entries.push_back(output::described(answers::fitted(one, options)));
    }
    const auto fit = study::shared_fit(shared, options);
    auto json = output::described(answers::SharedLoops{&fit});
    json["loops"] = std::move(entries);
    return output::as_text(json);
}

void bind_shared_fit(nb::module_& module) {
    module.def(
        "fit_loops",
        [](const std::vector<LoopOfMany>& loops, const answers::LoopSettings& settings,
           const answers::LoopModelsRequest& models) {
            return unlocked([&](const auto&) { return fitted_together(loops, settings, models); });
        },
        nb::arg("loops"), nb::arg("settings"), nb::arg("models"), "as printed by `setae jkr fit --share --json`");
}

}  // namespace

void bind_loops(nb::module_& module) {
    bind_requests(module);
    nb::class_<Loop>(module, "Loop")
        .def_ro("file", &Loop::file)
        .def_prop_ro("columns", [](nb::handle self) { return columns(nb::cast<const Loop&>(self).opened.table, self); })
        .def_prop_ro("units", [](const Loop& loop) { return units(loop.opened.table); })
        .def_prop_ro("metadata", [](const Loop& loop) { return loop.opened.table.metadata; })
        .def(
            "save",
            [](const Loop& loop, const std::string& file, const std::map<std::string, std::string>& entries) {
                auto metadata = tables::loop_metadata(loop.opened.table);
                metadata.emplace("source", std::filesystem::path(loop.file).filename().string());
                for (const auto& [key, value] : entries) metadata[key] = value;
                tables::write_loop(file, loop.opened.table, metadata);
            },
            nb::arg("file"), nb::arg("entries"), "writes a loop file, as `setae jkr import -o`")
        .def_prop_ro("alerts", [](const Loop& loop) { return output::as_text(output::to_json(loop.opened.alerts)); });
    nb::class_<LoopAnswer> answer(module, "LoopAnswer");
    answer.def_ro("fit", &LoopAnswer::fit).def_ro("energy", &LoopAnswer::energy);
    bind_table(answer, "record", &LoopAnswer::record);
    bind_table(answer, "loading", &LoopAnswer::loading);
    bind_table(answer, "unloading", &LoopAnswer::unloading);
    module.def(
        "open_loop",
        [](const std::string& file, const answers::LoopFiles& files) {
            return unlocked([&](const auto&) { return Loop{file, files.open(file)}; });
        },
        nb::arg("file"), nb::arg("files"));
    bind_force_curves(module);
    bind_shared_fit(module);
    module.def(
        "machine_stiffness",
        [](const Loop& loop) {
            return unlocked([&](const auto&) {
                return output::as_text(
                    output::described(answers::StiffnessOfFile{loop.file, answers::machine_stiffness(loop.opened)}));
            });
        },
        nb::arg("loop"), "as printed by `setae jkr stiffness --json`");
    module.def(
        "fit_loop",
        [](const Loop& loop, const answers::LoopBodies& bodies, const answers::LoopSettings& settings,
           const answers::LoopModelsRequest& models) {
            return unlocked([&](const auto&) {
                const auto analysed = answers::analysed_loop(loop.opened, loop.file, bodies, settings);
                return LoopAnswer{output::as_text(output::described(answers::fitted(analysed, models.options()))),
                                  output::as_text(output::described(answers::LoopEnergies{&analysed})),
                                  answers::corrected_record(analysed),
                                  answers::fitted_samples(analysed, loops::LoopBranch::loading),
                                  answers::fitted_samples(analysed, loops::LoopBranch::unloading)};
            });
        },
        nb::arg("loop"), nb::arg("bodies"), nb::arg("settings"), nb::arg("models"));
}

}  // namespace setae::python
