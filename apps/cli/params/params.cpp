// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "params/parameter_text.hpp"
#include "params/texture_options.hpp"
#include "plot/figure_output.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/pages.hpp"
#include "program/print_json.hpp"
#include "program/terminal.hpp"
#include "psd/surface_options.hpp"
#include "setae/answers/parameters.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/file_figures/parameter_figure.hpp"
#include "setae/output/field_json.hpp"
#include "setae/output/quantity_table.hpp"

namespace setae::cli::params_command {
namespace {

constexpr const char* explanation =
    "The command computes roughness parameters from heights and from the spectrum.\n"
    "\n"
    "From heights, unfiltered:\n"
    "Rq, Sq       root mean square of heights about their mean\n"
    "Rdq, Sdq     root mean square of forward differences; of maps |grad h|\n"
    "Rddq         root mean square of second differences; of maps half the Laplacian\n"
    "A_true/A_app area of the triangles through the heights over the projected area (Eq. S3)\n"
    "\n"
    "From the spectrum:\n"
    "h_rms^2      = (1/pi) int C1D dq [J17]\n"
    "h'_rms^2     = (2/pi) int q^2 C1D dq, exact for isotropic surfaces\n"
    "h''_rms^2    = (2/(3 pi)) int q^4 C1D dq, of half the Laplacian, exact for isotropic surfaces\n"
    "A_true/A_app = 1 + sqrt(pi)/2 h' exp(1/h'^2) erfc(1/h') (Eq. 9)\n"
    "U_el/(A E*)  = (1/8) int q C1D dq (Eq. 8)\n"
    "\n"
    "The modes of one measurement are summed. Each mode represents an interval of wavevectors, so that the waves of a\n"
    "measurement of length L begin at 2 L. The waves of an average of several measurements begin at L.\n"
    "\n"
    "--standard gives the parameters of ISO 25178-2 or ISO 21920-2. docs/reference/parameters.md contains their formulas.\n"
    "Equation numbers: Dalvi et al., PNAS 116 (2019) 25484 [D19].\n"
    "[J17] Jacobs, Junge, Pastewka, Surf. Topogr. 5 (2017) 013001.\n";

struct Arguments {
    Common common;
    SurfaceOptions surface;
    TextureOptions texture;
    std::string output, documentation;
    FigureOption figure;
};

struct Origin {
    const char *suffix, *title;
};

/// The origin at the end of the name of a quantity; nothing for quantities from heights.
std::optional<Origin> origin_of(const Quantity& quantity) {
    constexpr Origin origins[]{{"_from_spectrum", ", from the spectrum"},
                               {"_from_spectrum_eq11", ", from the spectrum by [D19] Eq. 11"},
                               {"_from_spectrum_exact", ", from the spectrum, exact"}};
    for (const auto& origin : origins)
        if (quantity.quantity.ends_with(origin.suffix)) return origin;
    return std::nullopt;
}

/// One table of quantities per origin. The title contains the origin, which the names then omit. The first line is the
/// purpose of the quantities.
std::string tables_of(const std::string& title, const std::vector<Quantity>& list, std::size_t width,
                      const std::string& purpose) {
    std::vector<std::pair<std::string, std::vector<Quantity>>> parts;
    for (auto quantity : list) {
        const auto origin = origin_of(quantity);
        const auto part_title = title + (origin ? origin->title : "");
        if (origin) quantity.quantity.resize(quantity.quantity.size() - std::string_view(origin->suffix).size());
        if (parts.empty() || parts.back().first != part_title) parts.push_back({part_title, {}});
        parts.back().second.push_back(std::move(quantity));
    }
    std::string text = fmt::format("[{}]\n", purpose);
    for (const auto& [part_title, quantities] : parts)
        text += output::quantity_table(part_title, quantities, width) + "\n";
    return text;
}

/// Parameters of a standard, measurement by measurement.
ExitCode run_standard(const Arguments& arguments) {
    const auto answer = answers::texture_of(arguments.surface.surface(), arguments.texture, arguments.common.workers());
    for (const auto& failure : answer.failures) print_message(failure);
    if (answer.list.empty()) return ExitCode::nothing_done;
    const auto others = show_reading_warnings(answer.alerts);
    if (arguments.common.json || arguments.texture.format == "json")
        print_json(output::described(answers::texture_entries(answer)));
    else print(parameter_text(answer.list, arguments.texture.format, output_size().width));
    show(others);
    return answer.failures.empty() ? ExitCode::done : ExitCode::some_failed;
}

ExitCode write_documentation(const std::string& path) {
    const auto existing = std::filesystem::exists(path) ? bytes::read_back(path) : std::string();
    write_page(path, parameter_page(existing));
    print(path + "\n");
    return ExitCode::done;
}

ExitCode run(const Arguments& arguments) {
    if (!arguments.documentation.empty()) return write_documentation(arguments.documentation);
    if (arguments.texture.asked() && !arguments.output.empty())
        throw InvalidArgument("--output draws the parameters of the spectrum; leave it out with --standard");
    if (arguments.texture.asked()) return run_standard(arguments);
    if (!arguments.output.empty() && !file_figures::is_figure_path(arguments.output))
        throw InvalidArgument(
            fmt::format("{}: cannot tell the format from the name; expected an ending {}; --json writes the numbers",
                        arguments.output, file_figures::figure_endings));
    const auto parameters = answers::parameters(
        {.surface = arguments.surface.surface(), .analysis = arguments.surface.analysis()}, arguments.common.workers());
    const auto& surface = parameters.surface;
    const auto code = report_failures(surface);
    if (code == ExitCode::nothing_done) return code;
    const auto others = show_reading_warnings(answers::alerts_of(surface));
    if (!arguments.common.json) {
        print(answers::headline_text(parameters) + "\n");
        for (const auto& group : parameters.groups) {
            const bool named = !group.name.empty() && group.name != group.file;
            print(tables_of(group.file + (named ? " (" + group.name + ")" : ""), group.quantities, output_size().width,
                            group.purpose));
        }
    }
    if (!arguments.output.empty())
        write_figure(file_figures::parameter_figure(surface, arguments.figure.look()), arguments.output,
                     arguments.common.json);
    if (arguments.common.json) print_json(output::described(answers::parameter_entries(parameters)));
    show(others);
    return code;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    arguments->surface.add_to(options);
    arguments->texture.add_to(options);
    options.output(
        "-o,--output", arguments->output,
        "figure OUT.svg, .pdf or .png: contributions of wavelengths to height, slope, curvature and stored energy");
    arguments->figure.add_to(options);
    options
        .add("--documentation", arguments->documentation,
             "file for the documentation page of the parameters of standards")
        .in(OptionGroup::advanced);
    options.example("setae params afm.ibw --tip-radius \"10 nm\"", "parameters from heights and from the spectrum");
    options.example("setae params stylus.csv afm.ibw -o params.svg",
                    "figure of the contributions of wavelengths to height, slope, curvature and stored energy");
    options.example("setae params map.sur --standard iso25178 --s-filter 2.5um --l-filter 0.8mm",
                    "parameters of ISO 25178-2, with S-filter and L-filter");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::params_command
