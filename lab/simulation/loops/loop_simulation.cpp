// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/simulation/loop_simulation.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/hysteresis/machine.hpp"

namespace setae::simulation {
namespace {

using contact::jkr::State;

void require_valid(const LoopArtefacts& artefacts) {
    const auto require_noise = [](double value, const char* name) {
        if (!(value >= 0.0 && std::isfinite(value)))
            throw InvalidArgument(fmt::format("{} noise must be >= 0, got {}", name, value));
    };
    require_noise(artefacts.force_noise, "force");
    require_noise(artefacts.displacement_noise, "displacement");
    require_noise(artefacts.radius_noise, "radius");
}

/// Times of the positions of the motor.
struct Schedule {
    double turn = 0.0;        ///< largest motor position reached [s]
    double retraction = 0.0;  ///< end of the hold [s]
    double end = 0.0;         ///< [s]
    double largest = 0.0;     ///< motor position at the turn [m]
    Index samples = 0;

    Schedule(const LoadingProtocol& protocol, double turning_position, double separation_position)
        : largest(turning_position) {
        turn = (protocol.start_gap + largest) / protocol.approach_speed;
        retraction = turn + protocol.hold_time;
        end = retraction + (largest - separation_position + protocol.start_gap) / protocol.retraction_speed;
        constexpr double max_samples = 1e8;
        const double count = std::floor(end * protocol.force_rate) + 1.0;
        if (!(count <= max_samples))
            throw InvalidArgument(
                fmt::format("the record would have {:.3g} samples, {} at most; lower the force rate or move "
                            "faster",
                            count, max_samples));
        samples = static_cast<Index>(count);
    }

    [[nodiscard]] double motor(double time, const LoadingProtocol& protocol) const {
        if (time <= turn) return protocol.approach_speed * time - protocol.start_gap;
        return largest - protocol.retraction_speed * std::max(0.0, time - retraction);
    }
};

/// Whether the camera shows this sample: the first at or after a multiple of its period.
bool has_frame(Index sample, const LoadingProtocol& protocol) {
    if (sample == 0) return true;
    const double frames = protocol.camera_rate / protocol.force_rate;
    constexpr double rounding = 1e-9;  // of a frame: multiples of the period within rounding of a sample belong to it
    const auto frame = [&](Index i) { return std::floor(static_cast<double>(i) * frames + rounding); };
    return frame(sample) > frame(sample - 1);
}

void add_artefacts(loops::Loop& loop, const Array1D& motor, const LoopArtefacts& artefacts) {
    const Index n = loop.force.size();
    const auto normal = [&](std::uint64_t channel) {
        Array1D values(n);
        numerics::fill_normal(numerics::substream(artefacts.key, channel), 0, values);
        return values;
    };
    loop.displacement += artefacts.compliance * loop.force + artefacts.displacement_drift_rate * loop.time;
    loop.force += artefacts.baseline_offset + artefacts.baseline_slope * motor + artefacts.force_drift_rate * loop.time;
    if (artefacts.force_noise > 0.0) loop.force += artefacts.force_noise * normal(0);
    if (artefacts.displacement_noise > 0.0) loop.displacement += artefacts.displacement_noise * normal(1);
    if (artefacts.radius_noise > 0.0) {
        const Array1D noise = normal(2);
        for (Index i = 0; i < n; ++i)
            if (loop.contact_radius[i] > 0.0)
                loop.contact_radius[i] = std::max(0.0, loop.contact_radius[i] + artefacts.radius_noise * noise[i]);
    }
}

/// Between samples of which x rises, straight; 0 outside.
double interpolated(const Array1D& x, const Array1D& y, double at) {
    if (x.size() == 0 || at < x[0] || at > x[x.size() - 1]) return 0.0;
    const auto upper =
        std::clamp<Index>(std::upper_bound(x.data(), x.data() + x.size(), at) - x.data(), 1, x.size() - 1);
    const double share = (at - x[upper - 1]) / (x[upper] - x[upper - 1]);
    return y[upper - 1] + share * (y[upper] - y[upper - 1]);
}

/// States after the first motion of the edge, by position of the motor.
class EdgeRetraction {
public:
    EdgeRetraction(const hysteresis::HystereticSphere& specimen, const LoadingProtocol& protocol,
                   const hysteresis::SphereLoop& truth, const std::optional<hysteresis::MovingEdge>& edge)
        : machine_(protocol.machine_stiffness),
          specimen_(specimen),
          largest_(truth.turning_point.contact_radius),
          parting_(machine_.motor(truth.separation)) {
        if (!edge) return;
        constexpr int steps = 20000;
        const auto course = hysteresis::edge_retraction_course(specimen, protocol.pressing(), *edge, steps);
        motor_ = course.motor.reverse();
        contact_radius_ = course.contact_radius.reverse();
        displacement_ = course.displacement.reverse();
        parting_ = motor_[0];
    }

    [[nodiscard]] double separation() const { return parting_; }

    [[nodiscard]] State at(double position) const {
        const auto retraction = specimen_.retraction();
        if (motor_.size() == 0)
            return hysteresis::equilibrium(machine_.stable_radius(position, retraction, largest_), retraction);
        State state{.displacement = interpolated(motor_, displacement_, position),
                    .contact_radius = interpolated(motor_, contact_radius_, position)};
        state.force = contact::jkr::force_at(state.contact_radius, state.displacement,
                                             {specimen_.radius, specimen_.contact_modulus});
        return state;
    }

private:
    hysteresis::Machine machine_;
    hysteresis::HystereticSphere specimen_;
    double largest_, parting_;
    Array1D motor_, contact_radius_, displacement_;
};

/// Additional force of the bulk, counted from the jump in.
void add_relaxation(loops::Loop& loop, double jump_in, const hysteresis::HystereticSphere& specimen,
                    const LoadingProtocol& protocol, const hysteresis::ViscousBody& body) {
    if (body.relaxation.empty()) return;
    constexpr int points = 2000;
    const auto history = hysteresis::contact_history(specimen, protocol.pressing(), protocol.drive(),
                                                     body.moving_edge(protocol.drive()), points);
    const Array1D force =
        contact::relaxation_force(history, specimen.radius, specimen.contact_modulus, body.relaxation);
    for (Index i = 0; i < loop.time.size(); ++i)
        loop.force[i] += interpolated(history.time, force, loop.time[i] - jump_in);
}

}  // namespace

SimulatedLoop simulated_loop(const hysteresis::HystereticSphere& specimen, const LoadingProtocol& protocol,
                             const LoopArtefacts& artefacts, const hysteresis::ViscousBody& body) {
    require_valid(artefacts);
    SimulatedLoop result{.truth = true_loop(specimen, protocol, body)};
    const hysteresis::SphereLoop& truth = result.truth;
    const hysteresis::Machine machine(protocol.machine_stiffness);
    const auto approach = specimen.approach();
    const EdgeRetraction edge_retraction(specimen, protocol, truth, body.moving_edge(protocol.drive()));
    const double turn = machine.motor(truth.turning_point), unpinned = machine.motor(truth.unpinned);
    const Schedule schedule(protocol, turn, edge_retraction.separation());

    const Index n = schedule.samples;
    loops::Loop& loop = result.loop;
    loop = {.time = Array1D(n), .force = Array1D(n), .displacement = Array1D(n), .contact_radius = Array1D(n)};
    Array1D motor(n);
    const double largest = truth.turning_point.contact_radius;
    for (Index i = 0; i < n; ++i) {
        const double time = static_cast<double>(i) / protocol.force_rate;
        const double position = schedule.motor(time, protocol);
        State state{.displacement = position};
        if (time <= schedule.turn && position >= 0.0)
            state = hysteresis::equilibrium(machine.stable_radius(position, approach, largest), approach);
        else if (time > schedule.turn && position >= unpinned)
            state = machine.pinned(truth.turning_point, position, specimen.contact_modulus);
        else if (time > schedule.turn && position >= edge_retraction.separation()) state = edge_retraction.at(position);
        loop.time[i] = time;
        motor[i] = position;
        loop.force[i] = state.force;
        loop.displacement[i] = state.displacement;
        loop.contact_radius[i] = has_frame(i, protocol) ? state.contact_radius : undefined;
    }
    add_relaxation(loop, protocol.start_gap / protocol.approach_speed, specimen, protocol, body);
    add_artefacts(loop, motor, artefacts);
    return result;
}

}  // namespace setae::simulation
