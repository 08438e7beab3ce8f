// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/contact_problem.hpp"

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"

namespace setae::answers {

half_space::Body BodyRequest::body() const {
    if (contact_modulus.empty()) throw InvalidArgument("no modulus; expected `contact_modulus = 1 GPa`");
    half_space::Body body{.contact_modulus = parse_quantity(contact_modulus, positive(dimension::pressure)),
                          .layer = {}};
    const bool stands = bonded || frictionless;
    if (layer.empty()) {
        if (stands || poisson_ratio)
            throw InvalidArgument(
                "`bonded`, `frictionless` and `poisson_ratio` describe a layer; expected `layer = 1 um`");
        return body;
    }
    if (!stands || !poisson_ratio)
        throw InvalidArgument(
            "a layer without its base or Poisson ratio; expected `bonded` or `frictionless`, and `poisson_ratio = 0.5`");
    if (bonded && frictionless)
        throw InvalidArgument("a layer both bonded and frictionless; expected one of `bonded` and `frictionless`");
    require_within(domain::poisson_ratio, *poisson_ratio, fmt::format("{}", *poisson_ratio));
    body.layer = half_space::Layer{.thickness = parse_quantity(layer, positive(dimension::length)),
                                   .poisson_ratio = *poisson_ratio,
                                   .base = bonded ? half_space::Base::bonded : half_space::Base::frictionless};
    return body;
}

half_space::Interaction InteractionRequest::interaction() const {
    if (work_of_adhesion.empty() || range.empty())
        throw InvalidArgument(
            "attraction without its work or its range; expected both, `work_of_adhesion = 50 mJ/m2` and `range = 0.3 nm`");
    return {.work_of_adhesion = parse_quantity(work_of_adhesion, positive(dimension::surface_energy)),
            .range = parse_quantity(range, positive(dimension::length)),
            .law = half_space::attraction_law_named(law)};
}

TouchingSurface touching_surface(const std::string& file, const topography::Measurement& measurement) {
    TouchingSurface result;
    if (const auto* map = std::get_if<topography::HeightMap>(&measurement)) {
        result.grid = {map->heights.rows(), map->heights.cols(), map->size[0], map->size[1]};
        result.heights = map->heights;
    } else if (const auto* scan = std::get_if<topography::LineScan>(&measurement)) {
        result.grid = {1, scan->heights.size(), 1.0, scan->size};
        result.heights = scan->heights.transpose();
        result.line = true;
    } else {
        throw InvalidArgument(
            fmt::format("{}: a profile's points are not equally far apart; expected a map or a line", file));
    }
    if (const Index undefined = result.heights.isNaN().count(); undefined > 0)
        throw InvalidArgument(fmt::format("{}: {} of {} heights are undefined; fill them with the step fill_undefined",
                                          file, undefined, result.heights.size()));
    return result;
}

std::vector<std::pair<std::string, std::string>> units_by_name(
    const std::vector<Quantity>& quantities, std::initializer_list<const fields::Description*> numbers) {
    std::vector<std::pair<std::string, std::string>> units;
    for (const auto& q : quantities) units.emplace_back(q.quantity, q.unit);
    for (const auto* description : numbers)
        for (const auto& row : description->rows)
            if (!row.unit.empty()) units.emplace_back(row.name, row.unit);
    return units;
}

std::vector<Alert> alerts_of_grid(const std::string& file, const half_space::Interaction& interaction,
                                  const half_space::Body& body, const half_space::Grid& grid) {
    const auto resolution = half_space::resolution_of(interaction, body, grid);
    if (resolution.squared_ratio <= 0.5 + 1e-9) return {};
    return {{"ADHESION_GRID", file,
             fmt::format("contact edges are trapped between pixels: w dx/(E* rho^2) is {:.2g}; up to 0.5, works are "
                         "right to 1 %; at 1, opening needs a sixth too much work",
                         resolution.squared_ratio),
             fmt::format("pixels of {} or less, or a longer `range`", format_value(resolution.pixel_of_warning, "m"))}};
}

}  // namespace setae::answers
