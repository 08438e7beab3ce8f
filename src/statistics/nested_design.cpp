// SPDX-License-Identifier: GPL-3.0-or-later
#include "nested_design.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <fmt/format.h>

namespace setae::statistics {
namespace {

/// Numbers of the groups down to each level, in order of first appearance within the group above.
using Path = std::vector<int>;

std::vector<Path> paths_of(const ReplicateData& data, const std::vector<std::size_t>& rows,
                           const std::vector<std::size_t>& levels) {
    std::vector<Path> paths;
    std::map<std::pair<Path, std::string>, int> numbers;
    std::map<Path, int> members;
    for (const auto row : rows) {
        Path path;
        for (const auto level : levels) {
            const auto [known, fresh] = numbers.try_emplace({path, data.rows[row].groups[level]}, 0);
            if (fresh) known->second = members[path]++;
            path.push_back(known->second);
        }
        path.push_back(members[path]++);  // the row itself
        paths.push_back(std::move(path));
    }
    return paths;
}

/// Number of the group of each row down to a depth; rows in order of their paths.
std::vector<int> groups_at(const std::vector<Path>& ordered, std::size_t depth) {
    std::vector<int> group;
    for (std::size_t i = 0; i < ordered.size(); ++i)
        group.push_back(i == 0 ? 0
                               : group.back() + (std::equal(ordered[i].begin(),
                                                            ordered[i].begin() + static_cast<std::ptrdiff_t>(depth),
                                                            ordered[i - 1].begin())
                                                     ? 0
                                                     : 1));
    return group;
}

}  // namespace

bool level_missing(const ReplicateData& data, std::size_t level) {
    return std::all_of(data.rows.begin(), data.rows.end(),
                       [&](const Replicate& row) { return row.groups[level].empty(); });
}

NestedDesign nested_design(const ReplicateData& data, const std::vector<std::size_t>& rows) {
    NestedDesign design;
    std::vector<std::size_t> levels{0};
    std::vector<std::string> names;
    for (std::size_t level = 1; level < data.levels.size(); ++level) {
        if (level_missing(data, level)) {
            design.not_estimable.push_back(fmt::format("no row names its {}", data.levels[level]));
            continue;
        }
        levels.push_back(level);
        names.push_back(data.levels[level]);
    }
    names.emplace_back("repeat");
    const auto paths = paths_of(data, rows, levels);
    std::vector<std::size_t> order(rows.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return paths[a] < paths[b]; });

    std::vector<Path> ordered;
    const auto n = static_cast<Index>(rows.size());
    design.value.resize(n);
    design.known_variance.resize(n);
    for (std::size_t i = 0; i < order.size(); ++i) {
        ordered.push_back(paths[order[i]]);
        const auto row = rows[order[i]];
        design.rows.push_back(row);
        design.value[static_cast<Index>(i)] = data.rows[row].value;
        const double error = data.rows[row].standard_error;
        design.known_variance[static_cast<Index>(i)] = std::isnan(error) ? 0.0 : error * error;
    }
    design.surface = groups_at(ordered, 1);
    for (std::size_t i = 0; i < ordered.size(); ++i)
        if (i == 0 || design.surface[i] != design.surface[i - 1])
            design.surfaces.push_back(data.rows[design.rows[i]].groups[0]);

    int above = static_cast<int>(design.surfaces.size());
    for (std::size_t k = 0; k < names.size(); ++k) {
        auto group = groups_at(ordered, k + 2);
        const int groups = group.back() + 1;
        if (groups > above) design.levels.push_back({{names[k]}, std::move(group), groups, groups - above});
        else if (!design.levels.empty()) design.levels.back().includes.push_back(names[k]);
        else
            design.not_estimable.push_back(
                fmt::format("one {} a surface: what another would give is not in the standard error", names[k]));
        above = groups;
    }
    return design;
}

}  // namespace setae::statistics
