// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <utility>

#include <nanobind/stl/shared_ptr.h>
#include <nlohmann/json.hpp>

#include "heights.hpp"
#include "request.hpp"
#include "setae/answers/comparison_fields.hpp"
#include "setae/answers/contact_line.hpp"
#include "setae/answers/contact_surface.hpp"
#include "setae/answers/front_fields.hpp"
#include "setae/answers/persson_fields.hpp"
#include "setae/answers/solve_fields.hpp"
#include "setae/answers/sweep_fields.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/half_space/hard_wall.hpp"
#include "setae/output/field_json.hpp"
#include "setae/processing/pipeline.hpp"

namespace setae::python {
namespace {

/// A solved contact, with its `--json`.
struct SolvedContact {
    Array2D pressures, gaps;
    std::vector<Quantity> quantities;
    std::string json;
};

/// A sweep, with its `--json`.
struct Sweep {
    Table steps;
    std::vector<Quantity> quantities;
    std::string json;
    std::vector<answers::SweepMaps> maps;
    Table edge;  ///< edge of a front; empty if it is not kept
};

std::string texts_of(const std::vector<Quantity>& quantities) {
    auto list = output::Json::array();
    for (const auto& q : quantities) list.push_back(output::to_json(q));
    return output::as_text(list);
}

nb::object map_of(const Array2D& values, nb::handle owner) {
    const std::array shape{static_cast<std::size_t>(values.rows()), static_cast<std::size_t>(values.cols())};
    return nb::cast(ReadOnly(values.data(), shape.size(), shape.data(), owner));
}

/// The surface for the theory of contact.
study::SurfaceResult analysed_surface(const std::vector<std::shared_ptr<Item>>& items,
                                      const answers::AnalysisRequest& request, bool every_measurement) {
    auto surface = answers::surface_for_theory(surface_of(items), request.analysis(), {}, every_measurement);
    (void)analysed(surface);
    return surface;
}

void bind_persson(nb::module_& module) {
    using Request = answers::PerssonRequest;
    using Contact = answers::PerssonContact;
    nb::class_<Request> request(module, "PerssonRequest");
    request.def(nb::init<>());
    bind_asked<Request, answers::BodyRequest>(request);
    bind_asked(request);
    bind_options(request, fields::Asked<Request>::adhesion);
    nb::class_<Contact>(module, "PerssonContact")
        .def_prop_ro("columns", [](nb::handle self) { return columns(nb::cast<const Contact&>(self).table(), self); })
        .def_prop_ro("units", [](const Contact& contact) { return units(contact.table()); })
        .def("json", [](const Contact& contact) { return output::as_text(output::described(contact)); });
    module.def(
        "persson",
        [](const std::vector<std::shared_ptr<Item>>& items, const answers::AnalysisRequest& request,
           const answers::PerssonRequest& asked, bool every_measurement) {
            return unlocked([&](const auto&) {
                asked.require_complete();
                return answers::persson_contact(analysed_surface(items, request, every_measurement), asked);
            });
        },
        nb::arg("items"), nb::arg("analysis"), nb::arg("request"), nb::arg("every_measurement"));
}

void bind_comparison(nb::module_& module) {
    using Request = answers::ComparisonRequest;
    using Comparison = answers::ContactComparison;
    nb::class_<Request> request(module, "ComparisonRequest");
    request.def(nb::init<>()).def_rw("theory", &Request::theory);
    bind_asked(request);
    nb::class_<Comparison>(module, "ContactComparison")
        .def_prop_ro("columns", [](nb::handle self) { return columns(nb::cast<const Comparison&>(self).load, self); })
        .def_prop_ro("units", [](const Comparison& comparison) { return units(comparison.load); })
        .def("json", [](const Comparison& comparison) { return output::as_text(output::described(comparison)); });
    module.def(
        "contact_compare",
        [](const std::vector<std::shared_ptr<Item>>& items, const answers::AnalysisRequest& request,
           const Request& asked, bool every_measurement) {
            return unlocked([&](const auto& cancelled) {
                asked.require_complete();  // throws for missing options before files are read
                const auto surface = analysed_surface(items, request, every_measurement);
                return answers::compare_contact(surface, asked, {}, [&](Index, Index) {
                    if (cancelled) throw Interrupted();
                });
            });
        },
        nb::arg("items"), nb::arg("analysis"), nb::arg("request"), nb::arg("every_measurement"));
}

/// The surface in contact: measured heights, or a surface made from a spectrum.
processing::PipelineResult contact_surface_of(const Item& item, const answers::MadeSurfaceRequest& made,
                                              const std::string& edges, answers::BeyondMap beyond) {
    const auto& request = item.request;
    const answers::ContactSurfaceRequest asked{.measured = {.trend = request.trend, .edges = edges}, .made = made};
    const auto pipeline = request.processing.pipeline();
    if (!item.heights) return answers::contact_surface(item.path, request.file, pipeline, asked, beyond);
    if (made.given())
        throw InvalidArgument(
            "pixels, cell and surface are for a surface made from a spectrum; expected no heights with these arguments");
    return answers::into_contact(prepared_of(item), pipeline, {}, asked.measured, beyond);
}

SolvedContact pressed(const Item& item, const answers::HardWallRequest& request,
                      const answers::MadeSurfaceRequest& made, const std::string& edges,
                      const std::atomic<bool>& cancelled) {
    request.require_complete();
    const auto beyond = request.free ? answers::BeyondMap::nothing : answers::BeyondMap::itself;
    const auto prepared = contact_surface_of(item, made, edges, beyond);
    const auto stop_where_asked = [&](const half_space::SolveProgress&) {
        if (cancelled) throw Interrupted();
    };
    auto answer = answers::hard_wall(item.path, prepared.measurement, request, {}, stop_where_asked);
    auto json = output::as_text(output::described(answers::ContactOutput{&answer, &prepared.records}));
    return {std::move(answer.contact.pressures), std::move(answer.contact.gaps), std::move(answer.quantities),
            std::move(json)};
}

SolvedContact attracted(const Item& item, const answers::HardWallRequest& request,
                        const answers::InteractionRequest& attraction, const answers::MadeSurfaceRequest& made,
                        const std::string& edges) {
    request.require_complete();
    (void)attraction.interaction();
    const auto prepared = contact_surface_of(item, made, edges, answers::BeyondMap::itself);
    auto answer = answers::adhesive_contact(item.path, prepared.measurement, request, attraction);
    auto json = output::as_text(output::described(answers::ContactOutput{&answer, &prepared.records}));
    return {answer.cell.pressures(), answer.cell.gaps(), std::move(answer.quantities), std::move(json)};
}

Sweep swept(const Item& item, const answers::SweepRequest& request, const answers::MadeSurfaceRequest& made,
            const std::string& edges, const std::atomic<bool>& cancelled) {
    request.require_complete();
    const auto prepared = contact_surface_of(item, made, edges, answers::BeyondMap::itself);
    const auto go_on = [&](const answers::SweepProgress&) {
        if (cancelled) throw Interrupted();
        return true;
    };
    auto answer = answers::adhesive_sweep(item.path, prepared.measurement, request, {}, go_on);
    request.finish();
    auto json = output::as_text(output::described(answers::ContactOutput{&answer, &prepared.records}));
    return {std::move(answer.steps), std::move(answer.quantities), std::move(json), std::move(answer.maps), {}};
}

Sweep front_of(const Item& item, const answers::FrontRequest& request, answers::MadeSurfaceRequest made,
               const std::string& edges, int realisations, const std::atomic<bool>& cancelled) {
    request.require_complete();
    if (realisations < 1) throw InvalidArgument("realisations must be at least 1");
    if (realisations > 1 && !made.given())
        throw InvalidArgument(
            "several realisations are of a surface made from a spectrum or a study; expected one of a map");
    std::vector<topography::Measurement> surfaces;
    std::vector<processing::StepRecord> records;
    for (int i = 0; i < realisations; ++i, ++made.seed) {
        auto prepared = contact_surface_of(item, made, edges, answers::BeyondMap::nothing);
        if (i == 0) records = prepared.records;
        surfaces.push_back(std::move(prepared.measurement));
    }
    const auto go_on = [&](double) {
        if (cancelled) throw Interrupted();
        return true;
    };
    auto answer = answers::contact_front(item.path, surfaces, request, {}, go_on);
    auto json = output::as_text(output::described(answers::ContactOutput{&answer, &records}));
    return {std::move(answer.steps), std::move(answer.quantities), std::move(json), {}, std::move(answer.edge)};
}

void bind_made_surface(nb::module_& module) {
    using Request = answers::MadeSurfaceRequest;
    nb::class_<Request> request(module, "MadeSurfaceRequest");
    request.def(nb::init<>());
    bind_asked(request);
}

void bind_solve(nb::module_& module) {
    using Request = answers::HardWallRequest;
    nb::class_<Request> request(module, "HardWallRequest");
    request.def(nb::init<>());
    bind_asked<Request, answers::BodyRequest>(request);
    bind_asked(request);
    nb::class_<answers::InteractionRequest> attraction(module, "InteractionRequest");
    attraction.def(nb::init<>());
    bind_asked(attraction);
    nb::class_<SolvedContact>(module, "SolvedContact")
        .def_prop_ro("pressures",
                     [](nb::handle self) { return map_of(nb::cast<const SolvedContact&>(self).pressures, self); })
        .def_prop_ro("gaps", [](nb::handle self) { return map_of(nb::cast<const SolvedContact&>(self).gaps, self); })
        .def("quantities", [](const SolvedContact& contact) { return texts_of(contact.quantities); })
        .def_ro("json", &SolvedContact::json);
    module.def(
        "contact",
        [](const Item& item, const Request& asked, const answers::InteractionRequest& attracting,
           const answers::MadeSurfaceRequest& made, const std::string& edges) {
            return unlocked([&](const std::atomic<bool>& cancelled) {
                return attracting.given() ? attracted(item, asked, attracting, made, edges)
                                          : pressed(item, asked, made, edges, cancelled);
            });
        },
        nb::arg("item"), nb::arg("request"), nb::arg("attraction"), nb::arg("made"), nb::arg("edges"),
        "as printed by `setae contact solve --json`");
}

void bind_sweep(nb::module_& module) {
    using Request = answers::SweepRequest;
    nb::class_<Request> request(module, "SweepRequest");
    request.def(nb::init<>());
    bind_asked<Request, answers::BodyRequest>(request);
    bind_asked<Request, answers::InteractionRequest>(request);
    bind_asked(request);
    request.def_rw("maps", &Request::maps);
    nb::class_<Sweep>(module, "Sweep")
        .def_prop_ro("columns", [](nb::handle self) { return columns(nb::cast<const Sweep&>(self).steps, self); })
        .def_prop_ro("units", [](const Sweep& sweep) { return units(sweep.steps); })
        .def("quantities", [](const Sweep& sweep) { return texts_of(sweep.quantities); })
        .def_prop_ro("maps",
                     [](nb::handle self) {
                         nb::typed<nb::dict, nb::str, nb::typed<nb::tuple, nb::object, nb::object>> maps;
                         for (const auto& state : nb::cast<const Sweep&>(self).maps)
                             maps[state.name.c_str()] =
                                 nb::make_tuple(map_of(state.pressures, self), map_of(state.gaps, self));
                         return maps;
                     })
        .def_prop_ro("edge", [](nb::handle self) { return columns(nb::cast<const Sweep&>(self).edge, self); })
        .def("save_edge", [](const Sweep& sweep,
                             const std::string& file) { bytes::write_whole_file(file, answers::edge_csv(sweep.edge)); })
        .def_ro("json", &Sweep::json);
    module.def(
        "contact_sweep",
        [](const Item& item, const Request& asked, const answers::MadeSurfaceRequest& made, const std::string& edges) {
            return unlocked(
                [&](const std::atomic<bool>& cancelled) { return swept(item, asked, made, edges, cancelled); });
        },
        nb::arg("item"), nb::arg("request"), nb::arg("made"), nb::arg("edges"),
        "as printed by `setae contact sweep --json`");
}

void bind_front(nb::module_& module) {
    using Request = answers::FrontRequest;
    nb::class_<Request> request(module, "FrontRequest");
    request.def(nb::init<>());
    bind_asked(request);
    module.def(
        "contact_front",
        [](const Item& item, const Request& asked, const answers::MadeSurfaceRequest& made, const std::string& edges,
           int realisations) {
            return unlocked([&](const std::atomic<bool>& cancelled) {
                return front_of(item, asked, made, edges, realisations, cancelled);
            });
        },
        nb::arg("item"), nb::arg("request"), nb::arg("made"), nb::arg("edges"), nb::arg("realisations"),
        "as printed by `setae contact front --json`");
}

}  // namespace

void bind_contact(nb::module_& module) {
    bind_persson(module);
    bind_comparison(module);
    bind_made_surface(module);
    bind_solve(module);
    bind_sweep(module);
    bind_front(module);
}

}  // namespace setae::python
