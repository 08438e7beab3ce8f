// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/validation/loop_coverage.hpp"
#include "setae/contact/jkr.hpp"

#include <functional>
#include <limits>
#include <mutex>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/loops/analysis.hpp"
#include "setae/numerics/random_numbers.hpp"

namespace setae::validation {
namespace {

using contact::jkr::Contact;
using hysteresis::HystereticSphere;
using loops::BranchData;
using loops::JkrFit;
using loops::LensAndCounterBody;

LensAndCounterBody bodies_of(const hysteresis::HystereticSphere& specimen) {
    return {.radius = specimen.radius, .counter_youngs_modulus = std::numeric_limits<double>::infinity()};
}

/// Samples of equilibrium between two contact radii, evenly in displacement, without noise.
BranchData equilibrium(const Contact& contact, double first_radius, double last_radius, Index samples) {
    const double first = contact::jkr::displacement(first_radius, contact),
                 last = contact::jkr::displacement(last_radius, contact);
    BranchData branch;
    branch.displacement = Array1D::LinSpaced(samples, first, last);
    branch.contact_radius = contact::jkr::contact_radius_at_displacement(branch.displacement, contact);
    branch.contact_radius[0] = first_radius;
    branch.contact_radius[samples - 1] = last_radius;
    branch.force = branch.contact_radius.unaryExpr([&](double a) { return contact::jkr::force(a, contact); });
    return branch;
}

struct KnownBranch {
    std::string name;
    Contact contact;
    BranchData samples;
};

std::vector<KnownBranch> known_branches(const LoopCoverageOptions& options) {
    const auto& s = options.specimen;
    const Contact approach{s.radius, s.contact_modulus, s.work_approach},
        retraction{s.radius, s.contact_modulus, s.work_retraction};
    const double largest = contact::jkr::contact_radius_at_force(options.maximum_force, approach);
    return {{"loading", approach,
             equilibrium(approach, contact::jkr::jump_in_at_fixed_grips(approach).contact_radius, largest,
                         options.samples)},
            {"unloading", retraction,
             equilibrium(retraction, largest, contact::jkr::pull_off_at_fixed_grips(retraction).contact_radius,
                         options.samples)}};
}

/// Noise of each channel.
struct Noise {
    double force, displacement, contact_radius;
};
Noise noise_of(const LoopCoverageOptions& options, double signal_to_noise) {
    const Contact approach{options.specimen.radius, options.specimen.contact_modulus, options.specimen.work_approach};
    const double largest = contact::jkr::contact_radius_at_force(options.maximum_force, approach);
    return {options.maximum_force / signal_to_noise, contact::jkr::displacement(largest, approach) / signal_to_noise,
            largest / signal_to_noise};
}

BranchData with_noise(const BranchData& exact, const Noise& noise, numerics::RandomKey key) {
    BranchData noisy = exact;
    const Index n = exact.force.size();
    noisy.force += noise.force * numerics::normal_numbers(substream(key, 0), 0, n);
    noisy.displacement += noise.displacement * numerics::normal_numbers(substream(key, 1), 0, n);
    noisy.contact_radius += noise.contact_radius * numerics::normal_numbers(substream(key, 2), 0, n);
    noisy.force_noise = noise.force;
    noisy.displacement_noise = noise.displacement;
    noisy.contact_radius_noise = noise.contact_radius;
    return noisy;
}

/// Comparisons of one run, in a fixed order.
struct Comparisons {
    int run;
    std::string signal;  ///< "SNR 5"
    std::vector<Comparison> all{};

    void add(const std::string& item, const std::string& symbol, const std::string& method, const std::string& unit,
             double true_value, const Estimate& found, Deviation measure = Deviation::relative) {
        all.push_back(
            {run, item, fmt::format("{} {} at {}", symbol, item, signal), method, unit, measure, true_value, found});
    }
    void add_fit(const KnownBranch& branch, const std::string& method, const std::function<JkrFit()>& fit) {
        JkrFit found;
        try {
            found = fit();
        } catch (const UndefinedDataError&) {
            return;  // refused; visible in the number of comparisons
        }
        add(branch.name, "E*", method, "Pa", branch.contact.contact_modulus, found.contact_modulus);
        add(branch.name, "W", method, "J/m2", branch.contact.work_of_adhesion, found.work_of_adhesion);
        if (method == "F-delta" || method == "joint")
            add(branch.name, "delta0", method, "m", 0.0, found.contact_point, Deviation::absolute);
    }
};

void add_fits(Comparisons& to, const KnownBranch& branch, const BranchData& data, const LensAndCounterBody& bodies) {
    using loops::RadiusErrors;
    to.add_fit(branch, "a(F)", [&] { return fit_radius_force(data, bodies); });
    to.add_fit(branch, "a(F) both", [&] { return fit_radius_force(data, bodies, RadiusErrors::effective_variance); });
    to.add_fit(branch, "linear", [&] { return fit_linear_form(data, bodies); });
    to.add_fit(branch, "F-delta", [&] { return fit_force_displacement(data, bodies); });
    to.add_fit(branch, "joint", [&] { return fit_joint(data, bodies); });
}

/// Samples whose radius is positive, as branch_data() of an analysis keeps them.
BranchData in_contact(const BranchData& data) {
    std::vector<Index> kept;
    for (Index i = 0; i < data.force.size(); ++i)
        if (data.contact_radius[i] > 0.0) kept.push_back(i);
    BranchData result = data;
    result.force = data.force(kept);
    result.displacement = data.displacement(kept);
    result.contact_radius = data.contact_radius(kept);
    return result;
}

using Run = std::function<void(Comparisons&, double signal_to_noise, numerics::RandomKey)>;

/// Every run at every signal, in their order.
std::vector<Comparison> all_runs(const LoopCoverageOptions& options, const Run& body) {
    if (options.runs < 1 || options.samples < 20)
        throw InvalidArgument(
            fmt::format("{} runs of {} samples; expected at least 1 of at least 20", options.runs, options.samples));
    const auto runs = static_cast<std::size_t>(options.runs), signals = options.signal_to_noise.size();
    std::vector<std::vector<Comparison>> found(runs * signals);
    std::mutex telling;
    int done = 0;
    parallel::for_each_index(runs, options.threads, [&](std::size_t run) {
        for (std::size_t k = 0; k < signals; ++k) {
            const double signal = options.signal_to_noise[k];
            Comparisons comparisons{static_cast<int>(run), fmt::format("SNR {:g}", signal)};
            body(comparisons, signal, {options.first_seed + run, k});
            found[k * runs + run] = std::move(comparisons.all);
        }
        const std::scoped_lock lock(telling);
        if (options.progress) options.progress(++done);
    });
    std::vector<Comparison> all;
    for (auto& some : found) all.insert(all.end(), some.begin(), some.end());
    return all;
}

}  // namespace

std::vector<Comparison> branch_coverage(const LoopCoverageOptions& options) {
    const auto branches = known_branches(options);
    const auto bodies = bodies_of(options.specimen);
    return all_runs(options, [&](Comparisons& to, double signal, numerics::RandomKey key) {
        for (std::size_t b = 0; b < branches.size(); ++b)
            add_fits(to, branches[b],
                     in_contact(with_noise(branches[b].samples, noise_of(options, signal), substream(key, b))), bodies);
    });
}

std::vector<Comparison> record_coverage(const LoopCoverageOptions& options) {
    const auto bodies = bodies_of(options.specimen);
    // as many samples on the way to the largest force as branch_coverage() has
    const auto branches = known_branches(options);
    const auto& displacement = branches.front().samples.displacement;
    simulation::LoadingProtocol protocol{
        .maximum_force = options.maximum_force, .force_rate = 10.0, .camera_rate = 10.0};
    protocol.approach_speed = protocol.retraction_speed =
        displacement[displacement.size() - 1] / static_cast<double>(options.samples) * protocol.force_rate;
    protocol.start_gap = displacement[displacement.size() - 1];
    return all_runs(options, [&](Comparisons& to, double signal, numerics::RandomKey key) {
        const auto noise = noise_of(options, signal);
        const auto [loop, truth] = simulation::simulated_loop(options.specimen, protocol,
                                                              {.force_noise = noise.force,
                                                               .displacement_noise = noise.displacement,
                                                               .radius_noise = noise.contact_radius,
                                                               .key = key});
        try {
            const auto found = loops::analyse(loop, bodies);
            const auto& s = options.specimen;
            to.add("record", "E*", "analysis", "Pa", s.contact_modulus, found.loading.primary().contact_modulus);
            to.add("record", "W loading", "analysis", "J/m2", s.work_approach,
                   found.loading.primary().work_of_adhesion);
            if (found.unloading)
                to.add("record", "W unloading", "analysis", "J/m2", s.work_retraction,
                       found.unloading->primary().work_of_adhesion);
            if (found.retraction)
                to.add("record", "W (Eq. S2)", "analysis", "J/m2", s.work_retraction,
                       found.retraction->work_of_adhesion);
            if (found.loop) to.add("record", "E_loss", "analysis", "J", truth.energy_loss(), found.loop->estimate());
        } catch (const UndefinedDataError&) {
            // refused; visible in the number of comparisons
        }
    });
}

}  // namespace setae::validation
