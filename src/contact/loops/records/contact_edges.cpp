// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_edges.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "baseline.hpp"
#include "channel_noise.hpp"
#include "local_lines.hpp"
#include "setae/core/statistics.hpp"

namespace setae::loops {
namespace {

constexpr Index min_free = 5;           ///< samples of free flight
constexpr double contact_share = 0.15;  ///< share of the slope near the turn above which samples are in contact

double quantile_of(Array1D values, double share) {
    std::sort(values.begin(), values.end());
    return sorted_quantile({values.data(), static_cast<std::size_t>(values.size())}, share);
}

/// Time where it increases strictly, else the sample's number: local slopes need distinct times.
Array1D strict_clock(const Loop& loop) {
    const Array1D clock = clock_of(loop);
    const Index n = clock.size();
    if ((clock.tail(n - 1) > clock.head(n - 1)).all()) return clock;
    return Array1D::LinSpaced(n, 0.0, static_cast<double>(n - 1));
}

/// Slopes in time of both channels.
struct Slopes {
    Index half_width = 0;
    Array1D clock, force, displacement;
    double force_noise = 0.0;  ///< σ_F of one sample [N]
};

/// Standard error of a slope over a window of samples one step apart, for noise of one.
double slope_error(Index half_width, double step) {
    const auto m = static_cast<double>(2 * half_width + 1);
    return 1.0 / (step * std::sqrt(m * (m * m - 1.0) / 12.0));
}

/// Windows grow until noise moves no slope by more than 3 % of the steep ones.
Slopes slopes_of(const Loop& loop) {
    constexpr double share = 0.03, steep_quantile = 0.9;
    const Index n = loop.force.size();
    Slopes slopes{.half_width = std::max(std::clamp<Index>(n / 25, 2, 4), n / 150), .clock = strict_clock(loop)};
    const Index most = std::max(slopes.half_width, n / 30);
    const double step = (slopes.clock[n - 1] - slopes.clock[0]) / static_cast<double>(n - 1);
    slopes.force_noise = record_noise(loop.force);
    const double displacement_noise = record_noise(loop.displacement);
    for (;; slopes.half_width = std::min(most, slopes.half_width + 1 + slopes.half_width / 8)) {
        slopes.force = local_slopes(slopes.clock, loop.force, slopes.half_width);
        slopes.displacement = local_slopes(slopes.clock, loop.displacement, slopes.half_width);
        const double error = slope_error(slopes.half_width, step);
        const double steep_force = quantile_of((slopes.force - median_of(slopes.force)).abs(), steep_quantile),
                     steep_motion = quantile_of(slopes.displacement.abs(), steep_quantile);
        if (slopes.half_width >= most ||
            (error * slopes.force_noise < share * steep_force && error * displacement_noise < share * steep_motion))
            return slopes;
    }
}

/// Sample of the largest position. Empty where the smallest differs from both ends more than the largest does: a record
/// in the opposite direction.
std::optional<Index> turn_of(const Array1D& position) {
    constexpr double stands_out = 0.05;  // share of the travel
    const double first = position[0], last = position[position.size() - 1];
    Index at = 0;
    const double highest = position.maxCoeff(&at), lowest = position.minCoeff();
    const double above = highest - std::max(first, last), below = std::min(first, last) - lowest;
    if (below > above && below > stands_out * (highest - lowest)) return std::nullopt;
    return at;
}

/// Stretches of a mask, those of fewer samples left out.
std::vector<IndexRange> stretches(const std::vector<bool>& mask, Index fewest) {
    std::vector<IndexRange> found;
    const auto n = static_cast<Index>(mask.size());
    for (Index i = 0; i < n; ++i) {
        if (!mask[static_cast<std::size_t>(i)]) continue;
        IndexRange stretch{i, i};
        while (stretch.last + 1 < n && mask[static_cast<std::size_t>(stretch.last + 1)]) ++stretch.last;
        if (stretch.count() >= fewest) found.push_back(stretch);
        i = stretch.last;
    }
    return found;
}

/// For several contacts the first jump in and the last jump out, next to it the clearest.
std::optional<ForceJump> outermost_jump(const Loop& loop, const Array1D& clock, const JumpSearch& search) {
    std::vector<ForceJump> jumps = force_jumps(clock, loop.force, search);
    if (jumps.empty()) return std::nullopt;
    constexpr double comparable = 0.3;
    double most = 0.0;
    for (const ForceJump& jump : jumps) most = std::max(most, clarity(jump));
    std::erase_if(jumps, [&](const ForceJump& jump) { return clarity(jump) < comparable * most; });
    const auto further_out = [&](const ForceJump& one, const ForceJump& other) {
        return search.free_side == FreeSide::before ? one.last < other.last : one.next > other.next;
    };
    const ForceJump edge = *std::min_element(jumps.begin(), jumps.end(), further_out);
    ForceJump best = edge;
    for (const ForceJump& jump : jumps)
        if (std::abs(jump.last - edge.last) <= search.half_width && clarity(jump) > clarity(best)) best = jump;
    return best;
}

/// Slope in time of the force at either end of the record.
struct EndSlopes {
    double first = 0.0, last = 0.0;
    double motion_first = 0.0, motion_last = 0.0;  ///< motion of the displacement

    explicit EndSlopes(const Slopes& slopes) {
        const Index n = slopes.force.size(), taken = std::max<Index>(min_free, n / 25);
        first = median_of(slopes.force.head(taken));
        last = median_of(slopes.force.tail(taken));
        motion_first = median_of(slopes.displacement.head(taken));
        motion_last = median_of(slopes.displacement.tail(taken));
    }
};

/// dF/dδ within a tenth of the travel of the turn, minus the slope at the record's ends.
double slope_at_turn(const Slopes& slopes, const EndSlopes& ends, const Array1D& position, Index turn) {
    constexpr double near = 0.1;
    const double travel = position.maxCoeff() - position.minCoeff();
    const double usual = median_of(slopes.displacement.abs());
    for (const double moving : {0.2, 0.02}) {
        std::vector<double> values;
        for (Index i = 0; i < position.size(); ++i) {
            const double speed = slopes.displacement[i];
            if (position[i] < position[turn] - near * travel || std::abs(speed) <= moving * usual) continue;
            values.push_back((slopes.force[i] - (i <= turn ? ends.first : ends.last)) / speed);
        }
        constexpr std::size_t fewest = 5;
        if (values.size() >= fewest) return median(values);
    }
    return 0.0;
}

}  // namespace

ContactEdges find_contact_edges(const Loop& loop) {
    const Slopes slopes = slopes_of(loop);
    const EndSlopes ends(slopes);
    const Index n = loop.force.size(), window = 2 * slopes.half_width + 2;
    const Array1D position = local_means(loop.displacement, slopes.half_width);
    ContactEdges edges;
    const std::optional<Index> turn = turn_of(position);
    if (!turn) return edges;
    edges.turn = *turn;
    edges.contact_slope = slope_at_turn(slopes, ends, position, edges.turn);
    const double usual_speed = median_of(slopes.displacement.abs());
    constexpr double min_speed = 0.05;  // share of the usual speed: prevents a division by zero for a resting stage
    Array1D excess(n);
    std::vector<bool> touching(static_cast<std::size_t>(n));
    for (Index i = 0; i < n; ++i) {
        excess[i] = std::abs(slopes.force[i] - (i <= edges.turn ? ends.first : ends.last));
        const double speed = std::max(std::abs(slopes.displacement[i]), min_speed * usual_speed);
        touching[static_cast<std::size_t>(i)] = excess[i] > contact_share * edges.contact_slope * speed;
    }
    constexpr double steep_quantile = 0.9, steep_share = 0.2;
    if (!(edges.contact_slope * usual_speed > steep_share * quantile_of(excess, steep_quantile))) return edges;
    const std::vector<IndexRange> contacts = stretches(touching, window);
    edges.found = !contacts.empty();
    if (!edges.found) return edges;
    JumpSearch search{.noise = slopes.force_noise, .half_width = slopes.half_width};
    search.samples = {0, std::min(contacts.front().first + window, edges.turn - 2)};
    search.sign = -1.0;
    search.free_side = FreeSide::before;
    search.flat = contact_share * edges.contact_slope * std::abs(ends.motion_first);
    edges.entry = outermost_jump(loop, slopes.clock, search);
    search.samples = {edges.turn + 2, n - 1};
    search.sign = 1.0;
    search.free_side = FreeSide::after;
    search.flat = contact_share * edges.contact_slope * std::abs(ends.motion_last);
    edges.exit = outermost_jump(loop, slopes.clock, search);
    const Index last_free = edges.entry ? edges.entry->last - 1 : contacts.front().first - window;
    // a record that begins in contact has the slope of contact there
    const bool begins_free = edges.entry || ends.first <= contact_share * edges.contact_slope * ends.motion_first;
    if (begins_free && last_free + 1 >= min_free) edges.before = IndexRange{0, last_free};
    if (edges.exit && n - (edges.exit->next + 1) >= min_free) edges.after = IndexRange{edges.exit->next + 1, n - 1};
    return edges;
}

ContactEdges contact_edges_of_frames(const Loop& loop) {
    const Array1D& radius = loop.contact_radius;
    const Index n = radius.size();
    ContactEdges edges;
    Index first = 0, last = n - 1;
    while (first < n && !(radius[first] > 0.0)) ++first;
    if (first == n) return edges;
    while (!(radius[last] > 0.0)) --last;
    edges.found = true;
    radius.unaryExpr([](double a) { return a > 0.0 ? a : 0.0; }).maxCoeff(&edges.turn);
    // contact begins and ends between two frames
    Index free = first - 1;
    while (free >= 0 && !(radius[free] == 0.0)) --free;
    if (free + 1 >= min_free) edges.before = IndexRange{0, free};
    free = last + 1;
    while (free < n && !(radius[free] == 0.0)) ++free;
    if (n - free >= min_free) edges.after = IndexRange{free, n - 1};
    return edges;
}

}  // namespace setae::loops
