// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/texture/texture_parameter.hpp"

namespace setae::texture {
namespace {

constexpr auto areal = Standard::iso25178;
constexpr auto profile = Standard::iso21920;

constexpr std::string_view moments = "sine, triangle, step, parabola; surfalize";
constexpr std::string_view curve = "ramp, sine, Gaussian quantiles, plateau with holes; surfalize on points";
constexpr std::string_view features = "crossed cosines; surfalize";
constexpr std::string_view line_moments = "sine, triangle, step, parabola; evaluated by an instrument (mitutoyo_2)";
constexpr std::string_view sections_of_steps = "sections of steps; instrument (mitutoyo_2)";
constexpr std::string_view line_curve = "as Sk: the same code on segments";

constexpr std::array table{
    ParameterDefinition{"Sq", "root_mean_square_height", "sqrt(<z^2>), z = h - <h>", "m", areal, "4.2", moments},
    ParameterDefinition{"Ssk", "skewness", "<z^3>/Sq^3", "1", areal, "4.2", moments},
    ParameterDefinition{"Sku", "kurtosis", "<z^4>/Sq^4; 3 for a Gaussian", "1", areal, "4.2", moments},
    ParameterDefinition{"Sp", "maximum_peak_height", "max z", "m", areal, "4.2", moments},
    ParameterDefinition{"Sv", "maximum_pit_depth", "-min z", "m", areal, "4.2", moments},
    ParameterDefinition{"Sz", "maximum_height", "Sp + Sv", "m", areal, "4.2", moments},
    ParameterDefinition{"Sa", "arithmetic_mean_height", "<|z|>", "m", areal, "4.2", moments},
    ParameterDefinition{"Sal", "autocorrelation_length", "shortest lag |t| with f(t) <= 0.2, f = <z(x) z(x + t)>/<z^2>",
                        "m", areal, "4.3", "crossed cosines, Gaussian autocorrelation; surfalize to its steps"},
    ParameterDefinition{"Str", "texture_aspect_ratio", "Sal over the longest lag on the rim of f > 0.2", "1", areal,
                        "4.3", "crossed cosines, Gaussian autocorrelation; surfalize to its steps"},
    ParameterDefinition{
        "Std", "texture_direction",
        "direction of the lay against x: across the waves with the largest angular spectrum int q C2D dq", "rad", areal,
        "4.3", "gratings in four directions"},
    ParameterDefinition{"Sdq", "root_mean_square_gradient", "sqrt(<z_x^2> + <z_y^2>), differences over one pixel", "1",
                        areal, "4.4", "plane, cosine; surfalize"},
    ParameterDefinition{
        "Sdr", "developed_interfacial_area_ratio",
        "area of the triangles through the points, both diagonals averaged, over projected area, minus 1", "1", areal,
        "4.4, D.3", "plane; surfalize"},
    ParameterDefinition{"Sdq_c", "root_mean_square_gradient_central",
                        "sqrt(<z_x^2 + z_y^2>), differences over two pixels", "1", areal, "4.4", "plane, cosine"},
    ParameterDefinition{"Sdr_c", "developed_interfacial_area_ratio_central",
                        "<sqrt(1 + z_x^2 + z_y^2)> - 1, differences over two pixels", "1", areal, "4.4", "plane"},
    ParameterDefinition{"Smr(c)", "material_ratio", "P(c): share of the area at or above height c over the mean", "1",
                        areal, "4.5", "SurfaceTopography bearing_area to 1e-10; plateaus, plane"},
    ParameterDefinition{"Smc(p)", "inverse_material_ratio", "H(p): greatest height with P >= p", "m", areal, "4.5",
                        "inverse of Smr(c) to 1e-12; SurfaceTopography median"},
    ParameterDefinition{"Sdc", "material_ratio_height_difference", "H(2 %) - H(98 %)", "m", areal, "4.5", curve},
    ParameterDefinition{"Sxp", "peak_extreme_height", "H(2.5 %) - H(50 %)", "m", areal, "4.5", curve},
    ParameterDefinition{
        "Sk", "core_height",
        "c1 - c2: heights at 0 and 100 % of the line through the flattest 40 % of the material ratio curve", "m", areal,
        "4.5, B", curve},
    ParameterDefinition{"Spk", "reduced_peak_height", "2/Smrk1 int_c1^inf P dh", "m", areal, "4.5, B", curve},
    ParameterDefinition{"Svk", "reduced_pit_depth", "2/(1 - Smrk2) int_-inf^c2 (1 - P) dh", "m", areal, "4.5, B",
                        curve},
    ParameterDefinition{"Smrk1", "peak_material_ratio", "P(c1)", "1", areal, "4.5, B", curve},
    ParameterDefinition{"Smrk2", "pit_material_ratio", "P(c2)", "1", areal, "4.5, B", curve},
    ParameterDefinition{"Spkx", "maximum_peak_over_core", "highest point over c1", "m", areal, "4.5, B", curve},
    ParameterDefinition{"Svkx", "maximum_pit_below_core", "deepest point below c2", "m", areal, "4.5, B", curve},
    ParameterDefinition{"Sak1", "peak_volume_over_core", "int_c1^inf P dh", "m", areal, "4.5, B", curve},
    ParameterDefinition{"Sak2", "pit_volume_below_core", "int_-inf^c2 (1 - P) dh", "m", areal, "4.5, B", curve},
    ParameterDefinition{"Vmp", "peak_material_volume", "Vm(10 %), Vm(p) = int_H(p)^inf P dh", "m", areal, "4.5", curve},
    ParameterDefinition{"Vmc", "core_material_volume", "Vm(80 %) - Vm(10 %)", "m", areal, "4.5", curve},
    ParameterDefinition{"Vvc", "core_void_volume", "Vv(10 %) - Vv(80 %), Vv(p) = int_-inf^H(p) (1 - P) dh", "m", areal,
                        "4.5", curve},
    ParameterDefinition{"Vvv", "pit_void_volume", "Vv(80 %)", "m", areal, "4.5", curve},
    ParameterDefinition{"Spd", "peak_density",
                        "significant hills per unit area; watersheds, Wolf pruning at 5 % of Sz, hills at edges left "
                        "out",
                        "1/m2", areal, "5", features},
    ParameterDefinition{"Svd", "pit_density", "significant dales per unit area", "1/m2", areal, "5", features},
    ParameterDefinition{"Spc", "mean_peak_curvature", "mean of -1/2 (z_xx + z_yy) at significant peaks", "1/m", areal,
                        "5", features},
    ParameterDefinition{"Svc", "mean_pit_curvature", "mean of -1/2 (z_xx + z_yy) at significant pits", "1/m", areal,
                        "5", features},
    ParameterDefinition{"S5p", "five_point_peak_height", "mean of the five highest significant peaks", "m", areal, "5",
                        features},
    ParameterDefinition{"S5v", "five_point_pit_depth", "mean of the five deepest significant pits", "m", areal, "5",
                        features},
    ParameterDefinition{"S10z", "ten_point_height", "S5p + S5v", "m", areal, "5", features},

    ParameterDefinition{"Rq", "root_mean_square_height", "sqrt(<z^2>), z = h - <h>; polylines: exact integrals", "m",
                        profile, "4.2.3", line_moments},
    ParameterDefinition{"Rsk", "skewness", "<z^3>/Rq^3", "1", profile, "4.2.4", line_moments},
    ParameterDefinition{"Rku", "kurtosis", "<z^4>/Rq^4", "1", profile, "4.2.5", line_moments},
    ParameterDefinition{"Ra", "arithmetic_mean_height", "<|z|>; polylines: segments split at the mean line", "m",
                        profile, "4.2.2", line_moments},
    ParameterDefinition{"Rt", "total_height", "max z - min z over the evaluation length", "m", profile, "4.2.6",
                        "sine, triangle; instrument (mitutoyo_2)"},
    ParameterDefinition{"Rp", "mean_peak_height", "mean over sections of max z", "m", profile, "5.1.3",
                        sections_of_steps},
    ParameterDefinition{"Rv", "mean_pit_depth", "mean over sections of -min z", "m", profile, "5.1.5",
                        sections_of_steps},
    ParameterDefinition{"Rz", "maximum_height", "mean over sections of max z - min z", "m", profile, "5.1",
                        sections_of_steps},
    ParameterDefinition{"Rzx", "largest_section_height", "largest of the sections' max z - min z", "m", profile,
                        "4.2.7", sections_of_steps},
    ParameterDefinition{"RSm", "mean_element_spacing",
                        "mean length of profile elements by crossing the line, 10 % height discrimination", "m",
                        profile, "5", "sine, noise on a sine; instrument (mitutoyo_2)"},
    ParameterDefinition{"RSmq", "element_spacing_deviation", "rms deviation of the elements' lengths", "m", profile,
                        "5", "sine"},
    ParameterDefinition{"Rc", "mean_element_height", "mean height of profile elements", "m", profile, "5",
                        "sine; instrument (mitutoyo_2)"},
    ParameterDefinition{"Rcq", "element_height_deviation", "rms deviation of the elements' heights", "m", profile, "5",
                        "sine"},
    ParameterDefinition{"Rdq", "root_mean_square_slope", "sqrt(<z'^2>), seven-point slopes; polylines: of segments",
                        "1", profile, "4.4.2", "line, cosine by its symbol; instrument (mitutoyo_2)"},
    ParameterDefinition{"Rda", "mean_absolute_slope", "<|z'|>", "1", profile, "4.4.3", "line, triangle"},
    ParameterDefinition{"Rdq_2", "root_mean_square_slope_of_neighbours", "sqrt(<z'^2>), differences of neighbours", "1",
                        profile, "4.4.2", "SurfaceTopography to 1e-10"},
    ParameterDefinition{"Rdt", "maximum_absolute_slope", "max |z'|, seven-point slopes; polylines: of segments", "1",
                        profile, "4.4.4", "line, cosine"},
    ParameterDefinition{"Rdl", "developed_length", "sum of sqrt(dx^2 + dz^2) over segments", "m", profile, "4.4.5",
                        "line, triangle"},
    ParameterDefinition{"Rdr", "developed_length_ratio", "Rdl over the length, minus 1", "1", profile, "4.4.6",
                        "line, triangle"},
    ParameterDefinition{"Ral", "autocorrelation_length",
                        "shortest lag t with f(t) <= 0.2, f = <z(x) z(x + t)>/<z^2>; only for equal steps", "m",
                        profile, "4.3.2", "cosine"},
    ParameterDefinition{"Rmr(c)", "material_ratio", "P(c): share of the length at or above height c over the mean line",
                        "1", profile, "4.5.1", "SurfaceTopography bearing_area to 1e-10; plateaus"},
    ParameterDefinition{"Rmc(p)", "inverse_material_ratio", "H(p)", "m", profile, "4.5.1",
                        "inverse of Rmr(c) to 1e-12"},
    ParameterDefinition{"Rdc", "material_ratio_height_difference", "H(2 %) - H(98 %)", "m", profile, "4.5.2",
                        line_curve},
    ParameterDefinition{"Rk", "core_height", "as Sk", "m", profile, "4.5.3", line_curve},
    ParameterDefinition{"Rpk", "reduced_peak_height", "as Spk", "m", profile, "4.5.3", line_curve},
    ParameterDefinition{"Rvk", "reduced_pit_depth", "as Svk", "m", profile, "4.5.3", line_curve},
    ParameterDefinition{"Rmrk1", "peak_material_ratio", "P(c1)", "1", profile, "4.5.3", line_curve},
    ParameterDefinition{"Rmrk2", "pit_material_ratio", "P(c2)", "1", profile, "4.5.3", line_curve},
    ParameterDefinition{"Rak1", "peak_area_over_core", "int_c1^inf P dh", "m", profile, "4.5.3", line_curve},
    ParameterDefinition{"Rpkx", "maximum_peak_over_core", "highest point over c1", "m", profile, "4.5.3", line_curve},
    ParameterDefinition{"Rvkx", "maximum_pit_below_core", "deepest point below c2", "m", profile, "4.5.3", line_curve},
    ParameterDefinition{"Rvmp", "peak_material_volume", "as Vmp, with an area per unit length", "m", profile, "4.5.5",
                        line_curve},
    ParameterDefinition{"Rvmc", "core_material_volume", "as Vmc", "m", profile, "4.5.5", line_curve},
    ParameterDefinition{"Rvvc", "core_void_volume", "as Vvc", "m", profile, "4.5.5", line_curve},
    ParameterDefinition{"Rvvv", "pit_void_volume", "as Vvv", "m", profile, "4.5.5", line_curve},
    ParameterDefinition{"Rak2", "pit_area_below_core", "int_-inf^c2 (1 - P) dh", "m", profile, "4.5.3", line_curve},
};

}  // namespace

std::span<const ParameterDefinition> parameters() { return table; }

const ParameterDefinition& parameter(std::string_view symbol) {
    std::vector<std::string> symbols;
    for (const auto& row : table) {
        if (row.symbol == symbol) return row;
        symbols.emplace_back(row.symbol);
    }
    const auto nearest = nearest_match(symbol, symbols);
    throw InvalidArgument(fmt::format("unknown parameter \"{}\"{}", symbol,
                                      nearest.empty() ? std::string() : fmt::format("; did you mean {}?", nearest)));
}

std::vector<std::string> chosen_parameters(std::string_view text, Standard standard, char letter) {
    constexpr auto separators = ", \t";
    std::vector<std::string> found;
    for (auto begin = text.find_first_not_of(separators); begin != text.npos;) {
        const auto end = std::min(text.find_first_of(separators, begin), text.size());
        const auto word = text.substr(begin, end - begin);
        std::vector<std::string> symbols;
        const ParameterDefinition* definition = nullptr;
        for (const auto& row : table) {
            if (row.standard != standard) continue;
            auto symbol = std::string(row.symbol);
            if (standard == Standard::iso21920) symbol[0] = letter;
            if (symbol == word || row.name == word) definition = &row;
            symbols.push_back(std::move(symbol));
        }
        if (!definition) {
            const auto nearest = nearest_match(word, symbols);
            throw InvalidArgument(fmt::format(
                "{} has no parameter \"{}\"; {}", standard == Standard::iso25178 ? "iso25178" : "iso21920", word,
                nearest.empty() ? fmt::format("expected one or more of {}", fmt::join(symbols, ", "))
                                : fmt::format("did you mean {}?", nearest)));
        }
        found.emplace_back(definition->symbol);
        begin = text.find_first_not_of(separators, end);
    }
    if (found.empty()) throw InvalidArgument("no parameter is chosen; give symbols such as \"Sq, Sdr\"");
    return found;
}

}  // namespace setae::texture
