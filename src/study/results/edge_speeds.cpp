// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/edge_speeds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>

#include "setae/core/errors.hpp"
#include "setae/study/loop_dependence.hpp"
#include "setae/study/study_result.hpp"
#include "statistics.hpp"

namespace setae::study {
namespace {

using NoEdgeSpeed = loops::Outcome<ElastomerEdgeSpeed>;

ElastomerEdgeSpeed stated(const StatedEdgeSpeed& input, const std::string& elastomer) {
    const auto traced = [&](const Estimate& value, const char* key) {
        return TracedValue(value, input_name(value, fmt::format("elastomers.{}.crack_speed.{}", elastomer, key)));
    };
    return {.law = {traced(input.reference_speed, "reference_speed"), traced(input.exponent, "exponent")},
            .threshold = {}};
}

/// ln G0, ln v0 and ln n of several edges as one, with its covariance.
class Combination {
public:
    void add(const loops::CrackSpeedFit& fit) {
        const Eigen::Vector3d values(fit.threshold.value, fit.reference_speed.value, fit.exponent.value);
        const Eigen::Vector3d inverse = values.cwiseInverse();
        const Eigen::Matrix3d covariance =
            inverse.asDiagonal() * fit.covariance.topLeftCorner<3, 3>() * inverse.asDiagonal();
        const Eigen::Matrix3d weight = covariance.inverse();
        if (!weight.allFinite()) throw UndefinedDataError("the law of its edge has no standard errors");
        logarithms_.emplace_back(values.array().log().matrix());
        weights_.push_back(weight);
    }

    /// work_approach: W_app of the references.
    [[nodiscard]] ElastomerEdgeSpeed result(const std::string& elastomer, const TracedValue& work_approach) const {
        Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
        Eigen::Vector3d weighted = Eigen::Vector3d::Zero();
        for (std::size_t i = 0; i < weights_.size(); ++i) {
            information += weights_[i];
            weighted += weights_[i] * logarithms_[i];
        }
        const Eigen::Vector3d mean = information.inverse() * weighted, values = mean.array().exp().matrix();
        const Eigen::Matrix3d covariance = scatter_about(mean) * information.inverse();
        const Eigen::Matrix3d root = covariance.llt().matrixL();
        const auto name = fmt::format("speed of the references' edges on {}", elastomer);
        const auto traced = [&](Index k) {
            Component component;
            component.directions = values[k] * root.row(k).transpose().array();
            return TracedValue(values[k], Components{{name, std::move(component)}});
        };
        const auto rest =
            setae::propagated([](const std::vector<double>& in) { return in[0] / in[1]; }, {traced(0), work_approach});
        return {.law = {traced(1), traced(2), rest},
                .threshold = Estimate{.value = values[0], .standard_error = values[0] * std::sqrt(covariance(0, 0))},
                .references = static_cast<int>(weights_.size())};
    }

    [[nodiscard]] bool empty() const { return weights_.empty(); }

private:
    /// By how much references differ beyond their own errors: χ² over its degrees of freedom, at least 1.
    [[nodiscard]] double scatter_about(const Eigen::Vector3d& mean) const {
        if (weights_.size() < 2) return 1.0;
        double chi2 = 0.0;
        for (std::size_t i = 0; i < weights_.size(); ++i) {
            const Eigen::Vector3d off = logarithms_[i] - mean;
            chi2 += off.dot(weights_[i] * off);
        }
        return std::max(1.0, chi2 / (3.0 * static_cast<double>(weights_.size() - 1)));
    }

    std::vector<Eigen::Vector3d> logarithms_;
    std::vector<Eigen::Matrix3d> weights_;
};

/// The sum of drives, and how many.
struct SummedDrives {
    PairDrive sum;
    int count = 0;

    void add(const ExperimentResult& e) {
        const double stiffness =
            e.input.machine_stiffness ? e.input.machine_stiffness->value : std::numeric_limits<double>::infinity();
        const auto drive = loops::loop_drive(*e.analysis, stiffness);
        if (!drive) return;
        sum.drive.approach_speed += drive->approach_speed;
        sum.drive.retraction_speed += drive->retraction_speed;
        sum.drive.hold_time += drive->hold_time;
        if (const auto& fit = e.analysis->retraction)
            sum.reading_time += e.analysis->corrected.time[fit->last] - e.analysis->corrected.time[fit->first];
        ++count;
    }

    [[nodiscard]] PairDrive mean() const {
        const double share = 1.0 / count;
        return {{share * sum.drive.approach_speed, share * sum.drive.retraction_speed, share * sum.drive.hold_time},
                share * sum.reading_time};
    }
};

}  // namespace

loops::Outcome<ElastomerEdgeSpeed> edge_speed_of(const StudyResult& result, const std::string& elastomer) {
    if (const auto& input = result.elastomer(elastomer).input.crack_speed) return stated(*input, elastomer);
    Combination combination;
    std::vector<Estimate> approach;
    std::string reason = "no loop on a smooth standard";
    for (const auto& e : result.experiments) {
        if (!e.edge_speed || e.input.excluded() || e.input.elastomer != elastomer) continue;
        try {
            const auto& fit = *e.edge_speed;
            if (!fit) throw UndefinedDataError(fit.reason);
            combination.add(*fit);
            approach.push_back(e.analysis->loading.primary().work_of_adhesion);
        } catch (const UndefinedDataError& error) {
            reason = fmt::format("{}: {}", e.input.file, error.what());
        }
    }
    if (combination.empty()) return NoEdgeSpeed::missing(reason);
    return combination.result(elastomer,
                              TracedValue(mean_of(approach), fmt::format("W_app of the references on {}", elastomer)));
}

std::vector<hysteresis::TracedRelaxation> relaxation_of(const StudyResult& result, const std::string& elastomer) {
    std::vector<hysteresis::TracedRelaxation> terms;
    for (const auto& term : result.elastomer(elastomer).input.relaxation) {
        const auto traced = [&](const Estimate& value, const char* key) {
            return TracedValue(value, input_name(value, fmt::format("elastomers.{}.relaxation[{}].{}", elastomer,
                                                                    terms.size() + 1, key)));
        };
        terms.push_back({traced(term.share, "share"), traced(term.time, "time")});
    }
    return terms;
}

std::optional<PairDrive> drive_of(const StudyResult& result, const std::string& surface, const std::string& elastomer) {
    SummedDrives on_pair, on_elastomer;
    for (const auto& e : result.experiments) {
        if (!e.analysis || e.input.excluded() || e.input.elastomer != elastomer) continue;
        on_elastomer.add(e);
        if (!e.input.reference && e.input.surface == surface) on_pair.add(e);
    }
    std::optional<PairDrive> found;
    if (on_pair.count > 0) return on_pair.mean();
    if (on_elastomer.count > 0) found = on_elastomer.mean();
    const auto& input = result.elastomer(elastomer).input;
    if (input.speed) {
        if (!found) found.emplace();
        found->drive.approach_speed = found->drive.retraction_speed = *input.speed;
    }
    if (found && input.hold_time) found->drive.hold_time = *input.hold_time;
    return found;
}

}  // namespace setae::study
