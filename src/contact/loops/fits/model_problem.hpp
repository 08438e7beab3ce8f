// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "least_squares.hpp"
#include "model_curve.hpp"

namespace setae::loops {

/// Parameters of a fit: the curve's slots and, in units of the displacements' range from their first, the contact
/// point.
using FitParameters = Eigen::Vector4d;
constexpr Index contact_point_slot = 3;

/// A section of a model's curve, tabulated for first guesses. It starts at the smallest displacement of the outer
/// branch.
struct CurveTable {
    std::vector<double> t;
    std::vector<CurvePoint> points;
    double min_t = 0.0;         ///< at the start of the outer branch
    std::size_t min_force = 0;  ///< entry of the least force: from there on forces rise

    /// t where a member has a value, linear between entries from `first` on, along which it rises.
    [[nodiscard]] double guess(double value, double CurvePoint::*member, std::size_t first) const;
    /// Another member where the force has a value.
    [[nodiscard]] double at_force(double force, double CurvePoint::*member) const;
};

/// Residuals of one branch about one model, over their noise.
class BranchProblem {
public:
    /// noise: every channel fitted has some > 0.
    BranchProblem(ModelCurve curve, const BranchData& data, Channels channels, FitErrors errors,
                  const ChannelNoise& noise);

    [[nodiscard]] const ModelCurve& curve() const { return curve_; }
    [[nodiscard]] bool has_displacement() const { return channels_ != Channels::force_radius; }
    [[nodiscard]] bool has_radius() const { return channels_ != Channels::force_displacement; }
    [[nodiscard]] Index samples() const { return force_.size(); }
    /// One per sample; two where three channels are fitted.
    [[nodiscard]] Index residuals() const {
        return channels_ == Channels::force_displacement_radius ? 2 * samples() : samples();
    }
    [[nodiscard]] double origin() const { return origin_; }
    [[nodiscard]] double depth_unit() const { return depth_unit_; }
    [[nodiscard]] double contact_point(const FitParameters& at) const {
        return origin_ + depth_unit_ * at[contact_point_slot];
    }
    [[nodiscard]] double contact_point_value(double contact_point) const {
        return (contact_point - origin_) / depth_unit_;
    }

    /// Fills residuals and, where requested, their derivatives by all four parameters.
    void evaluate(const FitParameters& at, Eigen::Ref<Eigen::VectorXd> residuals, Eigen::MatrixXd* jacobian) const;
    /// Sets the weights of effective variance to those at the parameters; the others have none to renew.
    /// @return the largest relative change of one
    double renew_weights(const FitParameters& at);
    [[nodiscard]] bool weights_change() const { return errors_ == FitErrors::effective_variance && has_radius(); }

    /// The point of the curve for each sample: the nearest, or with force_only that at the same abscissa.
    [[nodiscard]] std::vector<CurvePoint> fitted(const FitParameters& at) const;
    /// Measured − fitted of each channel that is fitted, at those points.
    [[nodiscard]] Array1D force_residuals(const std::vector<CurvePoint>& fitted) const;
    [[nodiscard]] Array1D displacement_residuals(const std::vector<CurvePoint>& fitted, const FitParameters& at) const;
    [[nodiscard]] Array1D radius_residuals(const std::vector<CurvePoint>& fitted) const;
    /// Σ of their squares divided by the noise.
    [[nodiscard]] double chi2(const std::vector<CurvePoint>& fitted, const FitParameters& at) const;
    /// Distance of a curve from the data along displacement and radius at their forces, for a search of starts: squares
    /// divided by the channels' ranges. Sets the contact point unless it is given.
    [[nodiscard]] double distance(FitParameters& at, bool contact_point_given) const;
    /// Every k-th sample, so that at most `most` are left.
    [[nodiscard]] BranchProblem thinned(Index most) const;

private:
    using Vector = Eigen::Vector3d;  ///< force, displacement, radius over their noise, uncorrelated
    struct Foot {
        double t = 0.0;
        CurvePoint point;
        Vector error, tangent;
        bool at_bound = false;
    };

    [[nodiscard]] CurveTable table(const FitParameters& at, Index entries) const;
    [[nodiscard]] Vector whitened(double force, double displacement, double radius) const;
    [[nodiscard]] Vector error(Index sample, const CurvePoint& point, double contact_point) const;
    /// The point at a displacement from first contact; the table's first where the curve ends above it, see ends_above.
    [[nodiscard]] CurvePoint point_at(double depth, const FitParameters& at, const CurveTable& table) const;
    [[nodiscard]] bool ends_above(double depth, const CurveTable& table) const;
    [[nodiscard]] Foot foot(Index sample, const FitParameters& at, const CurveTable& table) const;
    [[nodiscard]] Eigen::Matrix2d spread(const CurvePoint& point) const;
    void evaluate_feet(const FitParameters& at, Eigen::Ref<Eigen::VectorXd> residuals, Eigen::MatrixXd* jacobian) const;
    void evaluate_at_radius(const FitParameters& at, Eigen::Ref<Eigen::VectorXd> residuals,
                            Eigen::MatrixXd* jacobian) const;
    void evaluate_at_displacement(const FitParameters& at, Eigen::Ref<Eigen::VectorXd> residuals,
                                  Eigen::MatrixXd* jacobian) const;

    ModelCurve curve_;
    Channels channels_;
    FitErrors errors_;
    ChannelNoise noise_;
    Array1D force_, displacement_, radius_;
    double origin_ = 0.0, depth_unit_ = 1.0;
    double rounding_ = 0.0;  ///< rounding of whitened errors
    Eigen::Matrix3d whitening_ = Eigen::Matrix3d::Zero();
    std::vector<Eigen::Matrix2d> weights_;  ///< weights of effective variance, one per sample
};

}  // namespace setae::loops
