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

/// For every law one number per gap determines V = −w e(b), V' = σ t(b), V'' = −σ/ρ s(b).
struct Exponential {
    static auto base(const auto& g, double range) { return (g * (-1.0 / range)).exp(); }
    static auto energy(const auto& b) { return b + 0.0; }
    static auto tension(const auto& b) { return b + 0.0; }
    static auto slope(const auto& b) { return b + 0.0; }
};

struct Cubic {
    static auto base(const auto& g, double range) { return (1.0 - g * (1.0 / (3.0 * range))).max(0.0); }
    static auto energy(const auto& b) { return b.cube(); }
    static auto tension(const auto& b) { return b.square(); }
    static auto slope(const auto& b) { return (2.0 / 3.0) * b; }
};

struct Dugdale {
    static auto base(const auto& g, double range) { return (1.0 - g * (1.0 / range)).max(0.0); }
    static auto energy(const auto& b) { return b + 0.0; }
    static auto tension(const auto& b) { return (b > 0.0).template cast<double>(); }
    static auto slope(const auto& b) { return 0.0 * b; }
};

struct LennardJones {
    static auto base(const auto& g, double range) { return (1.0 + g * (0.5 / range)).inverse(); }
    static auto energy(const auto& b) { return b.square(); }
    static auto tension(const auto& b) { return b.cube(); }
    static auto slope(const auto& b) { return 1.5 * b.square().square(); }
};

/// compute(law) for the law of a name.
template <class Compute>
auto with_model(AttractionLaw law, const Compute& compute) {
    switch (law) {
        case AttractionLaw::exponential: break;
        case AttractionLaw::cubic: return compute(Cubic{});
        case AttractionLaw::dugdale: return compute(Dugdale{});
        case AttractionLaw::lennard_jones: return compute(LennardJones{});
    }
    return compute(Exponential{});
}

double longest_side(const Grid& grid) {
    return std::max(grid.nx > 1 ? grid.pixel_x() : 0.0, grid.ny > 1 ? grid.pixel_y() : 0.0);
}

}  // namespace

AttractionLaw attraction_law_named(std::string_view name) {
    for (const auto& [text, law] : names)
        if (text == name) return law;
    throw InvalidArgument(
        fmt::format("'{}' is not a law of attraction; expected exponential, cubic, dugdale or lennard_jones", name));
}

std::string name_of(AttractionLaw law) {
    for (const auto& [text, of] : names)
        if (of == law) return std::string(text);
    throw InternalError("a law of attraction without a name");
}

Attraction attraction(double gap, const Interaction& interaction) {
    const double tension = interaction.greatest_tension();
    return with_model(interaction.law, [&]<class Law>(Law) {
        using One = Eigen::Array<double, 1, 1>;
        const One base = Law::base(One(gap), interaction.range);
        return Attraction{.energy = -interaction.work_of_adhesion * Law::energy(base)(0),
                          .tension = tension * Law::tension(base)(0),
                          .slope = -tension / interaction.range * Law::slope(base)(0)};
    });
}

double attraction(Index points, const double* gaps, const Interaction& interaction, double* tensions, float* slopes,
                  double slope_unit) {
    const double tension = interaction.greatest_tension(), steepest = -tension / (interaction.range * slope_unit);
    return with_model(interaction.law, [&]<class Law>(Law) {
        Row base(tensions, points);
        base = Law::base(ConstRow(gaps, points), interaction.range);
        const double energy = -interaction.work_of_adhesion * Law::energy(base).sum();
        RowOf<float>(slopes, points) = (steepest * Law::slope(base)).template cast<float>();
        base = tension * Law::tension(base);
        return energy;
    });
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
        throw InvalidArgument(fmt::format("work of adhesion is {} J/m2; expected > 0", interaction.work_of_adhesion));
    if (!positive(interaction.range))
        throw InvalidArgument(fmt::format("range of attraction is {} m; expected > 0", interaction.range));
    const auto resolution = resolution_of(interaction, body, grid);
    if (resolution.squared_ratio <= 1.0 + 1e-9) return;
    const double factor = longest_side(grid) / resolution.pixel_of_refusal;
    throw InvalidArgument(
        fmt::format("pixels of {:.3g} m are too coarse for an attraction of range {:.3g} m (w dx/(E* rho^2) = "
                    "{:.3g}, at most 1): contact edges would be trapped between pixels; expected pixels of {:.3g} "
                    "m, {} x {} points, preferably half of that, or a longer range",
                    longest_side(grid), interaction.range, resolution.squared_ratio, resolution.pixel_of_refusal,
                    grid.nx > 1 ? static_cast<Index>(std::ceil(static_cast<double>(grid.nx) * factor)) : 1,
                    grid.ny > 1 ? static_cast<Index>(std::ceil(static_cast<double>(grid.ny) * factor)) : 1));
}

}  // namespace setae::half_space
