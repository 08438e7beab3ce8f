// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/output/json.hpp"
#include "setae/study/contact_answers.hpp"
#include "setae/study/study_result.hpp"

namespace setae::answers {

/// What `setae adhesion` is told of a soft solid and its partner; see docs/concepts/theory.md.
struct AdhesionRequest {
    std::string youngs_modulus, work, surface_energy;  ///< "0.7 ± 0.02 MPa", "37 mJ/m2", "25 mJ/m2"
    double poisson_ratio = 0.5;
    std::string rough_modulus;  ///< empty: the rough solid is rigid
    double rough_poisson_ratio = 0.0;
    std::string radius, preload;  ///< of a sphere pressed on and pulled off; both or none

    /// @throws InvalidArgument where something is missing or malformed.
    [[nodiscard]] study::Study study(const study::SurfaceAnalysisOptions& analysis) const;
};

/// W_app of a soft solid on a surface: the recommended answer beside the other theories, (7), (S13) and (2) of [D19]
/// with what they rest on and, where a sphere was named, its loop.
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

/// Quantities by name, "answers", "contact", "conforms", "scales", "channel" and "alerts".
[[nodiscard]] output::Json to_json(const Adhesion& adhesion);

}  // namespace setae::answers
