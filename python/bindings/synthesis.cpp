// SPDX-License-Identifier: GPL-3.0-or-later
#include <nanobind/stl/shared_ptr.h>
#include <nlohmann/json.hpp>

#include "heights.hpp"
#include "request.hpp"
#include "setae/answers/blind_tip.hpp"
#include "setae/answers/heights_file.hpp"
#include "setae/answers/synthesis_fields.hpp"
#include "setae/output/field_json.hpp"

namespace setae::python {
namespace {

/// Simulated heights, with their `--json`.
struct Made {
    std::shared_ptr<Heights> heights;
    std::string json;
};

/// An estimated tip, and the surface where it is certain.
struct TipAndSurface {
    std::shared_ptr<Heights> tip, surface;
    std::string json;
};

}  // namespace

void bind_synthesis(nb::module_& module) {
    using Request = answers::SynthesisRequest;
    nb::class_<Request> request(module, "SynthesisRequest");
    request.def(nb::init<>()).def_rw("spectrum_unit", &Request::spectrum_unit);
    bind_asked(request);
    nb::class_<Made>(module, "Made").def_ro("heights", &Made::heights).def_ro("json", &Made::json);
    module.def(
        "synthesize",
        [](const Request& request, const std::string& output) {
            return unlocked([&](const auto&) {
                if (!output.empty()) answers::require_heights_ending(output);
                auto made = answers::synthesis_of(request);
                if (!output.empty()) answers::write_heights(output, made.measurement);
                const answers::SynthesisEntry entry{&made, output};
                auto json = output::as_text(output::described(&entry, answers::description_of(made)));
                return Made{std::make_shared<Heights>(std::move(made.measurement)), std::move(json)};
            });
        },
        nb::arg("request"), nb::arg("output"));
    module.def(
        "write_heights",
        [](const Heights& heights, const std::string& file) {
            return unlocked([&](const auto&) {
                answers::write_heights(file, heights.measurement());
                return 0;
            });
        },
        nb::arg("heights"), nb::arg("file"), "writes heights; the ending of the file gives the format");
    nb::class_<answers::BlindTipRequest> tip(module, "BlindTipRequest");
    tip.def(nb::init<>());
    bind_asked(tip);
    nb::class_<TipAndSurface>(module, "TipAndSurface")
        .def_ro("tip", &TipAndSurface::tip)
        .def_ro("surface", &TipAndSurface::surface)
        .def_ro("json", &TipAndSurface::json);
    module.def(
        "blind_tip",
        [](const Item& item, const answers::BlindTipRequest& request) {
            return unlocked([&](const auto&) {
                auto answer = answers::blind_tip(item.path, prepared_of(item).measurement, request);
                auto json = output::as_text(output::described(answer));
                return TipAndSurface{std::make_shared<Heights>(std::move(answer.tip)),
                                     std::make_shared<Heights>(std::move(answer.surface)), std::move(json)};
            });
        },
        nb::arg("item"), nb::arg("request"));
}

}  // namespace setae::python
