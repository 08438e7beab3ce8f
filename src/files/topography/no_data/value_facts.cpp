// SPDX-License-Identifier: GPL-3.0-or-later
#include "value_facts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace setae::topography {
namespace {

constexpr double no_bound = std::numeric_limits<double>::infinity();

/// Position of a scan line within a run of a value or between two runs.
struct LineState {
    bool inside = false;
    Index begin = 0;  ///< of the run or of the gap between runs
};

class BandFacts {
public:
    BandFacts(const std::vector<double>& values, double median, double jump)
        : values_(values), median_(median), jump_(jump) {
        facts.values.resize(values.size());
        facts.least = no_bound;
        facts.greatest = -no_bound;
    }

    void take(const HeightBand& band, Index nx) {
        take_others(band, nx);
        for (std::size_t v = 0; v < values_.size(); ++v) follow(band, nx, v);
    }

    AllFacts facts;

private:
    [[nodiscard]] bool is_value(double height) const {
        return std::find(values_.begin(), values_.end(), height) != values_.end();
    }

    /// Counts, and the range of heights without any of the values.
    void take_others(const HeightBand& band, Index nx) {
        for (Index x = 0; x < nx; ++x)
            for (Index j = 0; j < band.lines; ++j) {
                const double height = band.heights[x * band.distance + j];
                if (std::isnan(height)) continue;
                ++facts.defined;
                if (is_value(height)) continue;
                facts.least = std::min(facts.least, height);
                facts.greatest = std::max(facts.greatest, height);
                for (std::size_t v = 0; v < values_.size(); ++v) {
                    const double middle = median_ + 0.5 * (values_[v] - median_);
                    facts.values[v].beyond += values_[v] > median_ ? height > middle : height < middle;
                    facts.values[v].nearest = std::min(facts.values[v].nearest, std::abs(height - values_[v]));
                }
            }
    }

    /// The runs of one value along the scan lines of a band, all lines together.
    void follow(const HeightBand& band, Index nx, std::size_t number) {
        const double value = values_[number];
        auto& found = facts.values[number];
        std::vector<LineState> lines(static_cast<std::size_t>(band.lines));
        for (Index x = 0; x < nx; ++x) {
            const double* const row = band.heights + x * band.distance;
            for (Index j = 0; j < band.lines; ++j) {
                const bool inside = row[j] == value;
                found.count += inside;
                auto& line = lines[static_cast<std::size_t>(j)];
                if (inside == line.inside) continue;
                if (x > 0) take_step(found, inside ? row[j - band.distance] : row[j], value);
                if (line.begin > 0) (inside ? found.gaps : found.runs).add(static_cast<double>(x - line.begin));
                line = {inside, x};
            }
        }
    }

    void take_step(ValueFacts& found, double adjacent, double value) const {
        if (std::isnan(adjacent) || is_value(adjacent)) return;
        ++found.steps;
        found.jumps += std::abs(adjacent - value) >= jump_;
        found.adjacent.add(adjacent);
    }

    const std::vector<double>& values_;
    double median_, jump_;
};

}  // namespace

void Scatter::add(double number) {
    ++count_;
    const double step = number - mean_;
    mean_ += step / static_cast<double>(count_);
    squares_ += step * (number - mean_);
}

void Scatter::add(const Scatter& other) {
    if (other.count_ == 0) return;
    const auto own = static_cast<double>(count_), more = static_cast<double>(other.count_), all = own + more;
    const double step = other.mean_ - mean_;
    squares_ += other.squares_ + step * step * own * more / all;
    mean_ += step * more / all;
    count_ += other.count_;
}

double Scatter::standard_deviation() const {
    return count_ > 0 ? std::sqrt(squares_ / static_cast<double>(count_)) : 0.0;
}

AllFacts facts_of(const HeightBands& bands, const std::vector<double>& values, double median, double jump) {
    std::vector<BandFacts> parts(bands.count, BandFacts(values, median, jump));
    bands.for_each([&](std::size_t number, const HeightBand& band) { parts[number].take(band, bands.nx); });
    AllFacts all = BandFacts(values, median, jump).facts;
    for (const auto& part : parts) {
        all.defined += part.facts.defined;
        all.least = std::min(all.least, part.facts.least);
        all.greatest = std::max(all.greatest, part.facts.greatest);
        for (std::size_t v = 0; v < values.size(); ++v) {
            auto& sum = all.values[v];
            const auto& more = part.facts.values[v];
            sum.count += more.count;
            sum.beyond += more.beyond;
            sum.nearest = std::min(sum.nearest, more.nearest);
            sum.runs.add(more.runs);
            sum.gaps.add(more.gaps);
            sum.steps += more.steps;
            sum.jumps += more.jumps;
            sum.adjacent.add(more.adjacent);
        }
    }
    return all;
}

}  // namespace setae::topography
