// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/hysteresis/ranking.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::hysteresis {
namespace {

using adhesion::GeneralisedFit;
using adhesion::PairPoint;

GeneralisedFit fit_parameter(const std::vector<PairPoint>& pairs) {
    auto fit = adhesion::fit_generalised(pairs);
    return fit.work_of_adhesion.value > 0.0 ? fit : adhesion::fit_scatter(pairs, 0.0);
}

adhesion::PairFit fit_of(const RetractionModel& model) {
    if (model.fitted()) return fit_parameter;
    return [](const std::vector<PairPoint>& pairs) { return adhesion::fit_scatter(pairs, 0.0); };
}

/// @throws InvalidArgument where there are too few to judge by.
void require_enough(const std::vector<PairPoint>& pairs) {
    std::set<std::string> surfaces;
    for (const auto& pair : pairs) surfaces.insert(pair.surface);
    if (pairs.size() < fewest_ranked_pairs || surfaces.size() < fewest_ranked_surfaces)
        throw InvalidArgument(fmt::format("{} pairs on {} surfaces have W_app and W_ret measured; expected {} on {}",
                                          pairs.size(), surfaces.size(), fewest_ranked_pairs, fewest_ranked_surfaces));
}

double rms_left_out(const std::vector<adhesion::LeftOutPrediction>& predictions, bool surfaces) {
    double sum = 0.0;
    int count = 0;
    for (const auto& prediction : predictions) {
        if (prediction.surface_left_out != surfaces) continue;
        sum += prediction.residual * prediction.residual;
        ++count;
    }
    return count == 0 ? undefined : std::sqrt(sum / count);
}

/// What a pair of a new surface and a new elastomer scatters by.
Estimate scatter_of_next(const GeneralisedFit& fit) {
    const auto& s = fit.scatter;
    const double variance = s.pair * s.pair + s.surface * s.surface + s.elastomer * s.elastomer;
    Estimate scatter{.value = 0.0, .standard_error = std::sqrt(variance)};
    scatter.degrees_of_freedom = std::max(1.0, fit.freedom.pair);
    return scatter;
}

ModelScore score(const ModelPoints& of) {
    const auto fit = fit_of(of.model);
    ModelScore score{.fitted = {.model = of.model}, .fit = fit(of.points)};
    score.fitted.parameter = score.fit.work_of_adhesion;
    score.fitted.scatter = scatter_of_next(score.fit);
    for (const auto& point : of.points) {
        const double residual = point.measured.value - point.prediction(score.fit.work_of_adhesion.value);
        score.rms_residual += residual * residual;
    }
    const auto n = static_cast<double>(of.points.size());
    score.rms_residual = std::sqrt(score.rms_residual / n);
    score.log_likelihood = score.fit.log_likelihood;
    auto left_out = adhesion::leave_out(of.points, fit);
    score.left_out = std::move(left_out.predictions);
    score.left_out_log_likelihood = left_out.surface_log_density;
    score.surface_left_out = rms_left_out(score.left_out, true);
    score.elastomer_left_out = rms_left_out(score.left_out, false);
    return score;
}

}  // namespace

std::vector<const ModelScore*> Ranking::not_told_apart() const {
    std::vector<const ModelScore*> alike;
    for (const auto& model : models)
        if (model.weight * told_apart_odds >= models.front().weight) alike.push_back(&model);
    return alike;
}

const ModelScore* Ranking::best() const {
    const auto alike = not_told_apart();
    constexpr double simpler = 1.25;  // so much more may be missed without a number
    const auto missed = [](const ModelScore* score) {
        return score->surface_left_out * (score->fitted.model.fitted() ? simpler : 1.0);
    };
    const auto least = std::min_element(
        alike.begin(), alike.end(), [&](const ModelScore* a, const ModelScore* b) { return missed(a) < missed(b); });
    return least == alike.end() ? nullptr : *least;
}

Ranking rank_models(const std::vector<ModelPoints>& models, parallel::Threads threads) {
    std::vector<std::optional<ModelScore>> scores(models.size());
    std::vector<std::string> reasons(models.size());
    parallel::for_each_index(models.size(), threads, [&](std::size_t i) {
        try {
            require_enough(models[i].points);
            scores[i] = score(models[i]);
        } catch (const Cancelled&) {
            throw;
        } catch (const Error& error) {
            reasons[i] = error.what();
        }
    });
    Ranking ranking;
    for (std::size_t i = 0; i < models.size(); ++i) {
        if (scores[i]) ranking.models.push_back(std::move(*scores[i]));
        else ranking.unranked.push_back({models[i].model, reasons[i]});
    }
    if (ranking.models.empty()) return ranking;
    std::stable_sort(ranking.models.begin(), ranking.models.end(), [](const ModelScore& a, const ModelScore& b) {
        return a.left_out_log_likelihood > b.left_out_log_likelihood;
    });
    double sum = 0.0;
    for (auto& model : ranking.models) {
        model.weight = std::exp(model.left_out_log_likelihood - ranking.models.front().left_out_log_likelihood);
        sum += model.weight;
    }
    for (auto& model : ranking.models) model.weight /= sum;
    return ranking;
}

}  // namespace setae::hysteresis
