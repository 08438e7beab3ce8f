// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "setae/fields/describe.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/simulation/recipe.hpp"

namespace setae::simulation {

/// One loop of the data set with its known parameters.
struct KnownLoop {
    std::string file;     ///< path relative to the folder of the data set
    std::string surface;  ///< empty for a reference
    std::string elastomer;
    std::string stage;                      ///< for references: "before" or "after"
    hysteresis::HystereticSphere specimen;  ///< R, E*, W_app, W_ret at zero speed
    hysteresis::ViscousBody body{};         ///< time dependence of the elastomer
    hysteresis::SphereLoop truth;
    bool measured = true;  ///< false: there is no file; the study predicts the pair
    int number = 1;        ///< number among the loops of its pair
};

/// Loops of a recipe: one per surface and elastomer, then the references, then further loops of the same pairs.
///
///   W_app = W_int r − γ1 (r − 1) − E* U_el/(A E*)   [D19], Eq. 7, r and U_el of the known surface
///   W_ret: by the retraction model of the recipe, or such that E_loss = f W_int r π a_max²; times φ of the elastomer
///
/// @throws InvalidArgument where a pair has no full contact (W_app <= 0) or its jumps dissipate more than E_loss,
/// unless such pairs are left out; the message names the pair. Empty for a recipe without loops. Source: [D19], Eqs. 7,
/// 10.
[[nodiscard]] std::vector<KnownLoop> known_loops(const Recipe& recipe);

/// The loops for known true values of each surface, in the recipe's order.
/// @throws InvalidArgument also for another number of true values than surfaces.
[[nodiscard]] std::vector<KnownLoop> known_loops(const Recipe& recipe, const std::vector<TrueSurfaceValues>& truths);

/// Makes a data set in a folder, which is created: simulated records of the instruments, and their true values.
///
/// NAME/stylus_K.csv (stylus_reference_K.csv where the drive has an artefact), NAME/afm_K.txt, NAME/tem_K.csv (heights
/// [nm]); loops/…csv; truth.json (true values, SI), true spectra as NAME/truth.csv; study.toml, which analyses all of
/// it. Equal bytes for any number of threads. Files are replaced as wholes; those of other recipes in the same folder
/// are kept.
///
/// Surfaces. Stylus: one strip for all scans of one length, side by side; without a tip one line per scan. AFM: a patch
/// a quarter wider than each map. TEM: a line of the surface, eight times as long as each contour; for a foil with
/// thickness a patch. The surfaces contain waves up to eight times as long as the measurement; longer ones are missing,
/// except for transformed heights, where they set the mean height of the patch.
/// @return files written, relative to the folder, in order.
/// @throws FileError; InvalidArgument as known_loops and for protocols that contradict a surface.
std::vector<std::string> make(const Recipe& recipe, const std::string& folder, parallel::Threads threads = {});

/// Output of `setae lab make`.
struct MakeOutput {
    std::string recipe;
    std::uint64_t seed = 0;
    std::string folder;
    std::vector<std::string> files;
};

}  // namespace setae::simulation

template <>
struct setae::fields::Described<setae::simulation::MakeOutput> {
    using T = simulation::MakeOutput;
    static constexpr std::array rows{
        field<&T::recipe>("recipe", "name of the recipe's file, as given"),
        field<&T::seed>("seed", "seed of the random numbers"),
        field<&T::folder>("folder", "folder of the files"),
        field<&T::files>("files", "files that were written, relative to the folder"),
    };
    static constexpr Description description{"", "simulated experimental files", rows};
};
static_assert(setae::fields::complete<setae::simulation::MakeOutput>);
