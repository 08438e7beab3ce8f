// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "convert/heights_output.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "program/terminal.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/summation.hpp"
#include "setae/output/quantity_table.hpp"
#include "setae/synthesis/random_surface.hpp"
#include "synthesize/synthesis_options.hpp"

namespace setae::cli::synthesize_command {
namespace {

constexpr const char* explanation =
    "C_iso(q)   = C_0 for q < q_r, C_0 (q/q_r)^(-2-2H) up to q_s, 0 above; q = 2 pi/wavelength       [J17]\n"
    "C1D(q_x)   = (1/pi) int_{q_x}^{q_s} C_iso q dq/sqrt(q^2 - q_x^2): lines on that surface\n"
    "h(x)       = sum_q c_q exp(iqx), <|c_q|^2> = C_iso/A; c_q complex normal, or random phases alone (--amplitudes exact)\n"
    "spectrum   h_rms^2 = sum_q C/A and h'^2 = sum_q q^2 C/A over the modes of the grid\n"
    "made       h_rms of the heights written; slopes from differences of neighbouring heights\n"
    "--skewness, --kurtosis: heights a function of Gaussian ones (Johnson 1949) whose spectrum makes up for it\n"
    "The random number of a mode belongs to the seed and its mode numbers: more pixels over the same size show the same\n"
    "surface with more modes.\n";

struct Arguments {
    Common common;
    SynthesisOptions options;
    std::string output;
};

/// Root mean square of heights about their mean and of forward differences over a pixel.
struct MadeRoughness {
    double rms_height, rms_slope;
};

MadeRoughness measured(const topography::HeightMap& map) {
    const auto [nx, ny] = map.shape();
    const auto pixel = map.pixel_size();
    const auto mean_over_rows = [](Index rows, const auto& of_row) {
        Array1D means(rows);
        for (Index i = 0; i < rows; ++i) means[i] = of_row(i);
        return pairwise_sum(means) / static_cast<double>(rows);
    };
    const auto& h = map.heights;
    const double mean = mean_over_rows(nx, [&](Index i) { return h.row(i).mean(); });
    const double square = mean_over_rows(nx, [&](Index i) { return (h.row(i) - mean).square().mean(); });
    const double along_x = mean_over_rows(nx - 1, [&](Index i) { return (h.row(i + 1) - h.row(i)).square().mean(); });
    const double along_y =
        mean_over_rows(nx, [&](Index i) { return (h.row(i).tail(ny - 1) - h.row(i).head(ny - 1)).square().mean(); });
    return {std::sqrt(square), std::sqrt(along_x / (pixel[0] * pixel[0]) + along_y / (pixel[1] * pixel[1]))};
}

MadeRoughness measured(const topography::LineScan& scan) {
    const auto& h = scan.heights;
    const Array1D squares = (h - pairwise_sum(h) / static_cast<double>(h.size())).square();
    const Array1D slopes = ((h.tail(h.size() - 1) - h.head(h.size() - 1)) / scan.pixel_size()).square();
    return {std::sqrt(pairwise_sum(squares) / static_cast<double>(h.size())),
            std::sqrt(pairwise_sum(slopes) / static_cast<double>(slopes.size()))};
}

ExitCode run(const Arguments& arguments) {
    if (arguments.output.empty()) throw InvalidArgument("expected -o OUT with an ending " + endings_of_heights());
    require_heights_ending(arguments.output);
    const auto plan = arguments.options.plan(arguments.common.workers());
    const auto expected = plan.expected();
    const auto measurement = plan.make();
    write_heights(arguments.output, measurement);
    const auto made = std::holds_alternative<topography::HeightMap>(measurement)
                          ? measured(std::get<topography::HeightMap>(measurement))
                          : measured(std::get<topography::LineScan>(measurement));
    const std::vector<Quantity> quantities{
        output::quantity("rms_height_of_spectrum", "h_rms", expected.rms_height, "m"),
        output::quantity("rms_slope_of_spectrum", "h'_rms", expected.rms_slope, "1"),
        output::quantity("rms_height_made", "h_rms", made.rms_height, "m"),
        output::quantity("rms_slope_made", "h'_rms", made.rms_slope, "1")};
    const auto points = topography::shape(measurement);
    if (!arguments.common.json) {
        const auto title = fmt::format("{}: {} x {} points", arguments.output, points[0], points[1]);
        print(output::quantity_table(title, quantities, output_size().width));
        show(plan.alerts);
        return ExitCode::done;
    }
    output::Json json{
        {"output", arguments.output}, {"points", points}, {"periodic", !plan.window}, {"seed", plan.options.key.seed}};
    if (const auto* map = std::get_if<topography::HeightMap>(&measurement)) json["size"] = map->size;
    else json["size"] = std::get<topography::LineScan>(measurement).size;
    for (const auto& q : quantities) json["quantities"].push_back(output::to_json(q));
    if (!plan.alerts.empty()) json["alerts"] = output::to_json(plan.alerts);
    print_json(json);
    return ExitCode::done;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    arguments->options.add_to(options);
    options.add("-o,--output", arguments->output, "OUT.x3p, .sdf, .gwy, .nc, .npy, .txt or .csv");
    options.example(
        "setae synthesize --hurst 0.8 --rolloff \"2 um\" --short-cutoff \"20 nm\" --rms-height \"20 nm\" --size \"10 um\" -o map.x3p",
        "a self-affine map");
    options.example("setae synthesize spectrum.csv --size \"5 um\" --pixels 1024 -o map.gwy",
                    "a map with the spectrum of a table");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::synthesize_command
