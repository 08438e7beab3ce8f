// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/core/units.hpp"
#include "setae/fields/option.hpp"
#include "setae/study/contact_answers.hpp"
#include "setae/study/study_result.hpp"

namespace setae::answers {

/// Request of `setae adhesion`: a soft solid and its partner; see docs/concepts/theory.md.
struct AdhesionRequest {
    std::string youngs_modulus, work, surface_energy;
    double poisson_ratio = 0.5;
    std::string rough_modulus;  ///< empty: the rough solid is rigid
    double rough_poisson_ratio = 0.0;
    std::string radius, preload;  ///< both or none

    /// @throws InvalidArgument where something is missing or malformed.
    [[nodiscard]] study::Study study(const study::SurfaceAnalysisOptions& analysis) const;
};

/// W_app of a soft solid on a surface: the recommended result, the other theories, the balances of [D19] (Eqs. 7, S13
/// and 2) with their inputs and, with a sphere, its loop.
struct Adhesion {
    study::StudyResult result;  ///< one surface, one elastomer, one pair
    std::vector<Quantity> quantities;
    study::ContactAnswers answers;

    [[nodiscard]] const study::SurfaceResult& surface() const { return result.surfaces.front(); }
    [[nodiscard]] std::vector<Alert> alerts() const;
};

/// surface: that did not fail; its map, where there is one, gives the energy by further routes. @throws as
/// AdhesionRequest::study() and predicted_study().
[[nodiscard]] Adhesion adhesion(study::SurfaceWithMap surface, const study::SurfaceAnalysisOptions& analysis,
                                const AdhesionRequest& request, parallel::Threads threads = {});

}  // namespace setae::answers

template <>
struct setae::fields::Asked<setae::answers::AdhesionRequest> {
    using R = answers::AdhesionRequest;
    static constexpr std::array options{
        option<&R::youngs_modulus>("youngs_modulus", "Young's modulus of the soft solid")
            .of(positive(dimension::pressure))
            .such_as("0.7 ± 0.02 MPa")
            .short_name("E")
            .in_python("E")
            .required(),
        option<&R::poisson_ratio>("poisson_ratio", "Poisson ratio of the soft solid, from 0 to 0.5")
            .within(domain::poisson_ratio)
            .default_shown()
            .short_name("nu")
            .in_python("nu"),
        option<&R::work>("work_of_adhesion", "intrinsic work of adhesion")
            .of(positive(dimension::surface_energy))
            .such_as("37 ± 3.7 mJ/m2")
            .short_name("w")
            .in_python("W_int")
            .required(),
        option<&R::surface_energy>("surface_energy", "surface energy of the soft solid")
            .of(non_negative(dimension::surface_energy))
            .such_as("25 mJ/m2")
            .short_name("gamma")
            .in_python("gamma")
            .required(),
        option<&R::rough_modulus>("rough_E", "Young's modulus of the rough solid")
            .of(positive(dimension::pressure))
            .such_as("70 GPa")
            .or_else("a rigid solid")
            .advanced(),
        option<&R::rough_poisson_ratio>("rough_nu", "Poisson ratio of the rough solid, from 0 to 0.5")
            .within(domain::poisson_ratio)
            .default_shown()
            .advanced(),
        option<&R::radius>("radius",
                           "radius of a soft sphere that is pressed on and pulled off, given with the preload")
            .of(positive(dimension::length))
            .such_as("1.25 mm"),
        option<&R::preload>("preload", "largest force on the soft sphere, given with the radius")
            .of(non_negative(dimension::force))
            .such_as("1 mN"),
    };
};
