// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include "setae/contact/layer.hpp"
#include "setae/loops/model_fits.hpp"

namespace setae::loops {

/// A model's parameters on the scale of fits, one slot each; models with fewer do not use the last ones.
///
/// 0: ln E*.  1: signed √W (jkr, layer, large_strain: the root of W in the force, so that fits pass through 0), W
/// (dmt), ln W (maugis_dugdale).  2: ln λ, or ln σ0 where that is given.  Transition: ln a0, ln(−Fc), ln(α/(1 − α)).
using CurveParameters = Eigen::Vector3d;

/// A point of a model's curve and its derivatives by the coordinate t along it and by the parameters.
struct CurvePoint {
    double force = 0.0, displacement = 0.0, radius = 0.0;
    double force_slope = 0.0, displacement_slope = 0.0, radius_slope = 1.0;
    std::array<double, 3> force_by{}, displacement_by{};
};

/// A model's curve through force, displacement and contact radius.
///
/// The coordinate t is the contact radius; Hertz's and DMT's curves continue below t = 0 for separated bodies: δ =
/// −t²/R, the force as at t = 0.
class ModelCurve {
public:
    /// @throws InvalidArgument for a layer without thickness or R <= 0.
    ModelCurve(ContactModel model, const LensAndCounterBody& bodies, bool stress_given = false);

    [[nodiscard]] ContactModel model() const { return model_; }
    [[nodiscard]] double radius() const { return radius_; }
    /// Whether the third slot of Maugis–Dugdale is ln σ0.
    [[nodiscard]] bool stress_given() const { return stress_given_; }
    /// Number of slots of the model.
    [[nodiscard]] int parameters() const;
    /// Whether separated bodies are part of the curve.
    [[nodiscard]] bool includes_separation() const {
        return model_ == ContactModel::hertz || model_ == ContactModel::dmt;
    }
    /// Largest t [m] the model holds for.
    [[nodiscard]] double largest_radius() const;
    [[nodiscard]] CurvePoint at(double t, const CurveParameters& parameters) const;
    /// W [J/m²] of the parameters; not of transition.
    [[nodiscard]] double work_of_adhesion(const CurveParameters& parameters) const;
    /// The slot's value for W [J/m²].
    [[nodiscard]] double work_slot(double work_of_adhesion) const;
    /// λ of Maugis–Dugdale's parameters, kept within 1e-3 … 1e3.
    [[nodiscard]] double transition_parameter(const CurveParameters& parameters) const;
    /// t at force F without adhesion's inner branch, from above: no smaller than the model's own.
    [[nodiscard]] double radius_bound(double force, const CurveParameters& parameters) const;

private:
    [[nodiscard]] CurvePoint apart_or_pressed(double t, const CurveParameters& parameters) const;
    [[nodiscard]] CurvePoint edge_point(double t, const CurveParameters& parameters) const;
    [[nodiscard]] CurvePoint zone_point(double t, const CurveParameters& parameters) const;
    [[nodiscard]] CurvePoint transition_point(double t, const CurveParameters& parameters) const;

    ContactModel model_;
    double radius_;
    bool stress_given_;
    std::optional<contact::layer::Layer> layer_;
};

}  // namespace setae::loops
