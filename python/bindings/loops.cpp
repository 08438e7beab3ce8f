// SPDX-License-Identifier: GPL-3.0-or-later
#include <nanobind/stl/map.h>
#include <nanobind/stl/shared_ptr.h>
#include <nlohmann/json.hpp>

#include "bindings.hpp"
#include "setae/answers/force_curves.hpp"
#include "setae/answers/machine_stiffness.hpp"
#include "setae/output/force_map_output.hpp"

namespace setae::python {
namespace {

/// A loop as read, and from which file.
struct Loop {
    std::string file;
    study::OpenedLoop opened;
};

/// What `setae jkr fit` and `setae jkr energy` print of a loop.
struct LoopAnswer {
    std::string fit, energy;
};

void bind_requests(nb::module_& module) {
    nb::class_<answers::LoopFiles>(module, "LoopFiles")
        .def(
            "__init__",
            [](answers::LoopFiles* files, const std::string& mapping, const std::string& mapping_folder,
               const std::string& camera, const std::string& camera_mapping, const std::string& clock_offset,
               const std::string& pixel, std::optional<double> frame_rate, bool fringes,
               const std::string& spring_constant, const std::string& sensitivity, std::optional<long> curve_number,
               const std::vector<std::string>& columns) {
                new (files) answers::LoopFiles;
                files->columns = columns;
                files->map = mapping;
                files->mapping_folder = mapping_folder;
                files->camera = camera;
                files->camera_map = camera_mapping;
                files->clock_offset = clock_offset;
                files->pixel = pixel;
                files->frame_rate = frame_rate;
                files->fringes = fringes;
                files->spring_constant = spring_constant;
                files->sensitivity = sensitivity;
                files->curve_number = curve_number;
            },
            nb::arg("mapping"), nb::arg("mapping_folder"), nb::arg("camera"), nb::arg("camera_mapping"),
            nb::arg("clock_offset"), nb::arg("pixel"), nb::arg("frame_rate").none(), nb::arg("fringes"),
            nb::arg("spring_constant"), nb::arg("sensitivity"), nb::arg("curve_number").none(), nb::arg("columns"));
    nb::class_<answers::LoopBodies>(module, "LoopBodies")
        .def(
            "__init__",
            [](answers::LoopBodies* bodies, const std::string& radius, const std::string& lens_height,
               const std::string& layer_thickness, const std::string& counter_modulus,
               std::optional<double> poisson_ratio, std::optional<double> counter_poisson_ratio) {
                new (bodies) answers::LoopBodies{radius,          lens_height,   layer_thickness,
                                                 counter_modulus, poisson_ratio, counter_poisson_ratio};
                (void)bodies->without_radius({});  // what is wrong with it is said here
            },
            nb::arg("radius"), nb::arg("lens_height"), nb::arg("layer_thickness"), nb::arg("counter_modulus"),
            nb::arg("poisson_ratio").none(), nb::arg("counter_poisson_ratio").none());
    nb::class_<answers::LoopSettings>(module, "LoopSettings")
        .def(nb::init<>())
        .def_rw("machine_stiffness", &answers::LoopSettings::machine_stiffness)
        .def_rw("rigid_contact", &answers::LoopSettings::rigid_contact)
        .def_rw("contact_point", &answers::LoopSettings::contact_point)
        .def_rw("displacement_drift", &answers::LoopSettings::displacement_drift)
        .def_rw("segments", &answers::LoopSettings::segments)
        .def_rw("relaxation", &answers::LoopSettings::relaxation)
        .def_rw("baseline_share", &answers::LoopSettings::baseline_share)
        .def_rw("area_ratio", &answers::LoopSettings::area_ratio)
        .def_rw("samples_dropped", &answers::LoopSettings::samples_dropped)
        .def_rw("unweighted", &answers::LoopSettings::unweighted)
        .def_rw("retraction_modulus_free", &answers::LoopSettings::modulus_free)
        .def_rw("no_drift", &answers::LoopSettings::no_drift)
        .def_rw("drift", &answers::LoopSettings::drift)
        .def_rw("force_zero", &answers::LoopSettings::force_zero)
        .def_rw("whole_retraction", &answers::LoopSettings::whole_retraction);
    nb::class_<answers::LoopModelsRequest>(module, "LoopModels")
        .def(nb::init<>())
        .def_rw("models", &answers::LoopModelsRequest::models)
        .def_rw("branch", &answers::LoopModelsRequest::branch)
        .def_rw("errors", &answers::LoopModelsRequest::errors)
        .def_rw("contact_point", &answers::LoopModelsRequest::contact_point)
        .def_rw("cohesive_stress", &answers::LoopModelsRequest::cohesive_stress)
        .def_rw("profile", &answers::LoopModelsRequest::profile)
        .def_rw("crack_speed", &answers::LoopModelsRequest::crack_speed)
        .def_rw("exponent", &answers::LoopModelsRequest::exponent);
}

void bind_force_curves(nb::module_& module) {
    using Request = answers::CurveRequest;
    nb::class_<Request>(module, "CurveRequest")
        .def(nb::init<>())
        .def_rw("tip", &Request::tip)
        .def_rw("half_angle", &Request::half_angle)
        .def_rw("model", &Request::model)
        .def_rw("range", &Request::range)
        .def_rw("contact_point", &Request::contact_point)
        .def_rw("keep_baseline_slope", &Request::keep_baseline_slope);
    module.def(
        "fit_force_curves",
        [](const std::string& file, const answers::LoopFiles& files, const answers::LoopBodies& bodies,
           const answers::CurveRequest& request) {
            return unlocked([&](const auto&) {
                const bool several = request.concerns_map(file, files);
                return output::as_text(several
                                           ? output::to_json(answers::fit_map(file, files, bodies, request))
                                           : answers::to_json(file, answers::fit_curve(file, files, bodies, request)));
            });
        },
        nb::arg("file"), nb::arg("files"), nb::arg("bodies"), nb::arg("request"),
        "of one force curve, or of every one of a file, as `setae jkr fit --curve --json` prints it");
}

}  // namespace

void bind_loops(nb::module_& module) {
    bind_requests(module);
    nb::class_<Loop>(module, "Loop")
        .def_ro("file", &Loop::file)
        .def_prop_ro("columns", [](nb::handle self) { return columns(nb::cast<const Loop&>(self).opened.table, self); })
        .def_prop_ro("units", [](const Loop& loop) { return units(loop.opened.table); })
        .def_prop_ro("metadata", [](const Loop& loop) { return loop.opened.table.metadata; })
        .def_prop_ro("alerts", [](const Loop& loop) { return output::as_text(output::to_json(loop.opened.alerts)); });
    nb::class_<LoopAnswer>(module, "LoopAnswer").def_ro("fit", &LoopAnswer::fit).def_ro("energy", &LoopAnswer::energy);
    module.def(
        "open_loop",
        [](const std::string& file, const answers::LoopFiles& files) {
            return unlocked([&](const auto&) { return Loop{file, files.open(file)}; });
        },
        nb::arg("file"), nb::arg("files"));
    bind_force_curves(module);
    module.def(
        "machine_stiffness",
        [](const Loop& loop) {
            return unlocked([&](const auto&) {
                return output::as_text(answers::to_json(loop.file, answers::machine_stiffness(loop.opened)));
            });
        },
        nb::arg("loop"), "as `setae jkr stiffness --json` prints it");
    module.def(
        "fit_loop",
        [](const Loop& loop, const answers::LoopBodies& bodies, const answers::LoopSettings& settings,
           const answers::LoopModelsRequest& models) {
            return unlocked([&](const auto&) {
                const auto analysed = answers::analysed_loop(loop.opened, loop.file, bodies, settings);
                return LoopAnswer{output::as_text(answers::fit_json(analysed, models.options())),
                                  output::as_text(answers::energy_json(analysed))};
            });
        },
        nb::arg("loop"), nb::arg("bodies"), nb::arg("settings"), nb::arg("models"));
}

}  // namespace setae::python
