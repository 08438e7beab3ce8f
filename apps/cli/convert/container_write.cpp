// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include <fmt/format.h>

#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "setae/answers/container_fields.hpp"
#include "setae/output/field_json.hpp"

namespace setae::cli::container_write_command {
namespace {

constexpr const char* explanation =
    "The command writes measured files as a container for contact.engineering.\n"
    "\n"
    "index.json   generation C of contact.engineering\n"
    "             meta.yml repeats the content for programs that read only older generations.\n"
    "original     every file, byte for byte\n"
    "             Files that only setae reads, such as text with column names or errors, are stored twice:\n"
    "             heights as two columns or NetCDF, and the file itself as setae-source, which setae reads first.\n"
    "copy         the heights in the unit of the index as classic NetCDF, scaled once, minus the trend of detrend_mode\n"
    "             Undefined heights are NaN, with a mask.\n"
    "generations  Containers of older generations become generation C, with their full content.\n"
    "             height_scale is removed from the index where the original contains this scale.\n"
    "bytes        Members are stored without compression, dated 1980. The same input gives the same container.\n";

struct Arguments {
    Common common;
    answers::ContainerRequest request;
};

ExitCode run(const Arguments& arguments) {
    const auto written = answers::write_container(arguments.request);
    for (const auto& failure : written.failures) print_message(failure);
    answers::require_written(written);
    show(written.draft.alerts);
    if (arguments.common.json) print_json(output::described(written));
    else
        print(fmt::format("{}: surfaces {}, measurements {}\n", written.output, written.draft.container.surfaces.size(),
                          written.measurements()));
    return written.complete() ? ExitCode::done : ExitCode::some_failed;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    auto& request = arguments->request;
    options
        .add("files", request.files,
             "measured files, which become one surface, and containers, which keep their surfaces")
        .of_inputs();
    options.output("-o,--output", request.output, "container to write, OUT.zip").in(OptionGroup::required);
    options.ask(request);
    options.example("setae container write afm.ibw stylus.csv -o surface.zip --name \"my surface\"",
                    "container with two measurements of one surface");
    options.example("setae container write --from study.toml -o surfaces.zip",
                    "container with the surfaces of a study");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::container_write_command
