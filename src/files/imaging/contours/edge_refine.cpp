// SPDX-License-Identifier: GPL-3.0-or-later
#include "edge_refine.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Sparse>

#include "setae/core/statistics.hpp"
#include "trace_smoothing.hpp"

namespace setae::imaging {
namespace {

constexpr int max_rounds = 30, rounds_of_search = 4, rounds_of_full_steps = 12, rounds_before_choice = 3,
              max_choices = 4;
constexpr double search_reach = 10.0;             // px
constexpr double first_smoothing = 3.0;           // px
constexpr double at_rest = 0.02;                  // px
constexpr Index min_pixels = 2;                   // near each point of a curve unless it is lost
constexpr double max_move = 1.5;                  // px a round
constexpr double level_stretch = 30.0;            // px along the curve for level and contrast (standard deviation)
constexpr double min_error = 0.02;                // px: residuals from pixels of a picture without noise
constexpr double narrowest = 0.29, widest = 4.0;  // px
constexpr double anchor_weight = 1e7;             // over the information of one point

/// Information from pixels at each point of a curve.
struct Evidence {
    Array1D level, contrast;  ///< a and b of I = a + b shape
    Array1D information;      ///< Σ b² I'²/σ² [1/px²]
    Array1D score;            ///< Σ of −b I' r/σ² [1/px]
};

Array1D spread(const PlaneCurve& curve, const Array1D& values, double deviation) {
    const Index n = values.size(), reach = std::min<Index>(n - 1, static_cast<Index>(std::ceil(3 * deviation)));
    Array1D kernel(reach + 1), result(n);
    for (Index j = 0; j <= reach; ++j)
        kernel[j] = std::exp(-0.5 * static_cast<double>(j * j) / (deviation * deviation));
    for (Index i = 0; i < n; ++i) {
        double sum = kernel[0] * values[i];
        for (Index j = 1; j <= reach; ++j) {
            if (curve.closed || i - j >= 0) sum += kernel[j] * values[curve.at(i - j)];
            if (curve.closed || i + j < n) sum += kernel[j] * values[curve.at(i + j)];
        }
        result[i] = sum;
    }
    return result;
}

/// Scatter about the shape by distance, in bins of a pixel.
class Scatter {
public:
    Scatter(double reach, double floor)
        : reach_(reach),
          floor_(floor),
          squares_(static_cast<std::size_t>(std::ceil(2 * reach)) + 1, 0.0),
          count_(squares_.size(), 0.0) {}
    void add(double distance, double residual) {
        squares_[bin(distance)] += residual * residual;
        count_[bin(distance)] += 1;
    }
    [[nodiscard]] double variance(double distance) const {
        const auto i = bin(distance);
        double squares = 0, count = 0;
        for (auto j = i > 0 ? i - 1 : i; j <= std::min(i + 1, count_.size() - 1); ++j) {
            squares += squares_[j];
            count += count_[j];
        }
        return count > 0 ? std::max(floor_, squares / count) : floor_ + 1;
    }
    [[nodiscard]] double variance_between(double from, double to) const {
        double squares = 0, count = 0;
        for (auto j = bin(from); j <= bin(to); ++j) {
            squares += squares_[j];
            count += count_[j];
        }
        return count > 0 ? std::max(floor_, squares / count) : floor_;
    }

private:
    [[nodiscard]] std::size_t bin(double distance) const {
        return std::min(squares_.size() - 1, static_cast<std::size_t>(std::max(0.0, distance + reach_)));
    }
    double reach_, floor_;
    std::vector<double> squares_, count_;
};

/// One curve during refinement.
class Refinement {
public:
    Refinement(EdgeBand& band, const PlaneCurve& start, const std::vector<Anchor>& anchors)
        : band_(band), curve_(resampled(start, 1.0, false)), anchors_(anchors) {}

    RefinedEdge run(std::optional<double> given) {
        smoothing_ = given.value_or(first_smoothing);
        int choices = given ? max_choices : 0, last_choice = rounds_of_search;
        int quiet = 0;
        for (int round = 0; round < max_rounds; ++round) {
            look(round);
            if (lost_) return lost_edge();
            if (choices < max_choices &&
                (round >= last_choice + rounds_before_choice || (round > last_choice && last_move_ < 0.1))) {
                choose_smoothing();
                ++choices;
                last_choice = round;
            }
            move(round);
            if (choices == max_choices && last_move_ < at_rest) ++quiet;
            else quiet = 0;
            if (quiet == 2) break;
        }
        look(max_rounds);
        if (lost_) return lost_edge();
        if (given) measure_error();
        return result(quiet > 0);
    }

private:
    /// Pixels, shape, levels and scatter at the present curve.
    void look(int round) {
        const bool searching = round < rounds_of_search;
        reach_ = searching ? search_reach : std::clamp(away() + reach_of_slope(), 8.0, 18.0);
        pixels_ = band_.near(curve_, reach_);
        lost_ = static_cast<Index>(pixels_.size()) < min_pixels * curve_.size();
        if (lost_) return;
        const auto profile = edge_profile(pixels_, reach_);
        shape_ = round == 0 ? fitted_shape(profile) : fitted_shape(profile, shape_);
        if (searching && std::abs(shape_.place) > 0.3) {
            shift(shape_.place);
            for (auto& p : pixels_) p.distance -= shape_.place;
        }
        shape_.place = 0;
        if (!shape_.fringe_rules()) shape_.width = freed_of_fit(shape_.width);
        gather();
        lost_ = !(evidence_.information.mean() > 0) || !evidence_.score.isFinite().all();
    }

    /// Too few pixels, or none with information on an edge.
    [[nodiscard]] RefinedEdge lost_edge() const {
        RefinedEdge edge;
        edge.curve = curve_;
        edge.standard_error = Array1D::Constant(curve_.size(), std::numeric_limits<double>::infinity());
        return edge;
    }

    /// Distance from the edge beyond which it has no effect.
    [[nodiscard]] double reach_of_slope() const {
        return shape_.fringe != 0 ? std::max(3 * shape_.width, 2.5 * shape_.fringe_width) : 3 * shape_.width;
    }
    [[nodiscard]] double away() const { return reach_of_slope() + 2.0; }

    /// Width of the edge itself. A trace with error e that follows noise by K̄ = ∫K dq/π has w² + ⟨e²⟩ − 2 N K̄: errors
    /// blur the mean profile, and followed noise makes it steeper.
    [[nodiscard]] double freed_of_fit(double width) const {
        return std::sqrt(std::clamp(width * width - error_squares_ + 2 * noise_ * mean_spline_transfer(smoothing_),
                                    narrowest * narrowest, widest * widest));
    }

    void shift(double distance) {
        const auto n = normals(curve_);
        curve_.x += distance * n.x;
        curve_.y += distance * n.y;
    }

    void gather() {
        const Index n = curve_.size();
        normals_ = normals(curve_);
        Scatter scatter(reach_, 1e-12 + 1e-8 * (shape_.step * shape_.step + shape_.fringe * shape_.fringe));
        for (const auto& p : pixels_) scatter.add(p.distance, p.value - shape_.level - shape_.value(p.distance));
        // twice: levels need the scatter and scatter the levels
        for (int pass = 0; pass < 2; ++pass) {
            levels(scatter);
            Scatter next(reach_, 1e-12 + 1e-8 * (shape_.step * shape_.step + shape_.fringe * shape_.fringe));
            for (const auto& p : pixels_) next.add(p.distance, residual(p));
            scatter = next;
        }
        scatter_ = scatter;
        vacuum_noise_ = std::sqrt(scatter.variance_between(2 * shape_.width, reach_));
        sample_noise_ = std::sqrt(scatter.variance_between(-reach_, -2 * shape_.width));
        evidence_.information = Array1D::Zero(n);
        evidence_.score = Array1D::Zero(n);
        for (const auto& p : pixels_) {
            const double weight = 1.0 / scatter.variance(p.distance), slope = slope_at(p);
            const Index next = curve_.at(p.index + 1);
            const double information = weight * slope * slope, score = -weight * slope * residual(p);
            evidence_.information[p.index] += (1 - p.fraction) * information;
            evidence_.information[next] += p.fraction * information;
            evidence_.score[p.index] += (1 - p.fraction) * score;
            evidence_.score[next] += p.fraction * score;
        }
    }

    void levels(const Scatter& scatter) {
        const Index n = curve_.size();
        Array1D one = Array1D::Zero(n), shape = one, squared = one, grey = one, product = one;
        for (const auto& p : pixels_) {
            const double w = 1.0 / scatter.variance(p.distance), t = shape_.value(p.distance),
                         g = p.value - shape_.level;
            one[p.index] += w;
            shape[p.index] += w * t;
            squared[p.index] += w * t * t;
            grey[p.index] += w * g;
            product[p.index] += w * t * g;
        }
        for (auto* sum : {&one, &shape, &squared, &grey, &product}) *sum = spread(curve_, *sum, level_stretch);
        // the contrast is tied to that of the whole contour with the weight of a tenth of the pixels around
        const Array1D hold = 0.1 * squared;
        const Array1D determinant = (one * (squared + hold) - shape.square()).max(1e-300);
        evidence_.contrast = ((one * (product + hold) - shape * grey) / determinant).max(0.25).min(4.0);
        evidence_.level = shape_.level + (grey - evidence_.contrast * shape) / one.max(1e-300);
    }

    [[nodiscard]] double residual(const BandPixel& p) const {
        return p.value - evidence_.level[p.index] - evidence_.contrast[p.index] * shape_.value(p.distance);
    }
    [[nodiscard]] double slope_at(const BandPixel& p) const {
        return evidence_.contrast[p.index] * shape_.slope(p.distance);
    }

    /// Solves for the displacement along normals with smoothing, and applies it.
    void move(int round) {
        const Index n = curve_.size();
        const Array1D stiffness = local_information() * std::pow(smoothing_, 4);
        Array1D right = evidence_.score;
        std::vector<Eigen::Triplet<double>> entries;
        entries.reserve(static_cast<std::size_t>(12 * n));
        const auto add = [&](Index i, Index j, double value) {
            entries.emplace_back(static_cast<int>(i), static_cast<int>(j), value);
        };
        for (Index k = curve_.closed ? 0 : 1; k < (curve_.closed ? n : n - 1); ++k) {
            const std::array<Index, 3> at{curve_.at(k - 1), k, curve_.at(k + 1)};
            constexpr std::array<double, 3> part{1, -2, 1};
            double bend_x = 0, bend_y = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                bend_x += part[i] * curve_.x[at[i]];
                bend_y += part[i] * curve_.y[at[i]];
            }
            for (std::size_t i = 0; i < 3; ++i) {
                const double nx = normals_.x[at[i]], ny = normals_.y[at[i]];
                right[at[i]] -= stiffness[k] * part[i] * (bend_x * nx + bend_y * ny);
                for (std::size_t j = 0; j < 3; ++j)
                    add(at[i], at[j],
                        stiffness[k] * part[i] * part[j] * (nx * normals_.x[at[j]] + ny * normals_.y[at[j]]));
            }
        }
        hold_anchors(right, entries);
        const double ridge = 1e-6 * std::max(1e-300, evidence_.information.mean());
        for (Index k = 0; k < n; ++k) add(k, k, evidence_.information[k] + ridge);
        Eigen::SparseMatrix<double> matrix(static_cast<int>(n), static_cast<int>(n));
        matrix.setFromTriplets(entries.begin(), entries.end());
        const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
        const Array1D wish = solver.solve(right.matrix()).array();
        const Array1D delta = (round < rounds_of_full_steps ? 1.0 : 0.5) * wish.max(-max_move).min(max_move);
        curve_.x += delta * normals_.x;
        curve_.y += delta * normals_.y;
        moved_ = delta.abs();
        last_move_ = largest_of(moved_);
        even_out();
    }

    /// The displacement that nineteen points in twenty do not exceed.
    [[nodiscard]] static double largest_of(const Array1D& moves) {
        return upper_quantile(std::vector<double>(moves.begin(), moves.end()), 0.95);
    }

    /// Anchors attract the nearest place, between two points, along the normal there.
    void hold_anchors(Array1D& right, std::vector<Eigen::Triplet<double>>& entries) const {
        const double weight = anchor_weight * std::max(1e-300, evidence_.information.mean());
        for (const auto& anchor : anchors_) {
            const auto at = nearest_place(anchor);
            const Index next = curve_.at(at.index + 1);
            const std::array<Index, 2> points{at.index, next};
            const std::array<double, 2> share{1 - at.fraction, at.fraction};
            const double nx = share[0] * normals_.x[at.index] + share[1] * normals_.x[next],
                         ny = share[0] * normals_.y[at.index] + share[1] * normals_.y[next];
            const double off_x = anchor.x - share[0] * curve_.x[at.index] - share[1] * curve_.x[next],
                         off_y = anchor.y - share[0] * curve_.y[at.index] - share[1] * curve_.y[next];
            const double off = (off_x * nx + off_y * ny) / (nx * nx + ny * ny);
            for (std::size_t i = 0; i < 2; ++i) {
                right[points[i]] += weight * share[i] * off;
                for (std::size_t j = 0; j < 2; ++j)
                    entries.emplace_back(static_cast<int>(points[i]), static_cast<int>(points[j]),
                                         weight * share[i] * share[j]);
            }
        }
    }

    struct Place {
        Index index = 0;
        double fraction = 0;
    };

    [[nodiscard]] Place nearest_place(const Anchor& anchor) const {
        Place best;
        double least = 1e300;
        for (Index k = 0; k + (curve_.closed ? 0 : 1) < curve_.size(); ++k) {
            const Index next = curve_.at(k + 1);
            const double ex = curve_.x[next] - curve_.x[k], ey = curve_.y[next] - curve_.y[k],
                         px = anchor.x - curve_.x[k], py = anchor.y - curve_.y[k];
            const double t = std::clamp((px * ex + py * ey) / std::max(1e-300, ex * ex + ey * ey), 0.0, 1.0);
            const double squared = (px - t * ex) * (px - t * ex) + (py - t * ey) * (py - t * ey);
            if (squared < least) {
                least = squared;
                best = {k, t};
            }
        }
        return best;
    }

    void even_out() {
        double shortest = 1e300, longest = 0;
        for (Index k = 0; k + (curve_.closed ? 0 : 1) < curve_.size(); ++k) {
            const double d =
                std::hypot(curve_.x[curve_.at(k + 1)] - curve_.x[k], curve_.y[curve_.at(k + 1)] - curve_.y[k]);
            shortest = std::min(shortest, d);
            longest = std::max(longest, d);
        }
        if (shortest >= 0.75 && longest <= 1.3) return;
        const auto before = curve_.size();
        curve_ = resampled(curve_, 1.0, true);
        const Array1D moved = moved_;
        moved_.resize(curve_.size());
        for (Index k = 0; k < curve_.size(); ++k) moved_[k] = moved[k * before / curve_.size()];
    }

    [[nodiscard]] Array1D local_information() const {
        const Array1D ones = Array1D::Ones(curve_.size());
        return spread(curve_, evidence_.information, level_stretch) / spread(curve_, ones, level_stretch);
    }

    /// Noise of places before smoothing: variance of one times the correlation length of neighbours [px³].
    [[nodiscard]] double measured_noise() const {
        const Index n = curve_.size();
        const double shift = away();
        Array1D outer = Array1D::Zero(n), inner = outer;
        for (const auto& p : pixels_) {
            // the sum of a place, shifted into vacuum or into the sample
            const double moved = p.distance > 0 ? p.distance - shift : p.distance + shift;
            if (p.distance > 0 ? moved < 0 : moved >= 0) continue;
            const double slope = evidence_.contrast[p.index] * shape_.slope(moved);
            (p.distance > 0 ? outer : inner)[p.index] -= slope * residual(p) / scatter_.variance(moved);
        }
        const Array1D information = local_information();
        const Array1D outer_place = outer / information, inner_place = inner / information;
        return long_run_variance(outer_place) + long_run_variance(inner_place);
    }

    /// Spectrum of places before smoothing, relative to waves longer than 130 px.
    [[nodiscard]] PlaceSpectrum spectrum() const {
        const auto base = smoothed(curve_, 20.0);
        const auto across = normals(base);
        const Array1D information = local_information();
        const Array1D off = evidence_.score / information;
        Array1D height =
            (curve_.x + off * normals_.x - base.x) * across.x + (curve_.y + off * normals_.y - base.y) * across.y;
        return place_spectrum(height);
    }

    void choose_smoothing() {
        noise_ = measured_noise();
        const auto places = spectrum();
        smoothing_ = best_smoothing(places, noise_);
        error_squares_ = expected_squares(places, noise_, smoothing_);
    }

    void measure_error() {
        noise_ = measured_noise();
        error_squares_ = expected_squares(spectrum(), noise_, smoothing_);
    }

    /// Pixels between two points contribute to both by their distances, so the points are those of the polyline that
    /// fits the edge best, K (1 + q²/12): subtraction of a twelfth of the second difference converts them to samples of
    /// the edge.
    [[nodiscard]] PlaneCurve samples_of_edge() const {
        auto samples = curve_;
        for (Index k = curve_.closed ? 0 : 1; k < (curve_.closed ? curve_.size() : curve_.size() - 1); ++k) {
            const Index before = curve_.at(k - 1), after = curve_.at(k + 1);
            const double bend = (curve_.x[before] - 2 * curve_.x[k] + curve_.x[after]) * normals_.x[k] +
                                (curve_.y[before] - 2 * curve_.y[k] + curve_.y[after]) * normals_.y[k];
            samples.x[k] += bend / 12 * normals_.x[k];
            samples.y[k] += bend / 12 * normals_.y[k];
        }
        return samples;
    }

    RefinedEdge result(bool converged) {
        RefinedEdge edge;
        const Array1D information = local_information();
        edge.standard_error =
            (error_squares_ * information.mean() / information + min_error * min_error + moved_.square()).sqrt();
        edge.blur = shape_.width;
        edge.curve = samples_of_edge();
        edge.shape = shape_;
        edge.noise_density = noise_;
        edge.smoothing_length = smoothing_;
        const double noise = std::sqrt(0.5 * (vacuum_noise_ * vacuum_noise_ + sample_noise_ * sample_noise_));
        edge.contrast_to_noise =
            noise > 0 ? std::sqrt(2 * std::numbers::pi) * shape_.width * std::abs(shape_.slope(0)) / noise : 1e6;
        edge.converged = converged;
        return edge;
    }

    EdgeBand& band_;
    PlaneCurve curve_;
    const std::vector<Anchor>& anchors_;
    std::vector<BandPixel> pixels_;
    Scatter scatter_{1, 0};
    EdgeShape shape_;
    Normals normals_;
    Evidence evidence_;
    double reach_ = search_reach, smoothing_ = first_smoothing, last_move_ = 1e300;
    Array1D moved_;  ///< displacement of points in the last round [px]
    double vacuum_noise_ = 0, sample_noise_ = 0;
    bool lost_ = false;
    double noise_ = 0, error_squares_ = 0;  ///< N and the expected error, after measurement
};

}  // namespace

RefinedEdge refined_edge(EdgeBand& band, const PlaneCurve& start, const std::vector<Anchor>& anchors,
                         std::optional<double> smoothing_length) {
    return Refinement(band, start, anchors).run(smoothing_length);
}

}  // namespace setae::imaging
