// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/hard_wall.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/half_space/contact_quantities.hpp"
#include "setae/processing/pipeline.hpp"

namespace setae::answers {
namespace {

/// Grid, heights and edges of a map or, as a contact 1 m long, of a line.
void take_surface(half_space::HardWall& problem, const std::string& file, const topography::Measurement& measurement,
                  bool free) {
    if (const auto* map = std::get_if<topography::HeightMap>(&measurement)) {
        problem.grid = {map->heights.rows(), map->heights.cols(), map->size[0], map->size[1]};
        problem.heights = map->heights;
        problem.edges = free ? half_space::Edges::free : half_space::Edges::periodic;
    } else if (const auto* line = std::get_if<topography::LineScan>(&measurement)) {
        problem.grid = {1, line->heights.size(), 1.0, line->size};
        problem.heights = line->heights.transpose();
        problem.edges = free ? half_space::Edges::periodic_along_x : half_space::Edges::periodic;
    } else {
        throw InvalidArgument(
            fmt::format("{}: a profile's points are not equally far apart; expected a map or a line", file));
    }
    if (problem.heights.isNaN().any())
        throw InvalidArgument(fmt::format("{}: {} of {} heights are undefined; fill them with --step fill_undefined",
                                          file, problem.heights.isNaN().count(), problem.heights.size()));
}

}  // namespace

half_space::Control HardWallRequest::control() const {
    const int given = (pressure.empty() ? 0 : 1) + (displacement.empty() ? 0 : 1) + (mean_gap.empty() ? 0 : 1);
    if (given != 1)
        throw InvalidArgument(
            fmt::format("{} of --pressure, --displacement and --mean-gap were given; expected one", given));
    if (!pressure.empty()) return half_space::MeanPressure{parse_quantity(pressure, dimension::pressure)};
    if (!mean_gap.empty()) return half_space::MeanGap{parse_quantity(mean_gap, dimension::length)};
    return half_space::Displacement{parse_quantity(displacement, dimension::length)};
}

half_space::Body HardWallRequest::body() const {
    if (contact_modulus.empty()) throw InvalidArgument("no modulus; expected --contact-modulus \"1 GPa\"");
    half_space::Body body{.contact_modulus = parse_quantity(contact_modulus, dimension::pressure), .layer = {}};
    const bool stands = bonded || frictionless;
    if (layer.empty()) {
        if (stands || poisson_ratio)
            throw InvalidArgument("--bonded, --frictionless and --nu are of a layer; expected --layer \"1 um\"");
        return body;
    }
    if (!stands || !poisson_ratio)
        throw InvalidArgument(
            "a layer without its base or Poisson ratio; expected --bonded or --frictionless, and "
            "--nu");
    body.layer = half_space::Layer{.thickness = parse_quantity(layer, dimension::length),
                                   .poisson_ratio = *poisson_ratio,
                                   .base = bonded ? half_space::Base::bonded : half_space::Base::frictionless};
    return body;
}

void HardWallRequest::require_complete() const {
    (void)body();
    (void)control();
}

HardWallAnswer hard_wall(const std::string& file, const topography::Measurement& measurement,
                         const HardWallRequest& request, parallel::Threads threads,
                         const std::function<void(const half_space::SolveProgress&)>& progress) {
    HardWallAnswer answer{
        .file = file,
        .problem = {.grid = {}, .body = request.body(), .heights = {}, .control = request.control(), .hardness = {}},
        .contact = {},
        .stiffness = 0.0,
        .quantities = {},
        .alerts = {}};
    auto& [path, problem, contact, stiffness, quantities, alerts] = answer;
    if (!request.hardness.empty()) problem.hardness = parse_quantity(request.hardness, dimension::pressure);
    take_surface(problem, file, measurement, request.free);
    contact = half_space::solve(problem, {.tolerance = request.tolerance, .threads = threads, .progress = progress});
    stiffness = half_space::contact_stiffness(problem, contact, threads);
    if (contact.status == half_space::SolveStatus::not_converged)
        alerts.push_back({"CONTACT_NOT_CONVERGED", file,
                          fmt::format("pressures may be off: the duality gap is {:.1e}, wanted was {:.1e}",
                                      contact.certificate.duality_gap, request.tolerance),
                          "raise --tolerance, or resolve the surface's shortest waves with more points"});
    quantities = half_space::contact_quantities(problem, contact, stiffness);
    return answer;
}

output::Json to_json(const HardWallAnswer& answer, const std::vector<processing::StepRecord>& processing) {
    const auto& [file, problem, contact, stiffness, quantities, alerts] = answer;
    output::Json json, units;
    for (const auto& q : quantities) {
        json[q.quantity] = output::number(q.estimate.value);
        units[q.quantity] = q.unit;
    }
    const auto& certificate = contact.certificate;
    units["penetration"] = "m";
    json["status"] = half_space::name_of(contact.status);
    json["duality_gap"] = certificate.duality_gap;
    json["penetration"] = certificate.penetration;
    json["level_error"] = certificate.level_error;
    json["load_error"] = certificate.load_error;
    json["iterations"] = contact.iterations;
    json["transform_pairs"] = contact.transform_pairs;
    json["mean_displacement"] = half_space::name_of(contact.mean_displacement);
    json["points"] = {problem.grid.nx, problem.grid.ny};
    json["size"] = {problem.grid.size_x, problem.grid.size_y};
    json["contact_modulus"] = problem.body.contact_modulus;
    units["size"] = "m";
    units["contact_modulus"] = "Pa";
    json["units"] = units;
    json["file"] = file;
    json["processing"] = output::to_json(processing);
    json["alerts"] = output::to_json(alerts);
    return json;
}

}  // namespace setae::answers
