// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/channel_fault.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "channel_fault_search.hpp"
#include "contact_edges.hpp"

namespace setae::loops {
namespace {

std::string message_of(ChannelFault fault) {
    switch (fault) {
        case ChannelFault::force_reversed:
            return "the force seems to have the opposite sign: it falls when the bodies are pressed together, and "
                   "adhesion would be positive; multiply the force by -1";
        case ChannelFault::displacement_reversed:
            return "the displacement seems to have the opposite sign: it falls when the force rises in contact; "
                   "multiply the displacement by -1";
        case ChannelFault::both_reversed:
            return "force and displacement seem to have the opposite sign: in contact both fall when the bodies "
                   "approach, and adhesion would be positive; multiply both by -1";
        case ChannelFault::swapped:
            return "force and displacement seem to be exchanged: the force changes in time as a displacement does, "
                   "and the displacement as a force; exchange the columns";
    }
    throw InternalError("unknown fault of a channel");
}

/// A contact with a jump of the right sign: slopes also come from drift, and small jumps from a change of speed.
bool makes_sense(const Loop& loop) {
    constexpr double min_share = 0.01;  // share of the range of the force
    const double range = loop.force.maxCoeff() - loop.force.minCoeff();
    const ContactEdges edges = find_contact_edges(loop);
    const auto jumps = [&](const std::optional<ForceJump>& jump) {
        return jump && std::abs(jump->size) > min_share * range;
    };
    return edges.found && (jumps(edges.entry) || jumps(edges.exit));
}

Loop with(const Array1D& force, const Array1D& displacement, const Array1D& time) {
    return {.time = time, .force = force, .displacement = displacement};
}

/// Σ of squared residuals of the line through samples, from sums of powers.
class LineSums {
public:
    void add(double x, double y) {
        n_ += 1.0;
        x_ += x;
        y_ += y;
        xx_ += x * x;
        xy_ += x * y;
        yy_ += y * y;
    }
    void remove(double x, double y) {
        n_ -= 1.0;
        x_ -= x;
        y_ -= y;
        xx_ -= x * x;
        xy_ -= x * y;
        yy_ -= y * y;
    }
    [[nodiscard]] double squares() const {
        const double spread = xx_ - x_ * x_ / n_, shared = xy_ - x_ * y_ / n_, all = yy_ - y_ * y_ / n_;
        return std::max(spread > 0.0 ? all - shared * shared / spread : all, 0.0);
    }

private:
    double n_ = 0.0, x_ = 0.0, y_ = 0.0, xx_ = 0.0, xy_ = 0.0, yy_ = 0.0;
};

/// Share of a series' variance that remains after the best two straight lines in sequence.
double left_by_two_lines(const Array1D& series) {
    constexpr Index fewest = 3;
    const Index n = series.size();
    const double level = series.mean();
    const auto x = [&](Index i) { return static_cast<double>(2 * i - n) / static_cast<double>(n); };
    LineSums before, after;
    for (Index i = 0; i < n; ++i) after.add(x(i), series[i] - level);
    double least = INFINITY;
    for (Index i = 0; i < n; ++i) {
        before.add(x(i), series[i] - level);
        after.remove(x(i), series[i] - level);
        if (i + 1 >= fewest && n - 1 - i >= fewest) least = std::min(least, before.squares() + after.squares());
    }
    return least / (series - level).square().sum();
}

/// A stage that comes and goes draws two straight lines; a force has the jumps and bends of contact.
bool columns_look_swapped(const Loop& loop) {
    constexpr double straight = 0.02, bent = 0.1;
    return left_by_two_lines(loop.force) < straight && left_by_two_lines(loop.displacement) > bent;
}

}  // namespace

std::string to_string(ChannelFault fault) {
    switch (fault) {
        case ChannelFault::force_reversed: return "force_reversed";
        case ChannelFault::displacement_reversed: return "displacement_reversed";
        case ChannelFault::both_reversed: return "both_reversed";
        case ChannelFault::swapped: return "swapped";
    }
    throw InternalError("unknown fault of a channel");
}

ChannelFaultError::ChannelFaultError(ChannelFault fault) : UndefinedDataError(message_of(fault)), fault_(fault) {}

std::optional<ChannelFault> channel_fault(const Loop& loop) {
    const Array1D &force = loop.force, &displacement = loop.displacement, &time = loop.time;
    const auto make_sense_swapped = [&] {
        for (const double force_sign : {1.0, -1.0})
            for (const double displacement_sign : {1.0, -1.0})
                if (makes_sense(with(force_sign * displacement, displacement_sign * force, time))) return true;
        return false;
    };
    if (columns_look_swapped(loop) && make_sense_swapped()) return ChannelFault::swapped;
    if (makes_sense(with(-force, displacement, time))) return ChannelFault::force_reversed;
    if (makes_sense(with(force, -displacement, time))) return ChannelFault::displacement_reversed;
    if (makes_sense(with(-force, -displacement, time))) return ChannelFault::both_reversed;
    // a stage whose speed changes draws no straight lines
    if (make_sense_swapped()) return ChannelFault::swapped;
    return std::nullopt;
}

}  // namespace setae::loops
