// SPDX-License-Identifier: GPL-3.0-or-later
#include "edge_rays.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <Eigen/Cholesky>

#include "setae/core/statistics.hpp"

namespace setae::imaging {
namespace {

constexpr double perimeter_per_ray = 6.0;                 // px of perimeter
constexpr double narrowest_ray = 0.3, widest_ray = 12.0;  // widths of edges [px]; the area of a pixel causes 0.29
constexpr double bin = 0.5;                               // px of distance, of profiles
constexpr double min_contrast = 0.3;                      // of that of the median ray
constexpr int max_rounds = 10, rounds_before_polish = 6, rounds_of_search = 4;
constexpr double nearly_converged_step = 0.03, converged_step = 0.003, unstable_step = 0.2;  // px

/// Search for places: among all, from the outline on, or linear in the grey levels.
enum class Stage { search, refine, polish };

double normal_density(double t) { return std::exp(-0.5 * t * t) * (std::numbers::inv_sqrtpi / std::numbers::sqrt2); }
double normal_integral(double t) { return 0.5 * std::erf(t / std::numbers::sqrt2); }  // odd

/// Angle in [0, 2π) to 0.005 rad, sufficient for sectors.
double rough_angle(double y, double x) {
    const double ax = std::abs(x), ay = std::abs(y), q = std::min(ax, ay) / std::max(std::max(ax, ay), 1e-12);
    double angle =
        q * (std::numbers::pi / 4 + 0.273 * (1 - q));  // Rajan et al., IEEE Signal Processing Magazine 23 (2006) 108
    if (ay > ax) angle = std::numbers::pi / 2 - angle;
    if (x < 0) angle = std::numbers::pi - angle;
    if (y < 0) angle = 2 * std::numbers::pi - angle;
    return angle;
}

/// Grey levels by distance from the outline: sums in bins.
struct ProfileBin {
    double count = 0, distance = 0, grey = 0;
};

struct RayProfile {
    std::vector<ProfileBin> bins;
    double grey_squared = 0;
};

struct Window {
    double inside = 0, outside = 0;  ///< distances covered on either side [px]
    [[nodiscard]] std::size_t bins() const { return static_cast<std::size_t>(std::ceil((inside + outside) / bin)) + 1; }
};

struct Sectors {
    std::vector<RayProfile> profiles;
    Window window;
};

Sectors gathered(const FramePixels& pixels, const Outline& outline, std::size_t count, const Window& window) {
    Sectors sectors{std::vector<RayProfile>(count, RayProfile{std::vector<ProfileBin>(window.bins()), 0}), window};
    const OutlineDistance distance(outline);
    const double outer = outline.semi_major() + window.outside + 1,
                 inner = std::max(0.0, outline.semi_minor() - window.inside - 1);
    const double per_radian = static_cast<double>(count) / (2 * std::numbers::pi);
    const long first = std::max(0L, static_cast<long>(std::floor(outline.centre_y - outer))),
               last = std::min(pixels.rows() - 1, static_cast<long>(std::ceil(outline.centre_y + outer)));
    const auto take = [&](long row, long from, long to) {
        for (long column = std::max(0L, from); column <= std::min(pixels.cols() - 1, to); ++column) {
            const double x = static_cast<double>(column), y = static_cast<double>(row), d = distance(x, y);
            if (d < -window.inside || d > window.outside) continue;
            const auto sector = std::min(
                count - 1,
                static_cast<std::size_t>(rough_angle(y - outline.centre_y, x - outline.centre_x) * per_radian));
            auto& profile = sectors.profiles[sector];
            auto& at = profile.bins[static_cast<std::size_t>((d + window.inside) / bin)];
            const double grey = static_cast<double>(pixels(row, column));
            at.count += 1;
            at.distance += d;
            at.grey += grey;
            profile.grey_squared += grey * grey;
        }
    };
    for (long row = first; row <= last; ++row) {
        const double dy = static_cast<double>(row) - outline.centre_y;
        if (std::abs(dy) > outer) continue;
        const double half = std::sqrt(outer * outer - dy * dy);
        const long left = static_cast<long>(std::floor(outline.centre_x - half)),
                   right = static_cast<long>(std::ceil(outline.centre_x + half));
        if (std::abs(dy) >= inner) {
            take(row, left, right);
            continue;
        }
        const double hole = std::sqrt(inner * inner - dy * dy);
        const long hole_left = static_cast<long>(std::floor(outline.centre_x - hole)),
                   hole_right = static_cast<long>(std::ceil(outline.centre_x + hole));
        take(row, left, hole_left);
        take(row, std::max(hole_right, hole_left + 1), right);
    }
    for (auto& profile : sectors.profiles)
        for (auto& at : profile.bins)
            if (at.count > 0) {
                at.distance /= at.count;
                at.grey /= at.count;
            }
    return sectors;
}

/// Level, contrast and place (and width) of an erf step by least squares over bins.
struct StepFit {
    double level = 0, contrast = 0, place = 0, width = 1;
    Eigen::Matrix4d inverse = Eigen::Matrix4d::Zero();  ///< of the normal equations
    double squares = 0, count = 0;                      ///< of residuals of bins
    bool good = false;
};

/// Level and contrast for a given place and width; the remaining squares.
double linear_part(const RayProfile& profile, StepFit& fit) {
    double n = 0, h = 0, hh = 0, g = 0, gh = 0, gg = 0;
    for (const auto& at : profile.bins) {
        if (at.count == 0) continue;
        const double step = normal_integral((at.distance - fit.place) / fit.width);
        n += at.count;
        h += at.count * step;
        hh += at.count * step * step;
        g += at.count * at.grey;
        gh += at.count * at.grey * step;
        gg += at.count * at.grey * at.grey;
    }
    const double determinant = n * hh - h * h;
    if (n < 4 || determinant < 1e-6 * n * n) return gg;
    fit.contrast = (n * gh - h * g) / determinant;
    fit.level = (g - fit.contrast * h) / n;
    return gg - fit.level * g - fit.contrast * gh;
}

/// Gauss–Newton rounds. One round with a known contrast is linear in the grey levels: noise causes no bias, and the
/// scatter of places is that of their mean.
void refine(const RayProfile& profile, StepFit& fit, bool width_free, double farthest, int rounds,
            double known_contrast = 0) {
    const int unknowns = width_free ? 4 : 3;
    for (int round = 0; round < rounds; ++round) {
        Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
        Eigen::Vector4d right = Eigen::Vector4d::Zero();
        fit.squares = fit.count = 0;
        for (const auto& at : profile.bins) {
            if (at.count == 0) continue;
            const double t = (at.distance - fit.place) / fit.width, step = normal_integral(t),
                         density = normal_density(t);
            const double residual = at.grey - fit.level - fit.contrast * step;
            const double slope = -(known_contrast != 0 ? known_contrast : fit.contrast) * density / fit.width;
            const Eigen::Vector4d row{1.0, step, slope, width_free ? slope * t : 0.0};
            normal.noalias() += at.count * row * row.transpose();
            right += at.count * residual * row;
            fit.squares += at.count * residual * residual;
            fit.count += at.count;
        }
        if (!width_free) normal(3, 3) = 1.0;
        const auto factors = normal.ldlt();
        fit.good =
            fit.count > unknowns && factors.info() == Eigen::Success && factors.isPositive() && factors.rcond() > 1e-12;
        if (!fit.good) return;
        Eigen::Vector4d change = factors.solve(right);
        change[2] = std::clamp(change[2], -fit.width, fit.width);
        change[3] = std::clamp(change[3], -0.4 * fit.width, 0.4 * fit.width);
        fit.level += change[0];
        fit.contrast += change[1];
        fit.place = std::clamp(fit.place + change[2], -farthest, farthest);
        fit.width = std::clamp(fit.width + change[3], narrowest_ray, widest_ray);
        fit.inverse = factors.solve(Eigen::Matrix4d::Identity());
        if (std::abs(change[2]) + std::abs(change[3]) < 1e-3) return;
    }
}

/// The place among steps of half a width with least squares and a contrast of the given sign.
StepFit searched(const RayProfile& profile, double width, double sign, double farthest) {
    StepFit best{.width = width};
    double least = std::numeric_limits<double>::infinity();
    for (double place = -farthest; place <= farthest; place += 0.5 * width) {
        StepFit fit{.place = place, .width = width};
        const double squares = linear_part(profile, fit);
        if (sign * fit.contrast > 0 && squares < least) {
            least = squares;
            best = fit;
        }
    }
    best.good = std::isfinite(least);
    return best;
}

/// Pixels of a sector completely inside the frame.
double whole_sector(const Outline& outline, std::size_t rays, const Window& window) {
    return 2 * std::numbers::pi * outline.mean_radius / static_cast<double>(rays) * (window.inside + window.outside);
}

std::vector<EdgeRay> fitted_rays(const Sectors& sectors, const Outline& outline, double width, double sign, Stage stage,
                                 double typical_contrast, double& noise) {
    const auto n = sectors.profiles.size();
    std::vector<EdgeRay> rays(n);
    std::vector<double> squares_per_pixel;
    const double whole = whole_sector(outline, n, sectors.window),
                 farthest = 0.8 * std::min(sectors.window.inside, sectors.window.outside);
    double squares = 0, freedom = 0;
    for (std::size_t k = 0; k < n; ++k) {
        auto& ray = rays[k];
        ray.angle = 2 * std::numbers::pi * (static_cast<double>(k) + 0.5) / static_cast<double>(n);
        const auto& profile = sectors.profiles[k];
        double inside = 0, outside = 0, grey_squared = 0;
        for (const auto& at : profile.bins) {
            (at.distance < 0 ? inside : outside) += at.count;
            grey_squared += at.count * at.grey * at.grey;
        }
        ray.visible = inside + outside > 0.6 * whole && inside > 0.15 * whole && outside > 0.15 * whole;
        if (!ray.visible) continue;
        StepFit fit{.width = width};
        if (stage == Stage::search) fit = searched(profile, width, sign, farthest);
        else linear_part(profile, fit);
        if (stage == Stage::polish) refine(profile, fit, false, farthest, 1, sign * typical_contrast);
        else refine(profile, fit, false, farthest, 4);
        if (!fit.good || std::abs(fit.place) >= farthest) continue;
        ray.fitted = true;
        ray.place = fit.place;
        ray.contrast = fit.contrast;
        ray.variance = fit.inverse(2, 2);
        ray.contrast_deviation = std::sqrt(fit.inverse(1, 1));
        // scatter within bins and of bins about the fit, per pixel
        const double own = std::max(0.0, profile.grey_squared - grey_squared) + fit.squares;
        squares_per_pixel.push_back(own / std::max(1.0, fit.count - 3));
        squares += own;
        freedom += fit.count - 3;
    }
    // the median excludes rays over dust
    noise = std::sqrt(std::max(upper_median(squares_per_pixel), 0.0));
    const double floor = freedom > 0 ? 1e-4 * std::sqrt(squares / freedom) : 0;
    noise = std::max({noise, floor, 1e-9});
    for (auto& ray : rays) {
        ray.variance *= noise * noise;
        ray.contrast_deviation *= noise;
    }
    return rays;
}

/// The mean over agreeing rays of grey levels minus the level of each ray; by the distance from the outline, or from
/// the place of each ray.
RayProfile mean_profile(const Sectors& sectors, const std::vector<EdgeRay>& rays, const std::vector<bool>& agree,
                        bool from_own_place) {
    RayProfile mean{std::vector<ProfileBin>(sectors.window.bins()), 0};
    for (std::size_t k = 0; k < rays.size(); ++k) {
        if (!agree[k]) continue;
        const auto& bins = sectors.profiles[k].bins;
        double level = 0, count = 0;
        for (const auto& at : bins) {
            level += at.count * at.grey;
            count += at.count;
        }
        level /= count;
        const double place = from_own_place ? rays[k].place : 0.0;
        for (const auto& at : bins) {
            const double distance = at.distance - place;
            if (at.count == 0 || distance < -sectors.window.inside || distance > sectors.window.outside) continue;
            auto& into = mean.bins[static_cast<std::size_t>((distance + sectors.window.inside) / bin)];
            into.count += at.count;
            into.distance += at.count * distance;
            into.grey += at.count * (at.grey - level);
        }
    }
    for (auto& at : mean.bins)
        if (at.count > 0) {
            at.distance /= at.count;
            at.grey /= at.count;
        }
    return mean;
}

/// Position where the mean profile first turns back outside the edge by a share of the contrast; `farthest` if it does
/// not.
double first_fringe(const RayProfile& profile, const StepFit& step, double sign, double farthest) {
    constexpr double turned = 0.08;
    double highest = -std::numeric_limits<double>::infinity(), at_highest = farthest;
    for (const auto& at : profile.bins) {
        if (at.count == 0 || at.distance < step.place) continue;
        const double grey = sign * at.grey;
        if (grey > highest) {
            highest = grey;
            at_highest = at.distance;
        } else if (grey < highest - turned * std::abs(step.contrast)) return at_highest;
    }
    return farthest;
}

/// Rays of the outline: those whose contrast has the sign and is comparable to the median.
struct OutlineRays {
    std::vector<EdgeOffset> offsets;
    std::vector<std::size_t> rays;
    double significance = 0;  ///< median contrast over its deviation
};

OutlineRays comparable_rays(const std::vector<EdgeRay>& rays, double sign) {
    std::vector<double> contrasts, significances;
    for (const auto& ray : rays)
        if (ray.fitted && sign * ray.contrast > 0) {
            contrasts.push_back(sign * ray.contrast);
            significances.push_back(sign * ray.contrast / ray.contrast_deviation);
        }
    OutlineRays found{.significance = upper_median(significances)};
    const double typical = upper_median(contrasts);
    for (std::size_t k = 0; k < rays.size(); ++k) {
        if (!rays[k].fitted || sign * rays[k].contrast < min_contrast * typical) continue;
        found.offsets.push_back({rays[k].angle, rays[k].place, rays[k].variance});
        found.rays.push_back(k);
    }
    return found;
}

/// Applies the weights of a correction to the rays; marks those that agree.
void take_agreement(EdgeFit& fit, const OutlineRays& used, const OutlineCorrection& correction, double sign,
                    std::vector<bool>& agree) {
    constexpr double min_weight = 0.073;  // Tukey's at 4 of 4.685 scales: (1 − (4/4.685)²)²
    agree.assign(fit.rays.size(), false);
    std::vector<double> contrasts;
    for (std::size_t i = 0; i < used.rays.size(); ++i)
        if (correction.weights[i] > min_weight) {
            agree[used.rays[i]] = true;
            contrasts.push_back(sign * fit.rays[used.rays[i]].contrast);
        }
    const auto visible =
        std::count_if(fit.rays.begin(), fit.rays.end(), [](const EdgeRay& ray) { return ray.visible; });
    fit.agreeing_share = visible > 0 ? static_cast<double>(contrasts.size()) / static_cast<double>(visible) : 0.0;
    fit.contrast = upper_median(std::move(contrasts));
    fit.significance = used.significance;
    fit.covariance = correction.covariance;
}

}  // namespace

double share_within(const Outline& outline, long width, long height) {
    constexpr int points = 128;
    int within = 0;
    for (int k = 0; k < points; ++k) {
        const double angle = 2 * std::numbers::pi * k / points, r = outline.radius_at(angle);
        const double x = outline.centre_x + r * std::cos(angle), y = outline.centre_y + r * std::sin(angle);
        within +=
            x >= -0.5 && y >= -0.5 && x <= static_cast<double>(width) - 0.5 && y <= static_cast<double>(height) - 0.5
                ? 1
                : 0;
    }
    return static_cast<double>(within) / points;
}

EdgeFit fit_edge(const FramePixels& pixels, const Outline& start, double sign, double uncertainty, bool fringes) {
    EdgeFit fit;
    fit.outline = start;
    double width = std::max(1.5, 0.5 * uncertainty);
    double outside = fringes ? 4.0 : std::max(6.0, 2.5 * uncertainty);
    auto stage = Stage::search;
    std::size_t count = 0;
    std::vector<bool> agree;
    double last_step = 0;
    for (int round = 0; round < max_rounds; ++round) {
        auto& outline = fit.outline;
        if (fit.shape == OutlineShape::circle) outline.stretch_cosine = outline.stretch_sine = 0;
        const double reach =
            stage == Stage::search ? std::max(6.0, 2.5 * uncertainty) : std::max(8.0, 5.0 * width + 3.0);
        const Window window{std::min(reach, 0.85 * outline.semi_minor()), fringes ? std::min(outside, reach) : reach};
        if (stage != Stage::polish)
            count = static_cast<std::size_t>(
                std::clamp(2 * std::numbers::pi * outline.mean_radius / perimeter_per_ray, 16.0, 240.0));
        const auto sectors = gathered(pixels, outline, count, window);
        fit.rays = fitted_rays(sectors, outline, width, sign, stage, fit.contrast, fit.noise);
        if (stage == Stage::polish)
            for (std::size_t k = 0; k < count; ++k)
                fit.rays[k].fitted = fit.rays[k].fitted && agree[k];  // the error of a linear place is small
        const auto used = comparable_rays(fit.rays, sign);
        fit.visible_share = share_within(outline, pixels.cols(), pixels.rows());
        fit.shape = fit.visible_share < 0.9 ? OutlineShape::circle : OutlineShape::ellipse;
        if (fit.shape == OutlineShape::circle && outline.stretch() > 0) continue;
        const auto correction = corrected_outline(outline, used.offsets, fit.shape);
        const bool sane = correction.solved && correction.outline.semi_minor() > 2 &&
                          correction.largest_step < 0.5 * start.mean_radius + 2;
        if (!sane) {
            fit.failure =
                fmt::format("{} of {} rays show an edge, which is too few for a circle", used.offsets.size(), count);
            return fit;
        }
        take_agreement(fit, used, correction, sign, agree);
        const auto mean = mean_profile(sectors, fit.rays, agree, stage == Stage::search);
        StepFit step{.width = width};
        linear_part(mean, step);
        refine(mean, step, true, 0.8 * std::min(window.inside, window.outside), 12);
        const double previous = width;
        if (step.good) width = std::clamp(step.width, narrowest_ray, widest_ray);
        if (fringes && step.good) {
            // over a whole fringe brightness averages out; without a turn the window is kept
            const double turn = std::clamp(2 * first_fringe(mean, step, sign, reach), 3.0, reach);
            outside = round < rounds_of_search ? turn : std::min(outside, turn);  // it converges
        }
        fit.outline = correction.outline;
        fit.edge_width = width;
        last_step = correction.largest_step;
        const bool steady = std::abs(width - previous) < 0.05 * width;
        if (stage == Stage::search) {
            if (correction.largest_step < 1.0) stage = Stage::refine;
        } else if (stage == Stage::refine) {
            if (fringes && correction.largest_step < converged_step && steady) break;
            // resolved fringes have other contrasts than the median: places are then those of the fit of each ray
            if (!fringes &&
                ((correction.largest_step < nearly_converged_step && steady) || round >= rounds_before_polish))
                stage = Stage::polish;
        } else if (correction.largest_step < converged_step && steady) {
            break;
        }
    }
    if (last_step > unstable_step)
        fit.failure = fmt::format("the outline did not converge: its last step is {:.1f} px", last_step);
    return fit;
}

}  // namespace setae::imaging
