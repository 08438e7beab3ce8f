// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/contact_line.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/contact/elasticity.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/contact_line/line_table.hpp"
#include "setae/contact_line/local_release_rate.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::answers {
namespace {

/// Result of `find`; where it is undefined empty, with the reason.
template <class Find>
auto if_defined(Find&& find, std::string* reason = nullptr) -> std::optional<decltype(find())> {
    try {
        return find();
    } catch (const UndefinedDataError& e) {
        if (reason) *reason = e.what();
        return std::nullopt;
    }
}

LineMotion motion_of(contact_line::Passage passage, double threshold) {
    LineMotion found{.passage = std::move(passage)};
    found.jumps = contact_line::clusters(found.passage, contact_line::ClusterKind::jumps, threshold);
    found.arrests = contact_line::clusters(found.passage, contact_line::ClusterKind::arrests, threshold);
    found.speed_tail =
        if_defined([&] { return contact_line::power_law_tail(contact_line::relative_speeds(found.passage)); });
    found.jump_tail = if_defined([&] { return contact_line::power_law_tail(areas_of(found.jumps)); });
    return found;
}

/// At the times of the edge, where a release rate is requested.
std::optional<Array1D> displacement_of(const RecordedEdge& edge, const LineRequest& request) {
    const bool wanted = !request.sphere_radius.empty() || !request.contact_modulus.empty();
    if (!wanted && request.displacement.empty()) return std::nullopt;
    if (request.sphere_radius.empty() || request.contact_modulus.empty())
        throw InvalidArgument("a release rate takes `radius` of the sphere and `contact_modulus`; expected both");
    if (request.displacement.empty()) {
        if (!edge.displacement)
            throw InvalidArgument(
                "a release rate takes the displacement of the sphere; expected `displacement`, a table of time and "
                "displacement, or a column of that name beside the edge");
        return edge.displacement;
    }
    const auto table = tables::read_table(request.displacement);
    const auto &time = table.at("time"), &displacement = table.at("displacement"), &times = edge.line.line.time;
    const Index n = time.size();
    for (Index i = 1; i < n; ++i)
        if (!(time[i] > time[i - 1]))
            throw InvalidArgument(fmt::format("{}: time {} s after {} s; expected increasing times",
                                              request.displacement, time[i], time[i - 1]));
    if (n < 2 || times.minCoeff() < time[0] || times.maxCoeff() > time[n - 1])
        throw InvalidArgument(fmt::format("{}: times from {} to {} s, the edge has {} to {} s; expected all of them",
                                          request.displacement, n > 0 ? time[0] : undefined,
                                          n > 0 ? time[n - 1] : undefined, times.minCoeff(), times.maxCoeff()));
    return times.unaryExpr([&](double t) {
        const auto after = std::clamp<Index>(std::upper_bound(time.begin(), time.end(), t) - time.begin(), 1, n - 1);
        const double share = (t - time[after - 1]) / (time[after] - time[after - 1]);
        return (1.0 - share) * displacement[after - 1] + share * displacement[after];
    });
}

/// Variance of G along the edge by white noise of its positions, in each frame: for the modes of r, each of variance
/// σ²/N, G has (∂G_J/∂r + (G_J/r) |n|)² up to the largest mode, and (∂G_J/∂r)² of the others.
Array1D noise_variance(const contact_line::ContactLine& line, const Array1D& mean_radius, const Array1D& displacement,
                       const contact::SphereOnFlat& sphere, Index largest_mode) {
    const Index n = line.angles(), last = largest_mode > 0 ? std::min(largest_mode, n / 2) : n / 2;
    const double of_mode = line.place_error * line.place_error / static_cast<double>(n);
    return Array1D::NullaryExpr(line.frames(), [&](Index i) {
        constexpr double step = 1e-5;
        const auto rate = [&](double r) {
            return contact::jkr::energy_release_rate_at_displacement(r, displacement[i], sphere);
        };
        const double r = mean_radius[i], bend = rate(r) / r,
                     slope = (rate(r * (1.0 + step)) - rate(r * (1.0 - step))) / (2.0 * step * r);
        double sum = 0.0;
        for (Index k = 1; k <= n / 2; ++k) {
            const double answer = slope + (k <= last ? bend * static_cast<double>(k) : 0.0);
            sum += (2 * k == n ? 1.0 : 2.0) * answer * answer;
        }
        return of_mode * sum;
    });
}

std::optional<ReleaseRate> release_rate(const Array2D& rates, const Array1D& noise) {
    if (rates.rows() == 0) return std::nullopt;
    const Array1D means = rates.rowwise().mean();
    const double variance = (rates.colwise() - means).square().mean();
    return ReleaseRate{.frames = rates.rows(),
                       .mean = means.mean(),
                       .scatter = std::sqrt(std::max(0.0, variance - noise.mean())),
                       .noise = std::sqrt(noise.mean())};
}

void add_release_rate(LineAnswer& answer, const Array1D& displacement, const LineRequest& request) {
    const contact::SphereOnFlat sphere{parse_quantity(request.sphere_radius, positive(dimension::length)),
                                       parse_quantity(request.contact_modulus, positive(dimension::pressure))};
    const auto& line = answer.recorded.line;
    const Index largest = request.largest_mode > 0 ? request.largest_mode
                          : line.place_error > 0.0 ? line.angles() / 4
                                                   : 0;
    const Array2D rates = contact_line::local_release_rate(line, displacement, sphere, largest);
    Index widest = 0;
    answer.shape.mean_radius.maxCoeff(&widest);
    const Index after = line.frames() - 1 - widest;
    const Array1D noise = noise_variance(line, answer.shape.mean_radius, displacement, sphere, largest);
    answer.advancing_rate = release_rate(rates.topRows(widest), noise.head(widest));
    answer.retracting_rate = release_rate(rates.bottomRows(after), noise.tail(after));
}

}  // namespace

Array1D areas_of(const std::vector<contact_line::Cluster>& clusters) {
    Array1D areas(static_cast<Index>(clusters.size()));
    for (Index i = 0; i < areas.size(); ++i) areas[i] = clusters[static_cast<std::size_t>(i)].area;
    return areas;
}

imaging::LineOptions LineRequest::line_options(parallel::Threads threads) const {
    imaging::LineOptions options{.smallest_void = smallest_void, .threads = threads};
    if (angles) options.angles = *angles;
    return options;
}

RecordedLine recorded_line(const Table& table) {
    RecordedLine recorded;
    recorded.line = contact_line::line_of(table);
    const auto* numbers = table.find("frame");
    for (Index i = 0; i < recorded.line.frames(); ++i)
        recorded.frames.push_back(numbers ? static_cast<long>(numbers->values[i]) : static_cast<long>(i + 1));
    recorded.voids.resize(recorded.frames.size());
    return recorded;
}

RecordedEdge recorded_edge(const std::vector<std::string>& files, const LineRequest& request,
                           parallel::Threads threads) {
    if (files.size() == 1 && files[0].ends_with(".csv")) {
        const auto table = tables::read_table(files[0]);
        const auto* displacement = table.find("displacement");
        return {recorded_line(table), {}, displacement ? std::optional(displacement->values) : std::nullopt};
    }
    const auto options = request.radius_options(threads);
    const imaging::FrameSource source(files, request.frame_options());
    auto radii = imaging::measure_contact_radii(source, options);
    auto traced = imaging::measure_contact_line(source, radii, request.line_options(threads));
    RecordedLine line{.frames = std::move(traced.frames),
                      .line = {std::move(traced.time), std::move(traced.radius), traced.place_error},
                      .pixel_size = traced.pixel_size,
                      .centre_x = traced.centre_x,
                      .centre_y = traced.centre_y,
                      .voids = std::move(traced.voids),
                      .left_out = std::move(traced.left_out)};
    return {std::move(line), std::move(radii), {}};
}

std::string line_csv(const RecordedLine& recorded) {
    return edge_csv(contact_line::as_table(recorded.line, recorded.frames));
}

std::string edge_csv(const Table& table) {
    std::string text;
    for (const auto& [key, value] : table.metadata) text += fmt::format("# {}: {}\n", key, value);
    return text + tables::as_csv(table);
}

LineAnswer contact_line_answer(RecordedEdge edge, const LineRequest& request) {
    const auto displacement = displacement_of(edge, request);
    LineAnswer answer{.recorded = std::move(edge.line)};
    const auto& line = answer.recorded.line;
    const double width =
        request.ring_width.empty() ? 0.0 : parse_quantity(request.ring_width, positive(dimension::length));
    answer.shape = contact_line::line_shape(line);
    std::string reason;
    answer.roughness = if_defined(
        [&] {
            return contact_line::line_roughness(
                line, {.smallest_mode = request.smallest_mode, .largest_mode = request.largest_mode});
        },
        &reason);
    if (!answer.roughness) answer.notes.push_back("roughness: " + reason);
    const auto motion = [&](contact_line::Direction direction) -> std::optional<LineMotion> {
        if (line.frames() < 2) return std::nullopt;
        auto passage = if_defined([&] { return contact_line::passage(line, direction, width); }, &reason);
        if (!passage) return std::nullopt;
        return motion_of(std::move(*passage), request.threshold);
    };
    answer.advancing = motion(contact_line::Direction::advancing);
    answer.receding = motion(contact_line::Direction::receding);
    if (!answer.advancing && !answer.receding)
        answer.notes.push_back(line.frames() < 2 ? "one frame: nothing moves" : "motion: " + reason);
    if (displacement) add_release_rate(answer, *displacement, request);
    return answer;
}

Array1D void_counts(const RecordedLine& recorded) {
    return Array1D::NullaryExpr(recorded.line.frames(), [&](Index i) {
        return static_cast<double>(recorded.voids[static_cast<std::size_t>(i)].size());
    });
}

Array1D void_areas(const RecordedLine& recorded) {
    return Array1D::NullaryExpr(recorded.line.frames(), [&](Index i) {
        double area = 0.0;
        for (const auto& hole : recorded.voids[static_cast<std::size_t>(i)])
            area += hole.area * recorded.pixel_size * recorded.pixel_size;
        return area;
    });
}

Table as_table(const LineAnswer& answer) {
    const auto& recorded = answer.recorded;
    const Index frames = recorded.line.frames();
    const Array1D numbers = Array1D::NullaryExpr(
        frames, [&](Index i) { return static_cast<double>(recorded.frames[static_cast<std::size_t>(i)]); });
    Table table;
    table.columns = {{"time", "s", recorded.line.time},
                     {"frame", "1", numbers},
                     {"mean_radius", "m", answer.shape.mean_radius},
                     {"area", "m2", answer.shape.area},
                     {"perimeter", "m", answer.shape.perimeter},
                     {"deviation", "m", answer.shape.deviation},
                     {"voids", "1", void_counts(recorded)},
                     {"void_area", "m2", void_areas(recorded)}};
    return table;
}

}  // namespace setae::answers
