// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/clock_alignment.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <Eigen/Cholesky>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"
#include "setae/loops/segments.hpp"

namespace setae::loops {
namespace {

constexpr Index min_frames = 20;
constexpr Index max_frames_at_first = 2000;  ///< limit of the search over all offsets
constexpr double onset_reach = 3.0;          ///< frames to both sides of the offset from the onset
constexpr int fine_steps = 40;               ///< steps of the refined search per frame

void require_clock(const Array1D& time, Index size, const char* subject) {
    if (time.size() != size || size < 2)
        throw InvalidArgument(
            fmt::format("{}: {} times for {} values; expected one time per value and at least two values", subject,
                        time.size(), size));
    for (Index i = 0; i < size; ++i)
        if (!std::isfinite(time[i]) || (i > 0 && time[i] <= time[i - 1]))
            throw InvalidArgument(
                fmt::format("{}: time does not increase at row {}; sort the rows by time", subject, i + 1));
}

void require_record(const Loop& force) {
    require_clock(force.time, force.force.size(), "force record");
    const auto n = force.displacement.size();
    if (n != 0 && n != force.force.size())
        throw InvalidArgument(fmt::format(
            "force record: {} displacements for {} forces; expected one per force or none", n, force.force.size()));
    if (!force.force.isFinite().all() || !force.displacement.isFinite().all())
        throw InvalidArgument("force record: a force or displacement is undefined; leave out such rows");
}

/// Frames with a radius, both scaled to be of order 1.
struct Frames {
    Array1D time, radius;
    double interval = 0.0;
};

/// Three standard deviations of the noise of radii, from their second differences: smaller radii are no contact.
double min_radius(const std::vector<double>& radii) {
    std::vector<double> differences;
    for (std::size_t i = 2; i < radii.size(); ++i)
        differences.push_back(std::abs(radii[i] - 2.0 * radii[i - 1] + radii[i - 2]));
    return 3.0 * 1.4826 * upper_median(std::move(differences)) /
           std::sqrt(6.0);  // 1.4826: median of normal deviates to standard deviation
}

Frames usable_frames(const CameraRecord& camera) {
    std::vector<double> time, radius, steps;
    for (Index i = 0; i < camera.time.size(); ++i) {
        if (i > 0) steps.push_back(camera.time[i] - camera.time[i - 1]);
        if (!std::isfinite(camera.contact_radius[i])) continue;
        time.push_back(camera.time[i]);
        radius.push_back(camera.contact_radius[i]);
    }
    const auto n = static_cast<Index>(time.size());
    if (n < min_frames)
        throw UndefinedDataError(
            fmt::format("{} frames have a contact radius; expected at least {} to align the clocks", n, min_frames));
    Frames frames{Eigen::Map<const Array1D>(time.data(), n), Eigen::Map<const Array1D>(radius.data(), n), 0.0};
    frames.interval = upper_median(std::move(steps));
    const double largest = frames.radius.abs().maxCoeff();
    if (!(largest > 0.0) || frames.radius.maxCoeff() == frames.radius.minCoeff())
        throw UndefinedDataError("the contact radius never changes, so that the clocks cannot be aligned");
    const double least = min_radius(radius);
    frames.radius = (frames.radius < least).select(0.0, frames.radius / largest);
    return frames;
}

/// Frames of free flight and of the first loading: where adhesion has hysteresis, force is a function of the radius
/// there only.
Frames before_unloading(const Frames& frames) {
    constexpr double share = 0.98;  // share of the largest radius at which loading ends
    const double top = share * frames.radius.maxCoeff();
    std::vector<double> time, radius;
    bool loading = true;
    for (Index i = 0; i < frames.time.size(); ++i) {
        loading = loading && frames.radius[i] < top;
        if (!loading && frames.radius[i] > 0.0) continue;
        time.push_back(frames.time[i]);
        radius.push_back(frames.radius[i]);
    }
    const auto n = static_cast<Index>(time.size());
    return {Eigen::Map<const Array1D>(time.data(), n), Eigen::Map<const Array1D>(radius.data(), n), frames.interval};
}

/// Every so many frames that no more than `most` are left, for a first search.
Frames thinned(const Frames& frames, Index most) {
    const Index stride = (frames.time.size() + most - 1) / most;
    const Index n = (frames.time.size() - 1) / stride + 1;
    Frames result{Array1D(n), Array1D(n), frames.interval * static_cast<double>(stride)};
    for (Index i = 0; i < n; ++i) {
        result.time[i] = frames.time[i * stride];
        result.radius[i] = frames.radius[i * stride];
    }
    return result;
}

Array1D standardised(const Array1D& values) {
    if (values.size() == 0) return values;
    const Array1D centred = values - values.mean();
    const double scale = centred.abs().maxCoeff();
    return scale > 0.0 ? Array1D(centred / scale) : centred;
}

/// Means over the samples within half a width of each: otherwise noise between the frames would determine the best
/// offset.
Array1D averaged(const Array1D& time, const Array1D& values, double width) {
    if (values.size() == 0) return values;
    Array1D sums(values.size() + 1), means(values.size());
    sums[0] = 0.0;
    for (Index i = 0; i < values.size(); ++i) sums[i + 1] = sums[i] + values[i];
    Index first = 0, end = 0;
    for (Index i = 0; i < values.size(); ++i) {
        while (time[first] < time[i] - 0.5 * width) ++first;
        while (end < values.size() && time[end] <= time[i] + 0.5 * width) ++end;
        const Index reach = std::min(i - first, end - 1 - i);  // as far on both sides
        means[i] = (sums[i + reach + 1] - sums[i - reach]) / static_cast<double>(2 * reach + 1);
    }
    return means;
}

/// The relation between F, δ and a at one offset.
struct Trial {
    double residual = 0.0;  ///< sum of squares
    double total = 0.0;     ///< sum of squares of forces about their mean
    Index frames = 0;
    double neighbours = 0.0;  ///< correlation of residuals of successive frames

    [[nodiscard]] double explained() const { return total > 0.0 ? 1.0 - residual / total : 0.0; }
};

class Search {
public:
    Search(const Loop& force, Frames frames)
        : time_(force.time),
          force_(standardised(averaged(force.time, force.force, 0.5 * frames.interval))),
          displacement_(standardised(averaged(force.time, force.displacement, 0.5 * frames.interval))),
          frames_(std::move(frames)) {}

    /// Fits the relation with the frames within the force record.
    [[nodiscard]] Trial operator()(double offset) const {
        std::vector<Eigen::Vector4d> rows;
        std::vector<double> forces;
        Index at = 1;
        for (Index i = 0; i < frames_.time.size(); ++i) {
            const double t = frames_.time[i] + offset;
            if (t < time_[0] || t > time_[time_.size() - 1]) continue;
            at = std::max<Index>(1, std::lower_bound(time_.begin() + at, time_.end(), t) - time_.begin());
            const double share = (t - time_[at - 1]) / (time_[at] - time_[at - 1]);
            const auto between = [&](const Array1D& series) {
                return series[at - 1] + share * (series[at] - series[at - 1]);
            };
            const double a = frames_.radius[i];
            rows.emplace_back(1.0, a, displacement_.size() ? a * between(displacement_) : a * std::sqrt(std::abs(a)),
                              a * a * a);
            forces.push_back(between(force_));
        }
        return fitted(rows, forces);
    }

    [[nodiscard]] double interval() const { return frames_.interval; }
    [[nodiscard]] const Array1D& frame_times() const { return frames_.time; }

private:
    [[nodiscard]] static Trial fitted(const std::vector<Eigen::Vector4d>& rows, const std::vector<double>& forces) {
        Trial trial{0.0, 0.0, static_cast<Index>(rows.size()), 0.0};
        if (trial.frames < 8) return trial;
        Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
        Eigen::Vector4d right = Eigen::Vector4d::Zero();
        double mean = 0.0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            normal += rows[i] * rows[i].transpose();
            right += rows[i] * forces[i];
            mean += forces[i];
        }
        mean /= static_cast<double>(rows.size());
        const Eigen::Vector4d solution = normal.ldlt().solve(right);
        double before = 0.0, products = 0.0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const double residual = forces[i] - rows[i].dot(solution);
            trial.residual += residual * residual;
            products += i > 0 ? residual * before : 0.0;
            before = residual;
            trial.total += (forces[i] - mean) * (forces[i] - mean);
        }
        trial.neighbours = trial.residual > 0.0 ? products / trial.residual : 0.0;
        return trial;
    }

    const Array1D& time_;
    Array1D force_, displacement_;
    Frames frames_;
};

struct Range {
    double lower = 0.0, upper = 0.0;
};

/// Offsets at which enough of the frames are within the force record.
Range searched(const Loop& force, const Array1D& frames, const ClockOptions& options) {
    if (!(options.min_overlap > 0.0 && options.min_overlap <= 1.0))
        throw InvalidArgument(
            fmt::format("the overlap of both records must be at least {}; expected a share above 0 and up to 1",
                        options.min_overlap));
    const double end = force.time[force.time.size() - 1];
    const auto n = frames.size();
    const auto needed =
        std::clamp<Index>(static_cast<Index>(std::ceil(options.min_overlap * static_cast<double>(n))), 1, n);
    const Range possible{force.time[0] - frames[n - needed], end - frames[needed - 1]};
    const Range range{options.smallest_offset.value_or(possible.lower),
                      options.largest_offset.value_or(possible.upper)};
    if (!std::isfinite(range.lower) || !std::isfinite(range.upper))
        throw InvalidArgument("the first or last offset to search is not finite");
    if (range.lower > range.upper)
        throw InvalidArgument(
            fmt::format("the range of offsets to search is empty: {} s to {} s", range.lower, range.upper));
    return range;
}

struct Candidate {
    double offset = 0.0;
    Trial trial;
};

/// Trials at even steps; those that see too little of the contact are left out.
std::vector<Candidate> scan(const Search& search, const Range& range, double step, Index fewest, double min_total) {
    std::vector<Candidate> candidates;
    const auto steps = static_cast<Index>(std::ceil((range.upper - range.lower) / step));
    for (Index i = 0; i <= steps; ++i) {
        const double offset = std::min(range.lower + static_cast<double>(i) * step, range.upper);
        const auto trial = search(offset);
        if (trial.frames >= fewest && trial.total > min_total * static_cast<double>(trial.frames))
            candidates.push_back({offset, trial});
    }
    return candidates;
}

const Candidate& best_of(const std::vector<Candidate>& candidates) {
    return *std::max_element(candidates.begin(), candidates.end(),
                             [](const auto& a, const auto& b) { return a.trial.explained() < b.trial.explained(); });
}

/// Standard error: a quarter of the range in which the sum of squares exceeds its minimum by no more than two standard
/// errors would. The sum decreases in steps where a frame passes a jump, so that its curvature is not meaningful. NaN
/// where it never does.
double standard_error(const Search& search, const Candidate& best) {
    const double correlation = std::clamp(best.trial.neighbours, 0.0, 0.95);
    const double independent =
        std::max(1.0, static_cast<double>(best.trial.frames - 5) * (1.0 - correlation) / (1.0 + correlation));
    const double limit = best.trial.residual * (1.0 + 4.0 / independent);
    const double step = search.interval() / fine_steps;
    constexpr int most = 20 * fine_steps;
    int range = 0;
    for (const double direction : {-1.0, 1.0})
        for (int k = 1;; ++k, ++range) {
            if (k == most) return undefined;
            const auto trial = search(best.offset + direction * k * step);
            if (trial.frames < best.trial.frames / 2 || trial.residual > limit) break;
        }
    // the position of a jump within a frame is unknown: two jumps with uniform distributions
    const double hidden = search.interval() / std::sqrt(2.0 * 12.0);
    return std::hypot(0.25 * step * static_cast<double>(range + 2), hidden);
}

/// Offset at which the first frame in contact is after the jump-in and the frame before it before.
std::optional<Estimate> by_onset(const Loop& force, const Frames& frames) {
    std::optional<double> parted, touching;
    for (Index i = 0; i + 1 < frames.time.size() && !touching; ++i) {
        if (frames.radius[i] > 0.0 && frames.radius[i + 1] > 0.0) touching = frames.time[i];
        else parted = frames.time[i];
    }
    if (!parted || !touching) return std::nullopt;
    try {
        Loop without_radii = force;
        without_radii.contact_radius = Array1D();
        const auto segments = find_segments(without_radii);
        if (segments.contacts.empty() || !segments.contacts.front().jump_in) return std::nullopt;
        const auto jump = *segments.contacts.front().jump_in;
        const double at = 0.5 * (force.time[jump.first] + force.time[jump.last]);
        const double width = std::hypot(*touching - *parted, force.time[jump.last] - force.time[jump.first]);
        return Estimate{.value = at - 0.5 * (*parted + *touching),
                        .standard_error = width / std::sqrt(12.0),
                        .method = "first frame in contact against the jump-in"};
    } catch (const Error&) {
        return std::nullopt;  // no jump to go by
    }
}

std::string doubt_of(const ClockAlignment& found, const Range& range) {
    const double step = 0.5 * found.frame_interval;
    if (!(found.offset.standard_error >= 0.0)) return "the agreement has no maximum at the best offset";
    if (range.upper - range.lower > 4.0 * step &&
        (found.offset.value - range.lower < step || range.upper - found.offset.value < step))
        return "the best offset lies at the end of the search";
    if (found.explained < 0.9)
        return fmt::format("the radii explain only {:.0f} % of the variance of the force", 100.0 * found.explained);
    if (found.method == "F, a" && !found.by_onset)
        return "without displacement and without a jump-in the offset depends on loading only";
    if (1.0 - found.explained > 0.7 * (1.0 - found.runner_up))
        return "another offset, five frames away or more, explains nearly as much";
    if (found.by_onset && std::abs(found.by_onset->value - found.offset.value) >
                              2.0 * found.frame_interval + 3.0 * found.offset.standard_error)
        return fmt::format("the first contact by itself gives {:.4g} s", found.by_onset->value);
    return {};
}

}  // namespace

ClockAlignment align_clocks(const Loop& force, const CameraRecord& camera, const ClockOptions& options) {
    require_record(force);
    require_clock(camera.time, camera.contact_radius.size(), "camera record");
    const auto all = usable_frames(camera);
    const bool displaced = force.displacement.size() > 0;
    const auto frames = displaced ? all : before_unloading(all);
    if (frames.time.size() < min_frames)
        throw UndefinedDataError(
            fmt::format("{} frames lie before unloading or out of contact; expected at least {} to align the clocks",
                        frames.time.size(), min_frames));
    const auto onset = by_onset(force, all);
    auto range = searched(force, frames.time, options);
    // without displacement loading may also fit elsewhere: the first contact limits the search
    if (!displaced && onset && onset->value > range.lower && onset->value < range.upper)
        range = {std::max(range.lower, onset->value - onset_reach * all.interval),
                 std::min(range.upper, onset->value + onset_reach * all.interval)};
    // the frames must see a tenth of the record's changes of force
    const Array1D forces = standardised(force.force);
    const double min_total = 0.01 * (forces - forces.mean()).square().mean();
    const auto scanned = [&](const Search& search, const Range& within, double step) {
        const auto fewest =
            static_cast<Index>(options.min_overlap * static_cast<double>(search.frame_times().size())) - 1;
        return scan(search, within, step, std::max<Index>(8, fewest), min_total);
    };
    const auto around = [&](double offset, double reach) {
        return Range{std::max(range.lower, offset - reach), std::min(range.upper, offset + reach)};
    };

    const Search rough(force, thinned(frames, max_frames_at_first)), search(force, frames);
    const auto coarse = scanned(rough, range, 0.5 * rough.interval());
    if (coarse.empty())
        throw UndefinedDataError(
            fmt::format("no offset between {:.4g} s and {:.4g} s places half of the frames on a part of the record "
                        "where the force changes; check the clocks",
                        range.lower, range.upper));
    auto best = best_of(coarse);
    const double rough_offset = best.offset;
    for (const auto& [reach, step] : {std::pair{1.5 * rough.interval(), 0.5 * search.interval()},
                                      std::pair{1.5 * search.interval(), search.interval() / fine_steps}})
        if (const auto finer = scanned(search, around(best.offset, reach), step); !finer.empty()) best = best_of(finer);

    ClockAlignment found;
    found.offset = {.value = best.offset,
                    .standard_error = standard_error(search, best),
                    .method = "profile of the sum of squares"};
    found.explained = best.trial.explained();
    for (const auto& other : coarse)
        if (std::abs(other.offset - rough_offset) >= 5.0 * rough.interval())
            found.runner_up = std::max(found.runner_up, other.trial.explained());
    found.by_onset = onset;
    found.frame_interval = search.interval();
    found.frames = best.trial.frames;
    found.method = displaced ? "F, δ, a" : "F, a";
    found.doubt = doubt_of(found, range);
    return found;
}

}  // namespace setae::loops
