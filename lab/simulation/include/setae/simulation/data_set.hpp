// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/parallel/for_each.hpp"
#include "setae/simulation/recipe.hpp"

namespace setae::simulation {

/// One loop of the data set and what is planted in it.
struct PlantedLoop {
    std::string file;     ///< relative to the data set's folder
    std::string surface;  ///< empty for a reference
    std::string elastomer;
    std::string stage;                      ///< of references: "before" or "after"
    hysteresis::HystereticSphere specimen;  ///< R, E*, W_app, W_ret at rest
    hysteresis::ViscousBody body{};         ///< what its elastomer does in time
    hysteresis::SphereLoop truth;
    bool measured = true;  ///< else there is no file: the pair is for the study to predict
    int number = 1;        ///< among the loops of its pair
};

/// What a recipe's loops are: one a surface and elastomer, then the references, then further ones of the same pairs.
///
///   W_app = W_int r − γ1 (r − 1) − E* U_el/(A E*)   [D19] (7), r and U_el of the known surface
///   W_ret: by the recipe's law, or such that E_loss = f W_int r π a_max²; times φ of the elastomer
///
/// @throws InvalidArgument where a pair would not conform (W_app <= 0) or its jumps alone lose more than E_loss, unless
/// such pairs are left out; the message names the pair. Nothing for a recipe without loops. Source: [D19] (7), (10).
[[nodiscard]] std::vector<PlantedLoop> planted_loops(const Recipe& recipe);

/// The same with the truth of each surface, in the recipe's order, where it is known already.
/// @throws InvalidArgument for another number of truths than surfaces, too.
[[nodiscard]] std::vector<PlantedLoop> planted_loops(const Recipe& recipe, const std::vector<SurfaceTruth>& truths);

/// Makes a data set in a folder, which is created: what instruments would have recorded, and what is behind it.
///
/// NAME/stylus_K.csv (stylus_reference_K.csv where the drive has an artefact), NAME/afm_K.txt, NAME/tem_K.csv (heights
/// [nm]); loops/…csv; truth.json (planted values, SI), truth spectra as NAME/truth.csv; study.toml, which analyses all
/// of it. Same bytes for any number of threads. Files are replaced as wholes; those of other recipes in the same folder
/// are left.
///
/// Surfaces. Stylus: a strip for all scans of one length, side by side; without a tip a line each. AFM: a patch a
/// quarter wider than each map. TEM: a line of the surface, eight times as long as each contour; of a foil with
/// thickness a patch. Waves up to eight times as long as what is measured are in it; longer ones are missing, but for
/// transformed heights, where they set the height about which the patch lies.
/// @return files written, relative to the folder, in order.
/// @throws FileError; InvalidArgument as planted_loops and for protocols that contradict a surface.
std::vector<std::string> make(const Recipe& recipe, const std::string& folder, parallel::Threads threads = {});

}  // namespace setae::simulation
