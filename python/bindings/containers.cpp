// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "bindings.hpp"
#include "request.hpp"
#include "setae/answers/container_fields.hpp"
#include "setae/answers/format_list.hpp"
#include "setae/answers/json_schemas.hpp"
#include "setae/core/errors.hpp"

#include "setae/output/field_json.hpp"
#include "setae/validation/described_outputs.hpp"

namespace setae::python {

void bind_containers(nb::module_& module) {
    using Request = answers::ContainerRequest;
    nb::class_<Request> request(module, "ContainerRequest");
    request.def(nb::init<>())
        .def_rw("files", &Request::files)
        .def_rw("output", &Request::output)
        .def_rw("every_file", &Request::every_file)
        .def_rw("sizes", &Request::sizes)
        .def_rw("units", &Request::units)
        .def_rw("channels", &Request::channels)
        .def_rw("trends", &Request::trends);
    bind_asked(request);
    module.def(
        "write_container",
        [](const Request& request) {
            return unlocked([&](const auto&) {
                const auto written = answers::write_container(request);
                answers::require_written(written);
                return output::as_text(output::described(written));
            });
        },
        nb::arg("request"), "as printed by `setae container write --json`");
    module.def(
        "check_containers",
        [](const std::vector<std::string>& files) {
            return unlocked([&](const auto&) {
                answers::CheckedContainers checked;
                for (const auto& file : files)
                    checked.containers.push_back({file, formats::check_container(bytes::file_source(file))});
                return output::as_text(output::described(checked));
            });
        },
        nb::arg("files"), "as printed by `setae container check --json`");
    module.def(
        "formats", [] { return output::as_text(output::described(answers::FormatList{})); },
        "as printed by `setae formats --json`");
    module.def(
        "schema",
        [](const std::string& command) {
            return output::as_text(answers::JsonSchemas(validation::described_outputs).of(command));
        },
        nb::arg("command"), "as printed by `setae schema COMMAND`");
}

}  // namespace setae::python
