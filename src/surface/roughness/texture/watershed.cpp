// SPDX-License-Identifier: GPL-3.0-or-later
#include "watershed.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::texture {
namespace {

using Label = std::int32_t;
constexpr Label none = -1;

/// Disjoint sets, each represented by one member.
class Sets {
public:
    explicit Sets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), Label{0}); }
    Label find(Label k) {
        while (parent_[static_cast<std::size_t>(k)] != k) {
            auto& parent = parent_[static_cast<std::size_t>(k)];
            parent = parent_[static_cast<std::size_t>(parent)];
            k = parent;
        }
        return k;
    }
    /// `child` becomes part of `root`; both are the representatives of their sets.
    void join(Label root, Label child) { parent_[static_cast<std::size_t>(child)] = root; }

private:
    std::vector<Label> parent_;
};

constexpr std::array<std::array<Index, 2>, 8> neighbours{
    {{-1, -1}, {-1, 0}, {-1, 1}, {0, -1}, {0, 1}, {1, -1}, {1, 0}, {1, 1}}};
constexpr std::size_t first_forward = 4;  ///< of these eight, those after the point in storage order

/// Heights with the upward sign, and neighbours across periodic edges.
class Grid {
public:
    Grid(const topography::HeightMap& map, Up up) : map_(map), sign_(static_cast<double>(static_cast<int>(up))) {}

    [[nodiscard]] Index nx() const { return map_.heights.rows(); }
    [[nodiscard]] Index ny() const { return map_.heights.cols(); }
    [[nodiscard]] double at(Index point) const { return sign_ * map_.heights.data()[point]; }
    /// Calls visitor(neighbour) for the neighbours of (i, j) from the first one on, without those beyond an open edge.
    template <class Visitor>
    void for_neighbours(Index i, Index j, std::size_t first, Visitor visitor) const {
        const bool inside = i > 0 && j > 0 && i + 1 < nx() && j + 1 < ny();
        const Index point = i * ny() + j;
        for (auto k = first; k < neighbours.size(); ++k) {
            const auto& [down, along] = neighbours[k];
            visitor(inside ? point + down * ny() + along : neighbour(i + down, j + along));
        }
    }

private:
    [[nodiscard]] Index neighbour(Index i, Index j) const {
        if (map_.periodic) return (i + nx()) % nx() * ny() + (j + ny()) % ny();
        return i < 0 || j < 0 || i >= nx() || j >= ny() ? none : i * ny() + j;
    }

    const topography::HeightMap& map_;
    double sign_;
};

/// The basins of a grid: the hill of every defined point before hills are joined.
struct Basins {
    std::vector<Label> of_point;
    std::vector<Index> peak;     ///< of each basin
    std::vector<char> complete;  ///< whether it does not touch edges and undefined points
};

Basins basins_of(const Grid& grid, parallel::Threads threads) {
    const auto n = static_cast<std::size_t>(grid.nx() * grid.ny());
    if (n > static_cast<std::size_t>(INT32_MAX))
        throw InvalidArgument("the map has more than 2³¹ points, too many for watersheds; crop it");
    std::vector<Label> uphill(n, none);
    std::vector<char> rim(n, 0);
    parallel::for_each_index(static_cast<std::size_t>(grid.nx()), threads, [&](std::size_t row) {
        const auto i = static_cast<Index>(row);
        for (Index j = 0; j < grid.ny(); ++j) {
            const auto point = i * grid.ny() + j;
            const double height = grid.at(point);
            if (std::isnan(height)) continue;
            auto best = point;
            double highest = height;
            grid.for_neighbours(i, j, 0, [&](Index other) {
                const double adjacent = other == none ? undefined : grid.at(other);
                if (std::isnan(adjacent)) rim[static_cast<std::size_t>(point)] = 1;
                else if (adjacent > highest) {
                    best = other;
                    highest = adjacent;
                }
            });
            uphill[static_cast<std::size_t>(point)] = static_cast<Label>(best);
        }
    });
    // tops of one plateau are one peak
    std::optional<Sets> tops;  // few maps have plateaus
    for (Index i = 0; i < grid.nx(); ++i)
        for (Index j = 0; j < grid.ny(); ++j) {
            const auto point = static_cast<Label>(i * grid.ny() + j);
            if (uphill[static_cast<std::size_t>(point)] != point) continue;
            grid.for_neighbours(i, j, 0, [&](Index other) {
                if (other == none || uphill[static_cast<std::size_t>(other)] != static_cast<Label>(other) ||
                    grid.at(other) != grid.at(point))
                    return;
                if (!tops) tops.emplace(n);
                const auto a = tops->find(point), b = tops->find(static_cast<Label>(other));
                if (a != b) tops->join(std::min(a, b), std::max(a, b));
            });
        }
    Basins basins{std::vector<Label>(n, none), {}, {}};
    std::vector<Label> path;
    for (std::size_t start = 0; start < n; ++start) {
        if (uphill[start] == none) continue;
        path.clear();
        auto point = static_cast<Label>(start);
        while (basins.of_point[static_cast<std::size_t>(point)] == none &&
               uphill[static_cast<std::size_t>(point)] != point) {
            path.push_back(point);
            point = uphill[static_cast<std::size_t>(point)];
        }
        auto label = basins.of_point[static_cast<std::size_t>(point)];
        if (label == none) {
            const auto top = tops ? tops->find(point) : point;
            label = basins.of_point[static_cast<std::size_t>(top)];
            if (label == none) {
                label = static_cast<Label>(basins.peak.size());
                basins.peak.push_back(top);
                basins.complete.push_back(1);
                basins.of_point[static_cast<std::size_t>(top)] = label;
            }
            basins.of_point[static_cast<std::size_t>(point)] = label;
        }
        for (const auto step : path) basins.of_point[static_cast<std::size_t>(step)] = label;
    }
    for (std::size_t point = 0; point < n; ++point)
        if (rim[point] != 0) basins.complete[static_cast<std::size_t>(basins.of_point[point])] = 0;
    return basins;
}

/// Two basins that touch, and the height of the path from one to the other.
struct Saddle {
    double height;
    Label a, b;
};

/// Whether a saddle is processed before another one, from the highest down; a strict order for two that differ.
bool is_before(const Saddle& a, const Saddle& b) {
    if (a.height != b.height) return a.height > b.height;
    return a.a != b.a ? a.a < b.a : a.b < b.b;
}

/// The highest saddle of each pair of neighbouring points, in the order of the points: if basins touch along a border,
/// contacts are consecutive and only the highest of such a run is kept.
std::vector<Saddle> contacts_of(const Grid& grid, const Basins& basins) {
    std::vector<Saddle> contacts;
    const Index ny = grid.ny();
    const auto all_alike = [&](Index i, Index j) {
        if (j == 0 || j + 1 == ny || i + 1 == grid.nx()) return false;
        const Label* const label = basins.of_point.data() + i * ny + j;
        return ((label[1] ^ *label) | (label[ny - 1] ^ *label) | (label[ny] ^ *label) | (label[ny + 1] ^ *label)) == 0;
    };
    for (Index i = 0; i < grid.nx(); ++i)
        for (Index j = 0; j < grid.ny(); ++j) {
            const auto point = i * grid.ny() + j;
            const auto label = basins.of_point[static_cast<std::size_t>(point)];
            if (label == none || all_alike(i, j)) continue;
            grid.for_neighbours(i, j, first_forward, [&](Index other) {
                if (other == none) return;
                const auto adjacent = basins.of_point[static_cast<std::size_t>(other)];
                if (adjacent == none || adjacent == label) return;
                const Saddle found{std::min(grid.at(point), grid.at(other)), std::min(label, adjacent),
                                   std::max(label, adjacent)};
                if (contacts.empty() || contacts.back().a != found.a || contacts.back().b != found.b)
                    contacts.push_back(found);
                else contacts.back().height = std::max(contacts.back().height, found.height);
            });
        }
    return contacts;
}

/// The saddles that connect basins not connected by higher ones, from the highest down: the maximum spanning forest,
/// grown from all basins simultaneously, so only the saddles in it are sorted.
/// Source: Borůvka 1926; Nešetřil, Milková, Nešetřilová, Discrete Math. 233 (2001) 3.
std::vector<Saddle> saddles_of(const Grid& grid, const Basins& basins) {
    auto contacts = contacts_of(grid, basins);
    Sets connected(basins.peak.size());
    std::vector<Saddle> saddles;
    constexpr std::size_t no_contact = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> first(basins.peak.size());
    while (!contacts.empty()) {
        std::fill(first.begin(), first.end(), no_contact);
        std::size_t kept = 0;
        for (const auto& contact : contacts) {
            const auto a = connected.find(contact.a), b = connected.find(contact.b);
            if (a == b) continue;
            contacts[kept] = contact;
            for (const auto end : {a, b}) {
                auto& best = first[static_cast<std::size_t>(end)];
                if (best == no_contact || is_before(contacts[kept], contacts[best])) best = kept;
            }
            ++kept;
        }
        contacts.resize(kept);
        for (const auto best : first) {
            if (best == no_contact) continue;
            const auto a = connected.find(contacts[best].a), b = connected.find(contacts[best].b);
            if (a == b) continue;  // already selected from the other side
            connected.join(std::min(a, b), std::max(a, b));
            saddles.push_back(contacts[best]);
        }
    }
    std::sort(saddles.begin(), saddles.end(), is_before);
    return saddles;
}

}  // namespace

std::vector<Peak> significant_peaks(const topography::HeightMap& map, Up up, double least, parallel::Threads threads) {
    const Grid grid(map, up);
    auto basins = basins_of(grid, threads);
    const auto count = basins.peak.size();
    // from the highest saddle down: of two regions that meet, the one with the lower peak is joined to the adjacent
    // hill, or remains a hill
    Sets lands(count), hills(count);
    const auto peak_height = [&](Label basin) { return grid.at(basins.peak[static_cast<std::size_t>(basin)]); };
    for (const auto& saddle : saddles_of(grid, basins)) {
        auto higher = lands.find(saddle.a), lower = lands.find(saddle.b);
        if (higher == lower) continue;
        auto adjacent_hill = hills.find(saddle.a);
        if (peak_height(lower) > peak_height(higher)) {
            std::swap(higher, lower);
            adjacent_hill = hills.find(saddle.b);
        }
        if (peak_height(lower) - saddle.height < least) {
            const auto joined = hills.find(lower);
            // the higher peak of the two is that of the hill
            if (peak_height(joined) > peak_height(adjacent_hill))
                basins.peak[static_cast<std::size_t>(adjacent_hill)] = basins.peak[static_cast<std::size_t>(joined)];
            auto& complete = basins.complete[static_cast<std::size_t>(adjacent_hill)];
            complete = complete != 0 && basins.complete[static_cast<std::size_t>(joined)] != 0 ? 1 : 0;
            hills.join(adjacent_hill, joined);
        }
        lands.join(higher, lower);
    }
    std::vector<Peak> peaks;
    for (Label basin = 0; basin < static_cast<Label>(count); ++basin) {
        if (hills.find(basin) != basin || basins.complete[static_cast<std::size_t>(basin)] == 0) continue;
        const auto point = basins.peak[static_cast<std::size_t>(basin)];
        peaks.push_back({point / grid.ny(), point % grid.ny(), map.heights.data()[point]});
    }
    std::sort(peaks.begin(), peaks.end(),
              [](const Peak& a, const Peak& b) { return a.i != b.i ? a.i < b.i : a.j < b.j; });
    return peaks;
}

}  // namespace setae::texture
