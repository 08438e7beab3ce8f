// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings.hpp"
#include "setae/core/uncertain_text.hpp"
#include "setae/core/units.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/study/provenance.hpp"

namespace {

/// Content of the module at its first import. C++ types are registered once per process: a program that removes setae
/// from sys.modules and imports it again gets the same types.
nanobind::dict* first_content = nullptr;

/// Called at the end of the interpreter. Threads that never end keep their results, which is no leak of setae.
void release_module() {
    const auto threads = nanobind::cast<int>(nanobind::module_::import_("threading").attr("active_count")());
    if (setae::python::end_running_calls() || threads > 1) nanobind::set_leak_warnings(false);
    delete first_content;
    first_content = nullptr;
}

}  // namespace

NB_MODULE(_setae, module) {
    using namespace setae;
    if (first_content) {
        auto content = nanobind::cast<nanobind::dict>(module.attr("__dict__"));
        for (const auto [name, value] : *first_content)
            if (!content.contains(name)) content[name] = value;
        return;
    }
    nanobind::module_::import_("atexit").attr("register")(nanobind::cpp_function(release_module));
    const auto os = nanobind::module_::import_("os");
    if (nanobind::hasattr(os, "register_at_fork"))
        os.attr("register_at_fork")(nanobind::arg("after_in_child") =
                                        nanobind::cpp_function(setae::python::forget_running_calls));
    module.doc() = "libraries of setae; use the package setae";
    nanobind::set_leak_warnings(true);
    python::bind_errors(module);
    python::bind_heights(module);
    python::bind_surfaces(module);
    python::bind_loops(module);
    python::bind_synthesis(module);
    python::bind_contact(module);
    python::bind_laboratory(module);
    python::bind_containers(module);
    python::bind_studies(module);
    python::bind_models(module);
    module.def("version", &study::version, "release and digest of the build, such as '0.1.0+4f1c09ab'");
    module.def(
        "limit_threads", [](int count) { parallel::limit_threads({count}); }, nanobind::arg("count"),
        "number of threads of later computations; 0: one per core");
    module.def(
        "length_factor", [](const std::string& unit) { return unit_factor(unit, dimension::length); },
        nanobind::arg("unit"), "metres in a unit of length");
    module.def(
        "format_uncertain",
        [](double value, double standard_error, const std::string& unit) {
            return format_uncertain({.value = value, .standard_error = standard_error}, unit);
        },
        nanobind::arg("value"), nanobind::arg("standard_error"), nanobind::arg("unit"),
        "text such as '37.0 ± 3.7 mJ/m²' for a number in SI");
    first_content = new nanobind::dict();
    for (const auto [name, value] : nanobind::cast<nanobind::dict>(module.attr("__dict__")))
        (*first_content)[name] = value;
}
