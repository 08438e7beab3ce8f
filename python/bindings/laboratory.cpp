// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "request.hpp"
#include "setae/answers/camera_scale.hpp"
#include "setae/answers/contact_line.hpp"
#include "setae/answers/contour.hpp"
#include "setae/answers/lens.hpp"
#include "setae/answers/line_fields.hpp"
#include "setae/answers/radius_fields.hpp"
#include "setae/answers/replicates.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/contact_line/line_table.hpp"
#include "setae/core/errors.hpp"
#include "setae/output/contour_fields.hpp"
#include "setae/output/field_json.hpp"

namespace setae::python {
namespace {

void bind_lens(nb::module_& module) {
    using Request = answers::LensRequest;
    nb::class_<Request> request(module, "LensRequest");
    request.def(nb::init<>());
    bind_asked(request);
    module.def(
        "lens",
        [](const std::string& file, const Request& request) {
            return unlocked(
                [&](const auto&) { return output::as_text(output::described(answers::lens_of(file, request))); });
        },
        nb::arg("file"), nb::arg("request"), "as printed by `setae jkr lens --json`");
    module.def(
        "camera_scale",
        [](const std::vector<std::string>& pictures, const std::string& pitch) {
            return unlocked([&](const auto&) {
                return output::as_text(output::described(answers::camera_scale(pictures, {pitch})));
            });
        },
        nb::arg("pictures"), nb::arg("pitch"), "as printed by `setae jkr camera --json`");
}

void bind_replicates(nb::module_& module) {
    using Request = answers::ReplicateRequest;
    nb::class_<Request> request(module, "ReplicateRequest");
    request.def(nb::init<>()).def_rw("files", &Request::files);
    bind_asked(request);
    module.def(
        "replicates",
        [](const Request& request) {
            return unlocked(
                [&](const auto&) { return output::as_text(output::described(answers::replicate_summary(request))); });
        },
        nb::arg("request"), "as printed by `setae jkr summary --json`");
}

/// Contact radii of a recording, with their `--json`.
struct Radii {
    Table table;
    std::string csv, json;
};

/// Options of a recording.
template <class Request>
void bind_recording(nb::class_<Request>& request) {
    request.def(nb::init<>());
    bind_asked<Request, answers::CameraPictures>(request);
    bind_asked<Request, answers::RadiusRequest>(request);
}

void bind_radii(nb::module_& module) {
    using Request = answers::RadiusRequest;
    nb::class_<Request> bound(module, "RadiusRequest");
    bind_recording(bound);
    nb::class_<Radii>(module, "Radii")
        .def_prop_ro("columns", [](nb::handle self) { return columns(nb::cast<const Radii&>(self).table, self); })
        .def_prop_ro("units", [](const Radii& radii) { return units(radii.table); })
        .def("save", [](const Radii& radii, const std::string& file) { bytes::write_whole_file(file, radii.csv); })
        .def_ro("json", &Radii::json);
    module.def(
        "contact_radii",
        [](const std::vector<std::string>& frames, const Request& request) {
            return unlocked([&](const auto&) {
                const auto options = request.radius_options();
                const imaging::FrameSource source(frames, request.frame_options());
                const auto radii = imaging::measure_contact_radii(source, options);
                return Radii{imaging::as_table(radii), imaging::as_csv(radii),
                             output::as_text(output::described(radii))};
            });
        },
        nb::arg("frames"), nb::arg("request"));
}

/// The edge of a contact, with its `--json`.
struct Edge {
    Table frames, edge;  ///< one row per frame; `edge` has the radius at every angle
    std::string csv, json;
};

void bind_line(nb::module_& module) {
    using Request = answers::LineRequest;
    nb::class_<Request> bound(module, "LineRequest");
    bind_recording(bound);
    bind_asked(bound);
    bound.def_rw("sphere_radius", &Request::sphere_radius);
    nb::class_<Edge>(module, "Edge")
        .def_prop_ro("columns", [](nb::handle self) { return columns(nb::cast<const Edge&>(self).frames, self); })
        .def_prop_ro("units", [](const Edge& edge) { return units(edge.frames); })
        .def_prop_ro("edge", [](nb::handle self) { return columns(nb::cast<const Edge&>(self).edge, self); })
        .def("save", [](const Edge& edge, const std::string& file) { bytes::write_whole_file(file, edge.csv); })
        .def_ro("json", &Edge::json);
    module.def(
        "contact_line",
        [](const std::vector<std::string>& files, const Request& asked) {
            return unlocked([&](const auto&) {
                const auto answer = answers::contact_line_answer(answers::recorded_edge(files, asked), asked);
                const auto& kept = answer.recorded;
                return Edge{answers::as_table(answer), contact_line::as_table(kept.line, kept.frames),
                            answers::line_csv(kept), output::as_text(output::described(answer))};
            });
        },
        nb::arg("files"), nb::arg("request"));
}

/// A traced picture, and the options of the trace.
struct Contour {
    study::TracedPicture picture;
    study::ContourOptions options;
};

void bind_contour(nb::module_& module) {
    using Request = answers::ContourRequest;
    nb::class_<Request>(module, "ContourRequest")
        .def(nb::init<>())
        .def_rw("vacuum", &Request::vacuum)
        .def_rw("shape", &Request::shape)
        .def_rw("pixel", &Request::pixel)
        .def_rw("scale_bar", &Request::scale_bar)
        .def_rw("calibration", &Request::calibration)
        .def_rw("foil_thickness", &Request::foil_thickness)
        .def_rw("hidden", &Request::hidden)
        .def_rw("smoothing", &Request::smoothing)
        .def_rw("least_length", &Request::min_length)
        .def_rw("denoise", &Request::denoise)
        .def_rw("image", &Request::image)
        .def_rw("ignore_stated_pixel_size", &Request::ignore_stated)
        .def_rw("whole_picture", &Request::whole_picture);
    nb::class_<Contour>(module, "Contour")
        .def_prop_ro("segments", [](const Contour& contour) { return contour.picture.profiles.size(); })
        .def(
            "profile",
            [](const Contour& contour, std::size_t segment) {
                return study::profile_text(contour.picture, segment, contour.options.shape);
            },
            nb::arg("segment"), "text of a profile file")
        .def("overlay",
             [](const Contour& contour) {
                 const auto bytes = study::overlay_of(contour.picture, contour.options);
                 return nb::bytes(bytes.data(), bytes.size());
             })
        .def("json", [](const Contour& contour) {
            return output::as_text(output::described(output::ContourEntry{&contour.picture, &contour.options}));
        });
    module.def(
        "contour",
        [](const std::string& picture, const Request& request, const std::string& anchors) {
            return unlocked([&](const auto&) {
                const auto repeated = request.with_anchors(anchors);
                Contour contour{study::trace_picture(picture, repeated.options), repeated.options};
                repeated.require_picture(contour.picture, anchors);
                return contour;
            });
        },
        nb::arg("picture"), nb::arg("request"), nb::arg("anchors"));
}

}  // namespace

void bind_laboratory(nb::module_& module) {
    bind_lens(module);
    bind_replicates(module);
    bind_radii(module);
    bind_line(module);
    bind_contour(module);
}

}  // namespace setae::python
