// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/edge_speeds.hpp"

#include <algorithm>
#include <array>
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

/// ln G0, ln v0 and ln n.
using Logarithms = Eigen::Vector3d;

/// ln G of a law at three speeds, and its derivatives by ln G0, ln v0 and ln n.
struct RatesAtSpeeds {
    Eigen::Vector3d rates;
    Eigen::Matrix3d slopes;

    RatesAtSpeeds(const Logarithms& law, const std::array<double, 3>& speeds) {
        const double exponent = std::exp(law[2]);
        for (Index k = 0; k < 3; ++k) {
            const double decades = std::log(speeds[static_cast<std::size_t>(k)]) - law[1];  // ln v/v0
            const double fast = std::exp(exponent * decades), share = fast / (1.0 + fast);
            rates[k] = law[0] + std::log1p(fast);
            slopes.row(k) << 1.0, -exponent * share, exponent * decades * share;
        }
    }
};

/// Combines the laws of several edges.
///
/// Errors of G0, v0 and n are strongly correlated along a curved ridge, so that their means would not be on it; those
/// of G at speeds within the range of the edges are almost uncorrelated. Their means at three speeds, weighted by the
/// inverse of their covariance, determine the law.
class Combination {
public:
    /// @throws UndefinedDataError for a fit without standard errors.
    void add(const loops::CrackSpeedFit& fit) {
        const Logarithms values(fit.threshold.value, fit.reference_speed.value, fit.exponent.value);
        const Eigen::Vector3d inverse = values.cwiseInverse();
        const Eigen::Matrix3d covariance =
            inverse.asDiagonal() * fit.covariance.topLeftCorner<3, 3>() * inverse.asDiagonal();
        if (!covariance.inverse().allFinite() || !(fit.slow_speed > 0.0) || !(fit.speed_ratio > 1.0))
            throw UndefinedDataError("the fitted speed dependence of the contact edge has no standard errors");
        laws_.emplace_back(values.array().log().matrix());
        covariances_.push_back(covariance);
        slow_ += std::log(fit.slow_speed);
        range_ += std::log(fit.speed_ratio);
    }

    /// work_approach: W_app of the references. @throws UndefinedDataError where no law has these means.
    [[nodiscard]] ElastomerEdgeSpeed result(const std::string& elastomer, const TracedValue& work_approach) const {
        const auto speeds = common_speeds();
        Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
        Eigen::Vector3d weighted = Eigen::Vector3d::Zero();
        std::vector<Eigen::Vector3d> rates;
        std::vector<Eigen::Matrix3d> weights;
        for (std::size_t i = 0; i < laws_.size(); ++i) {
            const RatesAtSpeeds at(laws_[i], speeds);
            const Eigen::Matrix3d weight = (at.slopes * covariances_[i] * at.slopes.transpose()).inverse();
            information += weight;
            weighted += weight * at.rates;
            rates.push_back(at.rates);
            weights.push_back(weight);
        }
        const Eigen::Vector3d mean = information.inverse() * weighted;
        const Logarithms law = law_through(mean, speeds);
        const Eigen::Matrix3d back = RatesAtSpeeds(law, speeds).slopes.inverse();
        const Eigen::Matrix3d covariance =
            scatter_about(mean, rates, weights) * back * information.inverse() * back.transpose();
        const Eigen::Matrix3d root = covariance.llt().matrixL();
        const Eigen::Vector3d values = law.array().exp().matrix();
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
                .references = static_cast<int>(laws_.size())};
    }

    [[nodiscard]] bool empty() const { return laws_.empty(); }

private:
    /// The slowest, the middle and the fastest that the edges went at, as a rule.
    [[nodiscard]] std::array<double, 3> common_speeds() const {
        const auto n = static_cast<double>(laws_.size());
        const double slow = slow_ / n, range = range_ / n;
        return {std::exp(slow), std::exp(slow + 0.5 * range), std::exp(slow + range)};
    }

    /// By Newton's steps, limited to one decade.
    [[nodiscard]] Logarithms law_through(const Eigen::Vector3d& rates, const std::array<double, 3>& speeds) const {
        Logarithms law = Logarithms::Zero();
        for (const auto& one : laws_) law += one / static_cast<double>(laws_.size());
        constexpr int most = 100;
        constexpr double longest = 0.5, settled = 1e-12;
        for (int i = 0; i < most; ++i) {
            const RatesAtSpeeds at(law, speeds);
            Logarithms step = at.slopes.inverse() * (rates - at.rates);
            if (!step.allFinite()) break;
            const double length = step.cwiseAbs().maxCoeff();
            if (length > longest) step *= longest / length;
            law += step;
            if (length < settled) return law;
        }
        throw UndefinedDataError("the contact edges of the references differ too much for one speed dependence");
    }

    /// By how much references differ beyond their own errors: χ² over its degrees of freedom, at least 1.
    [[nodiscard]] static double scatter_about(const Eigen::Vector3d& mean, const std::vector<Eigen::Vector3d>& rates,
                                              const std::vector<Eigen::Matrix3d>& weights) {
        if (rates.size() < 2) return 1.0;
        double chi2 = 0.0;
        for (std::size_t i = 0; i < rates.size(); ++i) {
            const Eigen::Vector3d off = rates[i] - mean;
            chi2 += off.dot(weights[i] * off);
        }
        return std::max(1.0, chi2 / (3.0 * static_cast<double>(rates.size() - 1)));
    }

    std::vector<Logarithms> laws_;
    std::vector<Eigen::Matrix3d> covariances_;
    /// sums of ln of the slowest speeds, and of ln of the ratios of the fastest to the slowest
    double slow_ = 0.0, range_ = 0.0;
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
    std::string reason = "no loop on a smooth reference";
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
    try {
        return combination.result(
            elastomer, TracedValue(mean_of(approach), fmt::format("W_app of the references on {}", elastomer)));
    } catch (const UndefinedDataError& error) {
        return NoEdgeSpeed::missing(error.what());
    }
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
