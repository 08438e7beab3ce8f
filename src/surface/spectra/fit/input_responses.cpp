// SPDX-License-Identifier: GPL-3.0-or-later
#include "input_responses.hpp"

#include <algorithm>
#include <cmath>

#include "setae/spectral_fit/hat_node.hpp"

namespace setae::spectral_fit {
namespace {

/// Values on increasing nodes, linear in ln q, constant beyond their ends.
Array1D interpolated(const Array1D& wavevector, const Array1D& values, const Array1D& at) {
    const Index n = wavevector.size();
    if (n < 2) return Array1D::Constant(at.size(), values[0]);
    return at.unaryExpr([&](double q) {
        const auto above = std::upper_bound(wavevector.begin(), wavevector.end(), q) - wavevector.begin();
        const Index left = std::clamp<Index>(above - 1, 0, n - 2);
        const double share = std::log(q / wavevector[left]) / std::log(wavevector[left + 1] / wavevector[left]);
        const double inside = std::clamp(share, 0.0, 1.0);
        return (1.0 - inside) * values[left] + inside * values[left + 1];
    });
}

/// Whether the noise of a class is the stated noise of its trace, which scales with the data.
bool has_stated_noise(const PeriodogramClass& data) {
    return data.noise_response.size() > 0 && data.noise_prior_deviation > 0.0;
}

void move_heights(PeriodogramClass& data, double log_factor) {
    const double power = std::exp(2.0 * log_factor);
    data.periodogram *= power;
    if (has_stated_noise(data)) data.noise_response *= power;
}

/// Ratio of T² of light at other wavevectors to the previous one; 1 if that was 0.
Array1D change_of_optics(const OpticalTransfer& optics, const Array1D& before, const Array1D& now) {
    return Array1D::NullaryExpr(before.size(), [&](Index i) {
        const double old = optics.at(before[i]);
        return old > 0.0 ? std::pow(optics.at(now[i]) / old, 2) : 1.0;
    });
}

void move_lengths(PeriodogramClass& data, const ObservedGroup& group, const TipResponse* tip, double log_factor) {
    const double factor = std::exp(log_factor);
    const Array1D wavevector = data.wavevector / factor, nodes = data.nodes / factor;
    data.periodogram *= factor;
    // the end of the spectrum is fixed, at a greater distance from the last node
    if (group.end_response.size() > 0)
        data.response.col(data.nodes.size() - 1) += log_factor / node_spacing * group.end_response;
    data.response /= factor;
    if (data.noise_response.size() > 0) data.noise_response *= factor;
    if (group.optics) data.response.rowwise() *= change_of_optics(*group.optics, data.nodes, nodes).transpose();
    if (tip && group.probe->is_foil()) {
        const Array1D& T = group.tip.log_transfer;
        data.response.colwise() *= (interpolated(group.data.wavevector, T, wavevector) - T).exp();
    } else if (tip) {
        const auto followed = followed_at(*tip, nodes);
        data.log_followed = followed.log_square;
        data.followed_response = followed.response;
        data.added =
            interpolated(group.data.wavevector, data.added.max(std::numeric_limits<double>::min()).log(), wavevector)
                .exp();
    }
    data.wavevector = wavevector;
    data.nodes = nodes;
}

void move_probe(PeriodogramClass& data, const ObservedGroup& group, double log_factor) {
    const Array1D change = (group.tip.size_response * log_factor).exp();
    data.response.colwise() *= change;
    if (data.added.size() > 0) data.added *= change;
}

const TipResponse* response_of(const ObservedGroup& group, const std::map<std::string, TipResponse>& responses) {
    if (!group.probe) return nullptr;
    const auto found = responses.find(group.probe->name);
    return found == responses.end() ? nullptr : &found->second;
}

/// Change of ln of the affected quantities for one standard error of an input, by group.
struct Moves {
    double heights = 0.0, lengths = 0.0, probe = 0.0;

    [[nodiscard]] double largest() const { return std::max({heights, lengths, probe}); }
};

Moves moves_by(const ObservedGroup& g, const std::string& input) {
    const auto by = [&](const SharedFactor& factor) { return factor.input == input ? factor.relative_error : 0.0; };
    Moves moves{by(g.height), by(g.lateral), 0.0};
    if (g.probe && g.probe_input == input) moves.probe = g.probe->size_error / g.probe->size;
    return moves;
}

std::map<std::string, double> inputs_of(const std::vector<ObservedGroup>& groups) {
    std::map<std::string, double> largest;
    for (const auto& g : groups)
        for (const auto& name : {g.height.input, g.lateral.input, g.probe_input})
            largest[name] = std::max(largest[name], moves_by(g, name).largest());
    std::erase_if(largest, [](const auto& entry) { return entry.first.empty() || !(entry.second > 0.0); });
    return largest;
}

/// Change of the logarithms of the ends of the band of the groups if an input changes their lengths.
Band moved_ends(const std::vector<ObservedGroup>& groups, const std::string& input) {
    Band ends{std::numeric_limits<double>::infinity(), 0.0}, moved{0.0, 0.0};
    for (const auto& g : groups)
        for (Index k = 0; k < g.data.wavevector.size(); ++k) {
            if (!(g.data.freedom[k] > 0.0)) continue;
            const double q = g.data.wavevector[k], change = -moves_by(g, input).lengths;
            if (q < ends.lower) {
                ends.lower = q;
                moved.lower = change;
            }
            if (q > ends.upper) {
                ends.upper = q;
                moved.upper = change;
            }
        }
    return moved;
}

}  // namespace

std::vector<InputResponse> input_responses(const std::vector<ObservedGroup>& groups,
                                           const std::map<std::string, TipResponse>& responses, const WhittleFit& fit,
                                           const LogSpline& spline, const Smoothness& smoothness) {
    constexpr double longest_step = 1e-3;  // of a logarithm
    std::vector<PeriodogramClass> classes;
    for (const auto& g : groups) classes.push_back(g.data);
    std::vector<InputResponse> result;
    for (const auto& [input, largest] : inputs_of(groups)) {
        const double step = std::min(1.0, longest_step / largest);
        const auto moved = [&](double side) {
            auto all = classes;
            for (std::size_t c = 0; c < groups.size(); ++c) {
                const auto moves = moves_by(groups[c], input);
                const auto* tip = response_of(groups[c], responses);
                if (moves.probe > 0.0 && tip) move_probe(all[c], groups[c], side * step * moves.probe);
                if (moves.lengths > 0.0) move_lengths(all[c], groups[c], tip, side * step * moves.lengths);
                if (moves.heights > 0.0) move_heights(all[c], side * step * moves.heights);
            }
            return all;
        };
        const auto change = theta_moved(fit, classes, {moved(1.0), moved(-1.0)}, spline, smoothness);
        result.push_back({input, change / step, moved_ends(groups, input)});
    }
    return result;
}

}  // namespace setae::spectral_fit
