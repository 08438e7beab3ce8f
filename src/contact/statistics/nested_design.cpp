// SPDX-License-Identifier: GPL-3.0-or-later
#include "nested_design.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include <fmt/format.h>
#include <Eigen/Core>

#include "setae/numerics/dense.hpp"

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

/// Number of the group of each row by its label only, in order of first appearance.
std::vector<int> groups_by_label(const ReplicateData& data, const std::vector<std::size_t>& rows, std::size_t level) {
    std::map<std::string, int> numbers;
    std::vector<int> group;
    for (const auto row : rows)
        group.push_back(
            numbers.try_emplace(data.rows[row].groups[level], static_cast<int>(numbers.size())).first->second);
    return group;
}

int count_of(const std::vector<int>& group) { return *std::max_element(group.begin(), group.end()) + 1; }

/// Span of the groups of surfaces and levels: a level's degrees of freedom are the dimensions it adds.
class Span {
public:
    /// nested: every grouping is within the one before.
    Span(const std::vector<int>& surface, bool nested) : nested_(nested) { (void)dimensions_added_by(surface); }

    int dimensions_added_by(const std::vector<int>& group) {
        int dimensions = count_of(group);
        if (!nested_) {
            const Index before = indicators_.cols();
            indicators_.conservativeResize(static_cast<Index>(group.size()), before + dimensions);
            indicators_.rightCols(dimensions).setZero();
            for (std::size_t i = 0; i < group.size(); ++i) indicators_(static_cast<Index>(i), before + group[i]) = 1.0;
            dimensions = numerics::rank(indicators_);
        }
        return dimensions - std::exchange(dimensions_, dimensions);
    }

private:
    bool nested_;
    Eigen::MatrixXd indicators_;
    int dimensions_ = 0;
};

std::string one_per_surface(const std::string& level) {
    return fmt::format("one {} per surface: the variation between several is not in the standard error", level);
}

/// Adds the levels across surfaces whose variances can be estimated.
void add_crossed(NestedDesign& design, const ReplicateData& data, Span& span) {
    for (std::size_t level = 1; level < data.levels.size(); ++level) {
        if (level_missing(data, level) || !is_crossed(data, data.levels[level])) continue;
        auto group = groups_by_label(data, design.rows, level);
        const int added = span.dimensions_added_by(group), groups = count_of(group);
        if (added > 0) design.levels.push_back({{data.levels[level]}, std::move(group), groups, added, true});
        else design.not_estimable.push_back(one_per_surface(data.levels[level]));
    }
}

}  // namespace

bool is_crossed(const ReplicateData& data, const std::string& level) {
    return std::find(data.crossed.begin(), data.crossed.end(), level) != data.crossed.end();
}

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
            design.not_estimable.push_back(fmt::format("no row names a {}", data.levels[level]));
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

    Span span(design.surface, data.crossed.empty());
    add_crossed(design, data, span);
    for (std::size_t k = 0; k < names.size(); ++k) {
        auto group = groups_at(ordered, k + 2);
        const int added = span.dimensions_added_by(group), groups = count_of(group);
        const auto name = is_crossed(data, names[k]) ? fmt::format("{} on a surface", names[k]) : names[k];
        if (added > 0) design.levels.push_back({{name}, std::move(group), groups, added});
        else if (!design.levels.empty() && !design.levels.back().crossed) design.levels.back().includes.push_back(name);
        else if (!is_crossed(data, names[k])) design.not_estimable.push_back(one_per_surface(names[k]));
    }
    if (!design.crossed() || design.levels.back().groups == design.size()) return design;
    // rows and crossed groups are identical: repeats cannot be estimated
    auto nested = data;
    nested.crossed.clear();
    design = nested_design(nested, rows);
    design.not_estimable.push_back(
        fmt::format("{}: too few rows to distinguish them from repeats; groups with the same name on different "
                    "surfaces are treated as different",
                    fmt::join(data.crossed, ", ")));
    return design;
}

}  // namespace setae::statistics
