// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/contact_front.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "setae/answers/made_surface.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/contact_line/line_table.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/sample_mean.hpp"
#include "setae/core/uncertain_text.hpp"
#include "setae/core/units.hpp"
#include "setae/core/words.hpp"
#include "setae/output/json.hpp"

namespace setae::answers {
namespace {

using crack_front::Drive;
using topography::HeightMap;

/// One of a few words.
template <class Value>
Value named(const char* what, const std::string& text, const std::vector<std::pair<std::string, Value>>& words) {
    std::string all;
    for (const auto& [word, value] : words) {
        if (word == text) return value;
        all += (all.empty() ? "" : ", ") + word;
    }
    throw InvalidArgument(fmt::format("{} '{}'; expected one of {}", what, text, all));
}

double given(const char* option, const std::string& text, const Expected& expected) {
    if (text.empty()) throw InvalidArgument(fmt::format("a front needs {}", option));
    return parse_quantity(text, expected);
}

/// Turning point of a loop, as displacement and force of a smooth sphere.
struct TurningPoint {
    double displacement = 0.0, force = 0.0;
};

TurningPoint turning_point(const FrontRequest& request, const contact::AdhesiveContact& contact) {
    if (!request.to_force.empty()) {
        const double force = parse_quantity(request.to_force, positive(dimension::force));
        return {contact::jkr::displacement_at_force(force, contact), force};
    }
    const double displacement = parse_quantity(request.to_displacement, positive(dimension::length));
    const double radius = contact::jkr::contact_radius_at_displacement(displacement, contact);
    return {displacement, contact::jkr::force(radius, contact)};
}

crack_front::LoopPath path_of(const FrontRequest& request, const TurningPoint& turn) {
    crack_front::LoopPath path{.furthest = turn.displacement, .steps = request.steps};
    if (request.dead_load) {
        path.drive = Drive::load;
        path.furthest = turn.force;
    } else if (!request.stage_stiffness.empty()) {
        path.drive = Drive::stage;
        path.stiffness = parse_quantity(request.stage_stiffness, positive(dimension::stiffness));
        path.furthest = turn.displacement + turn.force / path.stiffness;
    }
    return path;
}

const HeightMap& map_of(const std::string& file, const topography::Measurement& measurement) {
    const auto* map = std::get_if<HeightMap>(&measurement);
    if (!map) throw InvalidArgument(file + ": no map; expected heights along two directions under a round contact");
    if (const Index undefined = map->heights.isNaN().count(); undefined > 0)
        throw InvalidArgument(fmt::format("{}: {} of {} heights are undefined; fill them with the step fill_undefined",
                                          file, undefined, map->heights.size()));
    return *map;
}

/// Required length of rays: the edge of a contact with 1.5 times the work, and a few waves.
double reach_of(const FrontRequest& request, const TurningPoint& turn, contact::AdhesiveContact contact,
                double shortest) {
    contact.work_of_adhesion *= 1.5;
    const double radius = request.dead_load || !request.stage_stiffness.empty()
                              ? contact::jkr::contact_radius_at_force(turn.force, contact)
                              : contact::jkr::contact_radius_at_displacement(turn.displacement, contact);
    return radius + 4.0 * shortest;
}

/// Common data of all surfaces of an answer.
struct Plan {
    const FrontRequest& request;
    contact::AdhesiveContact contact;
    crack_front::LoopPath path;
    double shortest = 0.0;  ///< [m]
    crack_front::RayGrid rays;
};

Plan plan_of(const std::string& file, const HeightMap& map, const FrontRequest& request) {
    constexpr double max_values = 3e8;  // of K_R and w each
    Plan plan{.request = request, .contact = request.contact(), .path = {}, .shortest = 0.0, .rays = {}};
    const auto turn = turning_point(request, plan.contact);
    const auto pixel = map.pixel_size();
    plan.path = path_of(request, turn);
    plan.shortest = request.shortest_wavelength.empty()
                        ? pixels_per_wave * std::max(pixel[0], pixel[1])
                        : parse_quantity(request.shortest_wavelength, positive(dimension::length));
    const double reach = reach_of(request, turn, plan.contact, plan.shortest);
    constexpr double seen = 0.9;  // share of the largest circle of a map that is not periodic
    const double limit = 0.5 * seen * std::min(map.size[0], map.size[1]);
    if (!map.periodic && reach > limit)
        throw InvalidArgument(fmt::format(
            "{}: the edge of this contact comes to {} from its centre, the map has roughness for {}; expected a "
            "smaller sphere or load, or a surface made from the map's spectrum",
            file, format_value(reach, "m", 3), format_value(limit, "m", 3)));
    plan.rays = crack_front::ray_grid(reach, plan.shortest);
    const double values = static_cast<double>(plan.rays.angles) * static_cast<double>(plan.rays.radii.count);
    if (values > max_values)
        throw InvalidArgument(
            fmt::format("waves of {} under a contact that reaches {} take {:.1e} places of the edge; expected at most "
                        "{:.0e}, as with `shortest_wavelength = {}`, or a smaller contact",
                        format_value(plan.shortest, "m", 3), format_value(reach, "m", 3), values, max_values,
                        format_value(plan.shortest * std::sqrt(values / max_values), "m", 2)));
    return plan;
}

/// Stores the edge of a front during contact, on approach and retraction in a given number of seconds each.
class KeptEdge {
public:
    explicit KeptEdge(double duration, double furthest) : duration_(duration), furthest_(furthest) {}

    void look(const crack_front::FrontStep& step, const crack_front::CircularFront& front) {
        if (!(duration_ > 0.0) || !step.state.in_contact) return;
        const double way = step.position / furthest_, time = duration_ * (step.approaching ? way : 2.0 - way);
        if (!times_.empty() && !(time > times_.back())) return;
        times_.push_back(time);
        displacements_.push_back(step.state.displacement);
        forces_.push_back(step.state.force);
        edges_.push_back(front.edge());
    }
    void give(FrontRun& run) const {
        constexpr Index max_angles = 512;
        if (edges_.empty()) return;
        const auto array = [](const std::vector<double>& values) -> Array1D {
            return Eigen::Map<const Array1D>(values.data(), std::ssize(values));
        };
        contact_line::ContactLine line{.time = array(times_),
                                       .radius = Array2D(std::ssize(edges_), edges_.front().size())};
        for (Index i = 0; i < line.frames(); ++i) line.radius.row(i) = edges_[static_cast<std::size_t>(i)].transpose();
        run.edge = contact_line::at_fewer_angles(line, std::min(max_angles, line.angles()));
        run.displacement = array(displacements_);
        run.force = array(forces_);
    }

private:
    double duration_, furthest_;
    std::vector<double> times_, displacements_, forces_;
    std::vector<Array1D> edges_;
};

/// contact_line::as_table() of a run, with its controlled quantity.
Table edge_table(const FrontRun& run) {
    std::vector<long> numbers(static_cast<std::size_t>(run.edge.frames()));
    std::iota(numbers.begin(), numbers.end(), 1L);
    auto table = contact_line::as_table(run.edge, numbers);
    table.columns.insert(table.columns.begin() + 2,
                         {Column{"displacement", "m", run.displacement}, Column{"force", "N", run.force}});
    return table;
}

FrontRun run_of(const HeightMap& map, const Plan& plan, parallel::Threads threads,
                const std::function<bool(const crack_front::FrontStep&)>& progress) {
    const auto& contact = plan.contact;
    FrontRun run;
    const auto intensity = crack_front::stress_intensity_on_rays(
        map, {contact.contact_modulus, plan.shortest, {0.5 * map.size[0], 0.5 * map.size[1]}}, plan.rays.angles,
        plan.rays.radii, threads);
    run.stored_energy = intensity.stored_energy;
    crack_front::CircularFront front({contact.radius, contact.contact_modulus},
                                     crack_front::equivalent_work(intensity.values, intensity.points,
                                                                  contact.work_of_adhesion, contact.contact_modulus),
                                     plan.request.options());
    auto path = plan.path;
    KeptEdge edge(
        plan.request.duration.empty() ? 0.0 : parse_quantity(plan.request.duration, positive(dimension::time)),
        path.furthest);
    path.progress = [&](const crack_front::FrontStep& step) {
        edge.look(step, front);
        return progress(step);
    };
    run.loop = crack_front::front_loop(front, path);
    edge.give(run);
    for (const auto& step : run.loop.steps) run.contact_radius = std::max(run.contact_radius, step.state.area_radius);
    const double radius = std::max(run.contact_radius, plan.shortest);
    run.validity = crack_front::validity_of(intensity, contact.work_of_adhesion, 2.0 * pi * radius,
                                            2.0 * pi * radius / static_cast<double>(plan.rays.angles));
    try {
        run.works = crack_front::branch_works(run.loop, front.sphere());
    } catch (const UndefinedDataError& error) {
        run.reason = error.what();
    }
    return run;
}

/// Mean of all surfaces; without a standard error for a single one.
Estimate mean_of(const std::vector<FrontRun>& runs, const std::function<double(const FrontRun&)>& number) {
    std::vector<double> values;
    for (const auto& run : runs)
        if (const double value = number(run); std::isfinite(value)) values.push_back(value);
    if (values.empty()) return {.value = undefined};
    const auto mean = sample_mean(Eigen::Map<const Array1D>(values.data(), std::ssize(values)),
                                  fmt::format("mean over {} surfaces", values.size()));
    constexpr double rounding = 1e-12;  // generated surfaces of one kind store equal energies
    if (mean.standard_error <= rounding * std::abs(mean.value)) return {.value = mean.value};
    return mean;
}

/// A quantity that is read from a loop.
struct Reading {
    const char *name, *symbol, *unit;
    std::function<double(const FrontRun&)> value;
};

const std::vector<Reading>& readings() {
    const auto of_works = [](auto number) {
        return [number](const FrontRun& run) { return run.works ? number(*run.works) : undefined; };
    };
    using Works = crack_front::BranchWorks;
    static const std::vector<Reading> list{
        {"work_of_adhesion_approach", "W_appr", "J/m2",
         of_works([](const Works& works) { return works.approach.work_of_adhesion.value; })},
        {"work_of_adhesion_retraction", "W_ret", "J/m2",
         of_works([](const Works& works) { return works.retraction.work_of_adhesion.value; })},
        {"pinning_coefficient", "k", "1", [](const FrontRun& run) { return run.pinning_coefficient(); }},
        {"pull_off_force", "F_po", "N", of_works([](const Works& works) { return -works.pull_off_force; })},
        {"energy_loss", "E_loss", "J", [](const FrontRun& run) { return run.loop.energy_loss; }},
        {"approach_dissipation", "E_in", "J", [](const FrontRun& run) { return run.loop.approach_dissipation; }},
        {"retraction_dissipation", "E_out", "J", [](const FrontRun& run) { return run.loop.retraction_dissipation; }},
        {"jumps", "n", "1", [](const FrontRun& run) { return static_cast<double>(run.loop.jumps); }},
        {"stored_energy", "U_el/A", "J/m2", [](const FrontRun& run) { return run.stored_energy; }},
        {"energy_share", "U_el/AW", "1", [](const FrontRun& run) { return run.validity.energy_share; }},
        {"contact_radius", "a_max", "m", [](const FrontRun& run) { return run.contact_radius; }},
        {"front_length", "2 pi a_max", "m", [](const FrontRun& run) { return run.validity.front_length; }},
        {"larkin_length", "L_c", "m", [](const FrontRun& run) { return run.validity.larkin_length; }}};
    return list;
}

std::vector<Quantity> quantities_of(const FrontAnswer& answer) {
    std::vector<Quantity> quantities;
    for (const auto& reading : readings())
        quantities.push_back(
            output::quantity(reading.name, reading.symbol, mean_of(answer.runs, reading.value), reading.unit));
    quantities.push_back(
        output::quantity("smooth_sphere_loss", "E_loss,0", contact::jkr::ideal_loop_loss(answer.contact).total, "J"));
    quantities.push_back(output::quantity("smooth_sphere_pull_off_force", "F_po,0",
                                          -contact::jkr::pull_off_at_fixed_load(answer.contact).force, "N"));
    return quantities;
}

std::vector<Alert> alerts_of(const FrontAnswer& answer, const HeightMap& map) {
    auto alerts = map.metadata.alerts;
    const auto& file = answer.file;
    const auto& first = answer.runs.front();
    for (const auto& caution : first.validity.cautions)
        alerts.push_back(
            {"FRONT_THEORY", file, caution, "read docs/concepts/crack-front.md for the conditions of the theory"});
    if (const double across = 2.0 * first.contact_radius; map.periodic && across > std::min(map.size[0], map.size[1]))
        alerts.push_back(
            {"FRONT_THEORY", file,
             fmt::format("the contact is {} wide, but the surface repeats after {}", format_value(across, "m", 3),
                         format_value(std::min(map.size[0], map.size[1]), "m", 3)),
             "use a larger cell: the same places pin the edge repeatedly"});
    for (const auto& run : answer.runs) {
        if (!run.loop.complete)
            alerts.push_back({"CONTACT_NOT_CONVERGED", file,
                              "a loop of the front has steps that did not converge, or did not part",
                              "take more steps, or `method = rosso_krauth`"});
        if (!run.works)
            alerts.push_back({"FRONT_THEORY", file, "a loop gives no works of adhesion: " + run.reason,
                              "use the energies of the loop, which are not affected"});
    }
    return alerts;
}

}  // namespace

double FrontRun::pinning_coefficient() const {
    if (!works || !(stored_energy > 0.0)) return undefined;
    return (works->retraction.work_of_adhesion.value - works->approach.work_of_adhesion.value) / (2.0 * stored_energy);
}

void FrontRequest::require_complete() const {
    (void)contact();
    (void)options();
    if (to_force.empty() == to_displacement.empty())
        throw InvalidArgument("expected one of `to_force` and `to_displacement`: where the loop turns");
    if (dead_load && !stage_stiffness.empty())
        throw InvalidArgument("a dead load has no stage; expected one of `dead_load` and `stage_stiffness`");
    (void)path_of(*this, turning_point(*this, contact()));
}

contact::AdhesiveContact FrontRequest::contact() const {
    return {
        given("`radius = 1.25 mm`, the radius of the sphere", radius, positive(dimension::length)),
        given("`contact_modulus = 1 MPa`, E* of sphere and surface", contact_modulus, positive(dimension::pressure)),
        given("`work_of_adhesion = 50 mJ/m2`", work_of_adhesion, positive(dimension::surface_energy))};
}

crack_front::FrontOptions FrontRequest::options() const {
    using crack_front::EquilibriumMethod;
    using crack_front::FrontModel;
    return {.model = named<FrontModel>("model", model,
                                       {{"constant_toughness", FrontModel::constant_toughness},
                                        {"variational", FrontModel::variational},
                                        {"energy_release_rate", FrontModel::energy_release_rate},
                                        {"stress_intensity", FrontModel::stress_intensity},
                                        {"mean_circle", FrontModel::mean_circle}}),
            .method = named<EquilibriumMethod>("method", method,
                                               {{"trust_region", EquilibriumMethod::trust_region},
                                                {"rosso_krauth", EquilibriumMethod::rosso_krauth}})};
}

FrontAnswer contact_front(const std::string& file, const std::vector<topography::Measurement>& surfaces,
                          const FrontRequest& request, parallel::Threads threads, const FrontProgress& progress) {
    request.require_complete();
    if (surfaces.empty()) throw InvalidArgument(file + ": no surface");
    std::vector<const HeightMap*> maps;
    for (const auto& surface : surfaces) maps.push_back(&map_of(file, surface));
    const auto plan = plan_of(file, *maps.front(), request);
    FrontAnswer answer{.file = file,
                       .contact = plan.contact,
                       .shortest_wavelength = plan.shortest,
                       .runs = std::vector<FrontRun>(maps.size()),
                       .steps = {},
                       .edge = {},
                       .quantities = {},
                       .alerts = {}};
    std::atomic<std::size_t> steps = 0;
    const double all = 2.0 * static_cast<double>(plan.path.steps) * static_cast<double>(maps.size());
    const auto step_done = [&](const crack_front::FrontStep&) {
        return !progress || progress(std::min(1.0, static_cast<double>(++steps) / all));
    };
    const bool one = maps.size() == 1;
    parallel::for_each_index(maps.size(), threads, [&](std::size_t i) {
        answer.runs[i] = run_of(*maps[i], plan, one ? threads : parallel::Threads{1}, step_done);
    });
    answer.steps = crack_front::loop_table(answer.runs.front().loop, plan.path.drive);
    if (answer.runs.front().edge.frames() > 0) answer.edge = edge_table(answer.runs.front());
    answer.quantities = quantities_of(answer);
    answer.alerts = alerts_of(answer, *maps.front());
    return answer;
}

std::string front_sentence(const FrontAnswer& answer) {
    const auto value = [&](const char* name) -> const Estimate& {
        return std::ranges::find(answer.quantities, name, &Quantity::quantity)->estimate;
    };
    const auto text = [&](const char* name, const char* unit) { return format_uncertain(value(name), unit); };
    const double smooth = value("smooth_sphere_loss").value;
    const auto lost =
        fmt::format("the loop loses {}, a smooth sphere {}", text("energy_loss", "J"), format_value(smooth, "J", 3));
    if (!std::isfinite(value("work_of_adhesion_retraction").value)) return lost;
    return fmt::format("W_appr {}, W_ret {} where a smooth surface has {}: k = {} of U_el/AW = {:.2g}; {}; {}",
                       text("work_of_adhesion_approach", "J/m2"), text("work_of_adhesion_retraction", "J/m2"),
                       format_value(answer.contact.work_of_adhesion, "J/m2", 3),
                       uncertain_number(value("pinning_coefficient")), value("energy_share").value, lost,
                       fmt::format("{:.0f} jumps", value("jumps").value));
}

std::vector<Quantity> quantities_of(const FrontRun& run) {
    std::vector<Quantity> quantities;
    for (const auto& reading : readings())
        quantities.push_back(output::quantity(reading.name, reading.symbol, reading.value(run), reading.unit));
    return quantities;
}

}  // namespace setae::answers
