// SPDX-License-Identifier: GPL-3.0-or-later
#include <nanobind/stl/shared_ptr.h>
#include <nlohmann/json.hpp>

#include "heights.hpp"
#include "setae/answers/hard_wall.hpp"
#include "setae/answers/persson_contact.hpp"
#include "setae/core/errors.hpp"
#include "setae/half_space/hard_wall.hpp"
#include "setae/processing/pipeline.hpp"

namespace setae::python {
namespace {

/// A contact that was solved, and what `--json` says of it.
struct HardWallContact {
    answers::HardWallAnswer answer;
    std::string json;
};

nb::object map_of(const Array2D& values, nb::handle owner) {
    const std::array shape{static_cast<std::size_t>(values.rows()), static_cast<std::size_t>(values.cols())};
    return nb::cast(ReadOnly(values.data(), shape.size(), shape.data(), owner));
}

void bind_persson(nb::module_& module) {
    using Request = answers::PerssonRequest;
    using Contact = answers::PerssonContact;
    nb::class_<Request>(module, "PerssonRequest")
        .def(nb::init<>())
        .def_rw("contact_modulus", &Request::modulus)
        .def_rw("pressure", &Request::pressure)
        .def_rw("work_of_adhesion", &Request::work)
        .def_rw("layer", &Request::layer)
        .def_rw("poisson_ratio", &Request::poisson_ratio)
        .def_rw("energy_factor", &Request::energy_factor)
        .def_rw("frictionless", &Request::frictionless);
    nb::class_<Contact>(module, "PerssonContact")
        .def_prop_ro("columns", [](nb::handle self) { return columns(nb::cast<const Contact&>(self).table(), self); })
        .def_prop_ro("units", [](const Contact& contact) { return units(contact.table()); })
        .def("json", [](const Contact& contact) { return output::as_text(answers::to_json(contact)); });
    module.def(
        "persson",
        [](const std::vector<std::shared_ptr<Item>>& items, const answers::AnalysisRequest& request,
           const answers::PerssonRequest& asked, bool every_measurement) {
            return unlocked([&](const auto&) {
                (void)asked.body();  // what is missing is said before files are read
                auto analysis = request.analysis();
                analysis.bootstrap_resamples = 0;
                const auto found = study::analyse_surface(
                    surface_of(items), analysis,
                    {.previews = false, .parameters = false, .every_measurement = every_measurement}, {});
                return answers::persson_contact(analysed(found.surface), asked);
            });
        },
        nb::arg("items"), nb::arg("analysis"), nb::arg("request"), nb::arg("every_measurement"));
}

}  // namespace

void bind_contact(nb::module_& module) {
    bind_persson(module);
    using Request = answers::HardWallRequest;
    nb::class_<Request>(module, "HardWallRequest")
        .def(nb::init<>())
        .def_rw("contact_modulus", &Request::contact_modulus)
        .def_rw("pressure", &Request::pressure)
        .def_rw("displacement", &Request::displacement)
        .def_rw("mean_gap", &Request::mean_gap)
        .def_rw("layer", &Request::layer)
        .def_rw("hardness", &Request::hardness)
        .def_rw("poisson_ratio", &Request::poisson_ratio)
        .def_rw("free", &Request::free)
        .def_rw("bonded", &Request::bonded)
        .def_rw("frictionless", &Request::frictionless)
        .def_rw("tolerance", &Request::tolerance);
    nb::class_<HardWallContact>(module, "HardWallContact")
        .def_prop_ro("pressures",
                     [](nb::handle self) {
                         return map_of(nb::cast<const HardWallContact&>(self).answer.contact.pressures, self);
                     })
        .def_prop_ro(
            "gaps",
            [](nb::handle self) { return map_of(nb::cast<const HardWallContact&>(self).answer.contact.gaps, self); })
        .def("quantities",
             [](const HardWallContact& contact) {
                 auto list = output::Json::array();
                 for (const auto& q : contact.answer.quantities) list.push_back(output::to_json(q));
                 return output::as_text(list);
             })
        .def_ro("json", &HardWallContact::json);
    module.def(
        "hard_wall",
        [](const Item& item, const answers::HardWallRequest& request) {
            return unlocked([&](const std::atomic<bool>& cancelled) {
                request.require_complete();
                const auto prepared = prepared_of(item);
                const auto stop_where_asked = [&](const half_space::SolveProgress&) {
                    if (cancelled) throw Interrupted();
                };
                HardWallContact contact{
                    .answer = answers::hard_wall(item.path, prepared.measurement, request, {}, stop_where_asked),
                    .json = {}};
                contact.json = output::as_text(answers::to_json(contact.answer, prepared.records));
                return contact;
            });
        },
        nb::arg("item"), nb::arg("request"));
}

}  // namespace setae::python
