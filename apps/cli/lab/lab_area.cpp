// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "setae/core/errors.hpp"
#include "setae/figures/figure.hpp"
#include "setae/output/field_json.hpp"
#include "setae/roughness/true_area.hpp"
#include "setae/tables/table_file.hpp"
#include "setae/validation/true_area_of_maps.hpp"

namespace setae::cli::lab_area_command {
namespace {

constexpr const char* explanation =
    "The command compares the true area of self-affine maps with the area of Gaussian roughness (Eq. 9).\n"
    "\n"
    "maps       H = 0.3 and 0.8, three maps of each, Fourier-filtered; every map is scaled to rms slopes from 0.01 to 10\n"
    "           The shortest wave has 4 points. The spectrum is flat for waves longer than 1/16 of the map.\n"
    "A_true     area of the triangles through the heights, mean of both diagonals (Eq. S3)\n"
    "h'         sqrt<|grad h|^2> of the same triangles\n"
    "Eq. 9      A_true/A_app - 1 = (sqrt(pi)/2) h' exp(1/h'^2) erfc(1/h')\n"
    "           Limits: h'^2/2 for small h', sqrt(pi)/2 h' - 1 for large h'.\n"
    "deviation  (A_true/A_app - 1) over its value of Eq. 9, minus 1; mean over maps with standard error (Fig. S7)\n"
    "\n"
    "Equation and figure numbers: Dalvi et al., PNAS 116 (2019) 25484 [D19].\n";

struct AreaArguments {
    Common common;
    std::string output = "area";
    Index points = 4096;
    std::uint64_t seed = 1;
};

constexpr std::array asked{
    fields::option<&AreaArguments::points>("points", "number of points along each side of a map")
        .between(128, 32768)
        .default_shown(),
    fields::option<&AreaArguments::seed>("seed", "seed of the maps").default_shown(),
};

using validation::maps_each;

ExitCode run(const AreaArguments& arguments) {
    const auto areas = validation::true_area_of_maps(
        {.points = arguments.points, .seed = arguments.seed, .threads = arguments.common.workers()});
    const auto rows = validation::means(areas);
    std::error_code ignored;
    std::filesystem::create_directories(arguments.output, ignored);
    const auto path = [&](const char* name) { return (std::filesystem::path(arguments.output) / name).string(); };
    tables::write_csv(path("area.csv"), validation::area_table(areas));
    const validation::AreaOutput found{arguments.points, arguments.seed, arguments.output, rows};
    if (arguments.common.json) {
        print_json(output::described(found));
    } else {
        std::string text =
            fmt::format("{:>4} {:>6}  {:>12} {:>12}  deviation [%]\n", "H", "h'", "excess area", "Eq. 9");
        for (const auto& row : rows)
            text += fmt::format("{:>4} {:>6}  {:>12.6g} {:>12.6g}  {:>7.4f} ± {:.4f}\n", row.hurst_exponent,
                                row.rms_slope, row.excess_area, roughness::gaussian_area_ratio(row.rms_slope) - 1.0,
                                100.0 * row.deviation, 100.0 * row.standard_error);
        print(text + fmt::format("{0} x {0} points, {1} maps each, seed {2}: within {3:.2g} % of Eq. 9; {4}\n",
                                 arguments.points, maps_each, arguments.seed, 100.0 * found.largest_deviation(),
                                 arguments.output));
    }
    const auto figure = validation::area_figure(rows);
    // the numbers are written even if the figure cannot be drawn
    return for_each_item({"area.svg", "area.png", "area.pdf"},
                         [&](const std::string& name) { figures::draw(figure, path(name.c_str())); }) == ExitCode::done
               ? ExitCode::done
               : ExitCode::some_failed;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<AreaArguments>();
    options.output("-o,--output", arguments->output, "folder of area.csv and the figure").default_shown();
    options.ask(asked, arguments.get());
    options.example("setae lab area -o area", "true area of random maps, compared with Eq. 9");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::lab_area_command
