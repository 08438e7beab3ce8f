// SPDX-License-Identifier: GPL-3.0-or-later
#include "same_measurements.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>

#include <fmt/format.h>

#include "setae/core/text.hpp"

namespace setae::study {
namespace {

/// Numbers that were written with six digits in one file and all of them in another are the same numbers.
constexpr double rounding = 1e-5;

bool alike(double a, double b) { return std::abs(a - b) <= rounding * std::max(std::abs(a), std::abs(b)); }

/// Within the rounding of the largest of them; NaN at the same places.
bool alike(const Array1D& a, const Array1D& b) {
    if (a.size() != b.size()) return false;
    double largest = 0.0;
    for (Index i = 0; i < a.size(); ++i)
        if (std::isfinite(a[i])) largest = std::max(largest, std::abs(a[i]));
    for (Index i = 0; i < a.size(); ++i) {
        if (std::isfinite(a[i]) != std::isfinite(b[i])) return false;
        if (std::isfinite(a[i]) && std::abs(a[i] - b[i]) > rounding * largest) return false;
    }
    return true;
}

/// Items that are copies of each other, by the number of one of them.
class Groups {
public:
    explicit Groups(std::size_t items) : first_(items) { std::iota(first_.begin(), first_.end(), std::size_t{0}); }

    void join(std::size_t a, std::size_t b) {
        a = first(a);
        b = first(b);
        first_[std::max(a, b)] = std::min(a, b);
    }
    std::size_t first(std::size_t item) {
        while (first_[item] != item) item = first_[item] = first_[first_[item]];
        return item;
    }
    /// Number of these items.
    std::size_t count(const std::vector<std::size_t>& items) {
        return static_cast<std::size_t>(
            std::ranges::count_if(items, [&](std::size_t item) { return first(item) == item; }));
    }

private:
    std::vector<std::size_t> first_;
};

/// Joins equal items, among neighbours when sorted by their number of values and their size.
void join_alike(Groups& groups, const std::vector<std::size_t>& items,
                const std::function<std::tuple<Index, double>(std::size_t)>& size,
                const std::function<bool(std::size_t, std::size_t)>& same) {
    std::vector<std::pair<std::tuple<Index, double>, std::size_t>> sized;
    for (const auto item : items) sized.emplace_back(size(item), item);
    std::ranges::stable_sort(sized, {}, [](const auto& entry) { return entry.first; });
    for (std::size_t i = 0; i < sized.size(); ++i)
        for (std::size_t k = i + 1; k < sized.size(); ++k) {
            const auto& [of_one, one] = sized[i];
            const auto& [of_other, other] = sized[k];
            if (std::get<0>(of_one) != std::get<0>(of_other) || !alike(std::get<1>(of_one), std::get<1>(of_other)))
                break;
            if (!same(one, other)) continue;
            groups.join(one, other);
            break;  // the next ones are compared with that one
        }
}

/// The first two items that are copies of each other.
std::pair<std::size_t, std::size_t> first_copy(Groups& groups, const std::vector<std::size_t>& items) {
    for (const auto item : items)
        if (groups.first(item) != item) return {groups.first(item), item};
    return {0, 0};
}

std::string listed_again(const std::string& first, const std::string& second) {
    return first == second ? fmt::format("{} is listed more than once", one_line(first))
                           : fmt::format("{} is listed again as {}", one_line(first), one_line(second));
}

bool same_numbers(const MeasurementResult& a, const MeasurementResult& b) {
    return alike(a.real_space.rms_slope, b.real_space.rms_slope) &&
           alike(a.spectrum.wavevector, b.spectrum.wavevector) && alike(a.spectrum.density, b.spectrum.density);
}

bool same_numbers(const loops::Loop& a, const loops::Loop& b) {
    return alike(a.force, b.force) && alike(a.displacement, b.displacement) &&
           alike(a.contact_radius, b.contact_radius);
}

double range(const Array1D& values) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const double value : values)
        if (std::isfinite(value)) {
            least = std::min(least, value);
            most = std::max(most, value);
        }
    return most >= least ? most - least : 0.0;
}

}  // namespace

void look_for_copies(SurfaceResult& surface, const std::vector<std::string>& contents) {
    const auto& all = surface.measurements;
    std::vector<std::size_t> items;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (!all[i].failed()) items.push_back(i);
    Groups groups(all.size());
    if (contents.size() == all.size()) {
        std::map<std::string, std::size_t> known;
        for (const auto i : items)
            if (const auto [at, fresh] = known.emplace(contents[i], i); !fresh) groups.join(at->second, i);
    }
    join_alike(
        groups, items,
        [&](std::size_t i) { return std::tuple(all[i].real_space.defined, all[i].real_space.rms_height); },
        [&](std::size_t a, std::size_t b) { return same_numbers(all[a], all[b]); });
    const auto different = groups.count(items);
    if (different == items.size()) return;
    const auto [first, second] = first_copy(groups, items);
    surface.alerts.push_back(
        {"SAME_MEASUREMENT", surface.name,
         fmt::format("{} measurements of the surface contain {} different ones, {}; each is counted, so that "
                     "intervals are too narrow by a factor of up to {:.2g}",
                     items.size(), different, listed_again(all[first].file, all[second].file),
                     std::sqrt(static_cast<double>(items.size()) / static_cast<double>(different))),
         "list each measurement once"});
}

void look_for_same_loops(StudyResult& result) {
    const auto& all = result.experiments;
    std::vector<std::size_t> items;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i].analysis && !all[i].failed() && !all[i].input.excluded()) items.push_back(i);
    const auto record = [&](std::size_t i) -> const loops::Loop& { return all[i].analysis->corrected; };
    Groups groups(all.size());
    join_alike(
        groups, items, [&](std::size_t i) { return std::tuple(record(i).force.size(), range(record(i).force)); },
        [&](std::size_t a, std::size_t b) { return same_numbers(record(a), record(b)); });
    const auto different = groups.count(items);
    if (different == items.size()) return;
    const auto [first, second] = first_copy(groups, items);
    result.alerts.push_back(
        {"SAME_MEASUREMENT", result.study.title,
         fmt::format("{} loops of the study contain {} different records, {}; each is counted, so that standard "
                     "errors are too small and elastomers or surfaces may agree because they share a record",
                     items.size(), different, listed_again(all[first].input.file, all[second].input.file)),
         "list each loop once, on the elastomer and surface on which it was measured"});
}

}  // namespace setae::study
