// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/imaging/stage_micrometer.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <Eigen/Dense>

#include "setae/core/arrays.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"
#include "setae/imaging/micrograph.hpp"

namespace setae::imaging {
namespace {

constexpr int min_lines = 5;

/// A position of a line at the middle of a band.
struct Place {
    double along, across;  ///< pixels across the lines, and along them
    int line;
};

/// Grey levels minus the parabola of the illumination.
Array1D evenly_lit(const Array1D& levels) {
    const Array1D x = Array1D::LinSpaced(levels.size(), -1.0, 1.0);
    Eigen::Matrix<double, Eigen::Dynamic, 3> design(levels.size(), 3);
    design << Eigen::VectorXd::Ones(levels.size()), x.matrix(), x.square().matrix();
    const Eigen::Vector3d parabola =
        (design.transpose() * design).ldlt().solve(design.transpose() * levels.matrix()).eval();
    return levels - (design * parabola).array();
}

/// Range of grey levels without a hundredth at either end.
struct Contrast {
    double low, high;
    [[nodiscard]] double size() const { return high - low; }
};

Contrast contrast_of(std::vector<double> levels) {
    std::sort(levels.begin(), levels.end());
    return {sorted_quantile(levels, 0.01), sorted_quantile(levels, 0.99)};
}

/// Centres of the lines in the mean grey levels of a band: the rarer side of their middle is line.
std::vector<double> line_centres(const Array1D& levels) {
    const auto contrast = contrast_of({levels.begin(), levels.end()});
    const double middle = 0.5 * (contrast.low + contrast.high);
    const bool dark = static_cast<double>((levels < middle).count()) < 0.5 * static_cast<double>(levels.size());
    const Array1D beyond = dark ? Array1D(middle - levels) : Array1D(levels - middle);
    std::vector<double> centres;
    for (Index i = 0; i < beyond.size();) {
        if (!(beyond[i] > 0.0)) {
            ++i;
            continue;
        }
        Index end = i;
        double weight = 0.0, moment = 0.0;
        for (; end < beyond.size() && beyond[end] > 0.0; ++end) {
            weight += beyond[end];
            moment += beyond[end] * static_cast<double>(end);
        }
        // a line cut by the rim of the picture has no centre, a speck of noise is no line
        if (i > 0 && end < beyond.size() && beyond.segment(i, end - i).maxCoeff() > 0.25 * contrast.size())
            centres.push_back(moment / weight);
        i = end;
    }
    return centres;
}

/// Distance of neighbouring lines, if most distances are equal.
std::optional<double> spacing_of(const std::vector<double>& centres) {
    if (static_cast<int>(centres.size()) < min_lines) return std::nullopt;
    std::vector<double> distances;
    for (std::size_t i = 1; i < centres.size(); ++i) distances.push_back(centres[i] - centres[i - 1]);
    const double spacing = median(distances);
    const auto regular =
        std::count_if(distances.begin(), distances.end(), [&](double d) { return std::abs(d / spacing - 1.0) < 0.2; });
    return 2 * regular > static_cast<std::ptrdiff_t>(distances.size()) ? std::optional(spacing) : std::nullopt;
}

/// Vertical lines, in bands of rows; coordinates from the centre of the picture.
std::vector<Place> places_of(const FramePixels& pixels) {
    const long bands = std::clamp<long>(pixels.rows() / 16, 1, 32), height = pixels.rows() / bands;
    const double middle_x = 0.5 * static_cast<double>(pixels.cols() - 1),
                 middle_y = 0.5 * static_cast<double>(pixels.rows() - 1);
    std::vector<Place> places;
    std::vector<double> last;  // centres of the band above, with their lines
    std::vector<int> last_lines;
    long found = 0;
    // lines along the short side of the band keep their contrast in its mean, other lines lose it
    constexpr double min_contrast = 0.4;
    const double contrast = contrast_of({pixels.data(), pixels.data() + pixels.size()}).size();
    for (long band = 0; band < bands; ++band) {
        const Array1D levels =
            evenly_lit(pixels.middleRows(band * height, height).cast<double>().colwise().mean().transpose().eval());
        if (contrast_of({levels.begin(), levels.end()}).size() < min_contrast * contrast) continue;
        const auto centres = line_centres(levels);
        const auto spacing = spacing_of(centres);
        if (!spacing) continue;
        ++found;
        std::vector<int> lines{0};
        for (std::size_t i = 1; i < centres.size(); ++i)
            lines.push_back(lines.back() +
                            std::max(1, static_cast<int>(std::lround((centres[i] - centres[i - 1]) / *spacing))));
        if (!last.empty()) {
            // the lines of the band above are less than half a spacing away
            std::vector<double> offsets;
            for (std::size_t i = 0; i < centres.size(); ++i) {
                const auto nearest = std::min_element(last.begin(), last.end(), [&](double a, double b) {
                    return std::abs(a - centres[i]) < std::abs(b - centres[i]);
                });
                offsets.push_back(last_lines[static_cast<std::size_t>(nearest - last.begin())] - lines[i] +
                                  (centres[i] - *nearest) / *spacing);
            }
            const int offset = static_cast<int>(std::lround(median(offsets)));
            for (int& line : lines) line += offset;
        }
        for (std::size_t i = 0; i < centres.size(); ++i)
            places.push_back({centres[i] - middle_x,
                              static_cast<double>(band * height) + 0.5 * static_cast<double>(height - 1) - middle_y,
                              lines[i]});
        last = centres;
        last_lines = lines;
    }
    if (2 * found < bands) places.clear();
    return places;
}

/// Least squares of the numbers of the lines, errors by line.
struct NumberFit {
    Eigen::Vector4d at = Eigen::Vector4d::Zero();  ///< c, a along, a across, and d/r_c² |…| of the bent term
    Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
    Eigen::VectorXd residuals;
    int lines = 0;
};

NumberFit fit_numbers(const std::vector<Place>& places, double corner) {
    const auto n = static_cast<Index>(places.size());
    NumberFit fit;
    // the bent term needs a, which the next round determines more accurately
    Eigen::Vector2d direction(1.0, 0.0);
    Eigen::MatrixXd design(n, 4);
    Eigen::VectorXd numbers(n);
    Eigen::Matrix4d inverse;
    constexpr int rounds = 4;
    for (int round = 0; round < rounds; ++round) {
        for (Index i = 0; i < n; ++i) {
            const auto& p = places[static_cast<std::size_t>(i)];
            const double r_squared = (p.along * p.along + p.across * p.across) / (corner * corner);
            design.row(i) << 1.0, p.along, p.across, (direction[0] * p.along + direction[1] * p.across) * r_squared;
            numbers[i] = p.line;
        }
        inverse = (design.transpose() * design).inverse();
        fit.at = inverse * (design.transpose() * numbers);
        direction = fit.at.segment<2>(1);
    }
    fit.residuals = numbers - design * fit.at;
    std::map<int, Eigen::Vector4d> scores;
    for (Index i = 0; i < n; ++i) {
        auto [score, fresh] = scores.try_emplace(places[static_cast<std::size_t>(i)].line, Eigen::Vector4d::Zero());
        score->second += design.row(i).transpose() * fit.residuals[i];
    }
    Eigen::Matrix4d meat = Eigen::Matrix4d::Zero();
    for (const auto& [line, score] : scores) meat += score * score.transpose();
    fit.lines = static_cast<int>(scores.size());
    const auto lines = static_cast<double>(fit.lines);
    fit.covariance = inverse * meat * inverse * lines / std::max(1.0, lines - 4.0);
    return fit;
}

/// Places within four deviations of the fit.
std::vector<Place> agreeing(const std::vector<Place>& places, const NumberFit& fit) {
    std::vector<double> distances(fit.residuals.size());
    for (Index i = 0; i < fit.residuals.size(); ++i)
        distances[static_cast<std::size_t>(i)] = std::abs(fit.residuals[i]);
    constexpr double deviation_over_median = 1.4826, furthest = 4.0;
    const double limit = furthest * deviation_over_median * median(distances);
    std::vector<Place> kept;
    for (std::size_t i = 0; i < places.size(); ++i)
        if (std::abs(fit.residuals[static_cast<Index>(i)]) <= limit) kept.push_back(places[i]);
    return kept;
}

std::optional<RulingFit> ruling_fit(const FramePixels& pixels, const Estimate& pitch, bool upright) {
    auto places = places_of(upright ? pixels : FramePixels(pixels.transpose()));
    const double corner =
        0.5 * std::hypot(static_cast<double>(pixels.rows() - 1), static_cast<double>(pixels.cols() - 1));
    const auto lines_in = [](const std::vector<Place>& all) {
        std::map<int, int> lines;
        for (const auto& place : all) ++lines[place.line];
        return static_cast<int>(lines.size());
    };
    if (lines_in(places) < min_lines) return std::nullopt;
    auto fit = fit_numbers(places, corner);
    if (auto kept = agreeing(places, fit); kept.size() < places.size() && lines_in(kept) >= min_lines) {
        places = std::move(kept);
        fit = fit_numbers(places, corner);
    }
    const Eigen::Vector2d a = fit.at.segment<2>(1);
    const double length = a.norm();
    const Eigen::Vector2d along = a / length;
    const double relative = std::sqrt(along.dot(fit.covariance.block<2, 2>(1, 1) * along)) / length;
    const double freedom = std::max(1.0, fit.lines - 4.0);
    RulingFit result{.angle = std::atan2(a[1], a[0]),
                     .lines = fit.lines,
                     .places = static_cast<int>(places.size()),
                     .rms_residual = pitch.value * std::sqrt(fit.residuals.array().square().mean())};
    const double own = pitch.uncertain() ? pitch.standard_error / pitch.value : 0.0;
    result.pixel_size = {.value = pitch.value * length,
                         .standard_error = pitch.value * length * std::hypot(relative, own),
                         .method = "lines of a ruling",
                         .degrees_of_freedom = freedom};
    result.distortion = {.value = fit.at[3],
                         .standard_error = std::sqrt(fit.covariance(3, 3)),
                         .method = "lines of a ruling",
                         .degrees_of_freedom = freedom};
    result.probability = 2.0 * student_t_probability(-std::abs(fit.at[3]) / result.distortion.standard_error, freedom);
    // in a transposed picture along is y
    if (!upright) result.angle = 0.5 * pi - result.angle;
    return result;
}

/// Width and height of a pixel from the normals of both kinds of lines: (a_x/w)² + (a_y/h)² = 1 for each.
void separate_axes(CameraScale& scale) {
    auto& x = *scale.across_x;
    auto& y = *scale.across_y;
    const auto squares = [](const RulingFit& fit) {
        const double length = fit.pixel_size.value;
        return Eigen::RowVector2d(std::pow(length * std::cos(fit.angle), 2), std::pow(length * std::sin(fit.angle), 2));
    };
    Eigen::Matrix2d normals;
    normals << squares(x), squares(y);
    const Eigen::Vector2d inverse_squares = normals.inverse() * Eigen::Vector2d::Ones();
    const auto sized = [](Estimate estimate, double value) {
        return scaled(std::move(estimate), value / estimate.value);
    };
    const double width = 1.0 / std::sqrt(inverse_squares[0]), height = 1.0 / std::sqrt(inverse_squares[1]);
    x.pixel_size = sized(x.pixel_size, width);
    y.pixel_size = sized(y.pixel_size, height);
}

}  // namespace

CameraScale camera_scale(const std::vector<FramePixels>& pictures, const Estimate& pitch) {
    if (pictures.empty()) throw InvalidArgument("no picture of a stage micrometer is given; expected at least one");
    if (!(pitch.value > 0.0))
        throw InvalidArgument(fmt::format("a distance of {} m between lines; expected more than 0", pitch.value));
    CameraScale scale{.width = static_cast<long>(pictures.front().cols()),
                      .height = static_cast<long>(pictures.front().rows())};
    // ± of the pitch is common to both axes and not part of their ratio
    Estimate exact = pitch;
    exact.standard_error = undefined;
    std::optional<RulingFit> ruled_x, ruled_y;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const auto& picture = pictures[i];
        if (picture.cols() != scale.width || picture.rows() != scale.height)
            throw InvalidArgument(fmt::format(
                "picture {} has {} x {} pixels, the first {} x {}; expected pictures of one camera at one size", i + 1,
                picture.cols(), picture.rows(), scale.width, scale.height));
        const auto upright = ruling_fit(picture, exact, true), lying = ruling_fit(picture, exact, false);
        if (!upright && !lying)
            throw UndefinedDataError(fmt::format(
                "picture {}: no {} lines at equal distances are found, neither upright nor horizontal; turn the "
                "ruling along an edge of the picture, or crop the picture",
                i + 1, min_lines));
        if (upright) scale.across_x = upright;
        if (lying) scale.across_y = lying;
    }
    if (scale.across_x && scale.across_y) {
        separate_axes(scale);
        const auto &x = scale.across_x->pixel_size, &y = scale.across_y->pixel_size;
        const double ratio = y.value / x.value;
        scale.aspect =
            Estimate{.value = ratio,
                     .standard_error = ratio * std::hypot(x.standard_error / x.value, y.standard_error / y.value),
                     .method = "lines of a ruling"};
    } else {
        scale.notes.emplace_back(
            "the lines have one direction: pixels are taken as squares; take a second picture with the "
            "ruling turned by 90° to test it");
    }
    for (auto* fit : {&scale.across_x, &scale.across_y})
        if (*fit && pitch.uncertain()) {
            auto& size = (*fit)->pixel_size;
            size.standard_error = std::hypot(size.standard_error, size.value * pitch.standard_error / pitch.value);
        }
    if (!pitch.uncertain())
        scale.notes.emplace_back(
            "the distance of the ruling is taken as exact; give it with its ±, such as \"10 ± 0.02 um\"");
    scale.pixel_size = (scale.across_x ? scale.across_x : scale.across_y)->pixel_size;
    return scale;
}

CameraScale camera_scale(const std::vector<std::string>& files, const Estimate& pitch) {
    std::vector<FramePixels> pictures;
    for (const auto& file : files) pictures.push_back(read_micrograph(file).pixels);
    return camera_scale(pictures, pitch);
}

}  // namespace setae::imaging
