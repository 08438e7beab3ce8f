// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/half_space/interaction.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "row_passes.hpp"
#include "setae/core/errors.hpp"

namespace setae::half_space {
namespace {

constexpr std::array<std::pair<std::string_view, AttractionLaw>, 4> names{
    {{"exponential", AttractionLaw::exponential},
     {"cubic", AttractionLaw::cubic},
     {"dugdale", AttractionLaw::dugdale},
     {"lennard_jones", AttractionLaw::lennard_jones}}};

/// Writes factor · values where somebody wants them.
template <class Expression>
void put(double* to, Index points, const Expression& values) {
    if (to) Row(to, points) = values;
}

void exponential(ConstRow g, const Interaction& law, double* energies, double* tensions, double* slopes) {
    const Index n = g.size();
    double* decays = energies ? energies : tensions ? tensions : slopes;
    Row decay(decays, n);
    decay = (g * (-1.0 / law.range)).exp();
    // each from the decay, the one that holds it last
    if (decays != slopes) put(slopes, n, (-law.greatest_tension() / law.range) * decay);
    if (decays != tensions) put(tensions, n, law.greatest_tension() * decay);
    if (decays == energies) decay *= -law.work_of_adhesion;
    else if (decays == tensions) decay *= law.greatest_tension();
    else decay *= -law.greatest_tension() / law.range;
}

void cubic(ConstRow g, const Interaction& law, double* energies, double* tensions, double* slopes) {
    const Index n = g.size();
    const double end = 3.0 * law.range, tension = law.greatest_tension();
    const auto left = [&] { return (1.0 - g * (1.0 / end)).max(0.0); };
    put(energies, n, -law.work_of_adhesion * left().cube());
    put(tensions, n, tension * left().square());
    put(slopes, n, (-2.0 * tension / end) * left());
}

void dugdale(ConstRow g, const Interaction& law, double* energies, double* tensions, double* slopes) {
    const Index n = g.size();
    put(energies, n, -law.work_of_adhesion * (1.0 - g * (1.0 / law.range)).max(0.0));
    put(tensions, n, (g < law.range).select(Array1D::Constant(n, law.greatest_tension()), 0.0));
    put(slopes, n, Array1D::Zero(n));
}

void lennard_jones(ConstRow g, const Interaction& law, double* energies, double* tensions, double* slopes) {
    const Index n = g.size();
    const double length = 2.0 * law.range;
    const auto inverse = [&] { return (1.0 + g * (1.0 / length)).inverse(); };
    put(energies, n, -law.work_of_adhesion * inverse().square());
    put(tensions, n, law.greatest_tension() * inverse().cube());
    put(slopes, n, (-3.0 * law.greatest_tension() / length) * inverse().square().square());
}

double longest_side(const Grid& grid) {
    return std::max(grid.nx > 1 ? grid.pixel_x() : 0.0, grid.ny > 1 ? grid.pixel_y() : 0.0);
}

}  // namespace

AttractionLaw attraction_law_named(std::string_view name) {
    for (const auto& [text, law] : names)
        if (text == name) return law;
    throw InvalidArgument(
        fmt::format("'{}' is no law of attraction; expected exponential, cubic, dugdale or lennard_jones", name));
}

std::string name_of(AttractionLaw law) {
    for (const auto& [text, of] : names)
        if (of == law) return std::string(text);
    throw InternalError("a law of attraction without a name");
}

void attraction(Index points, const double* gaps, const Interaction& interaction, double* energies, double* tensions,
                double* slopes) {
    if (!energies && !tensions && !slopes) return;
    const ConstRow g(gaps, points);
    switch (interaction.law) {
        case AttractionLaw::exponential: return exponential(g, interaction, energies, tensions, slopes);
        case AttractionLaw::cubic: return cubic(g, interaction, energies, tensions, slopes);
        case AttractionLaw::dugdale: return dugdale(g, interaction, energies, tensions, slopes);
        case AttractionLaw::lennard_jones: return lennard_jones(g, interaction, energies, tensions, slopes);
    }
}

Attraction attraction(double gap, const Interaction& interaction) {
    Attraction result;
    attraction(1, &gap, interaction, &result.energy, &result.tension, &result.slope);
    return result;
}

Resolution resolution_of(const Interaction& interaction, const Body& body, const Grid& grid) {
    const double per_pixel =
        interaction.work_of_adhesion / (body.contact_modulus * interaction.range * interaction.range);
    return {.squared_ratio = per_pixel * longest_side(grid),
            .pixel_of_warning = 0.5 / per_pixel,
            .pixel_of_refusal = 1.0 / per_pixel};
}

void require(const Interaction& interaction, const Body& body, const Grid& grid) {
    const auto positive = [](double value) { return value > 0.0 && std::isfinite(value); };
    if (!positive(interaction.work_of_adhesion))
        throw InvalidArgument(fmt::format("work of adhesion is {} J/m2, expected > 0", interaction.work_of_adhesion));
    if (!positive(interaction.range))
        throw InvalidArgument(fmt::format("range of attraction is {} m, expected > 0", interaction.range));
    const auto resolution = resolution_of(interaction, body, grid);
    if (resolution.squared_ratio <= 1.0 + 1e-9) return;
    const double factor = longest_side(grid) / resolution.pixel_of_refusal;
    throw InvalidArgument(fmt::format(
        "pixels of {:.3g} m are too coarse for an attraction of range {:.3g} m (w dx/(E* rho^2) = {:.3g}, at most 1): "
        "edges would be caught between them; expected pixels of {:.3g} m, {} x {} points, better half of that, or a "
        "longer range",
        longest_side(grid), interaction.range, resolution.squared_ratio, resolution.pixel_of_refusal,
        grid.nx > 1 ? static_cast<Index>(std::ceil(static_cast<double>(grid.nx) * factor)) : 1,
        grid.ny > 1 ? static_cast<Index>(std::ceil(static_cast<double>(grid.ny) * factor)) : 1));
}

}  // namespace setae::half_space
