// SPDX-License-Identifier: GPL-3.0-or-later
#include "schemas/described_outputs.hpp"

#include "setae/answers/adhesion_fields.hpp"
#include "setae/answers/blind_tip.hpp"
#include "setae/answers/camera_scale.hpp"
#include "setae/answers/comparison_fields.hpp"
#include "setae/answers/container_fields.hpp"
#include "setae/answers/contents_fields.hpp"
#include "setae/answers/converted_files.hpp"
#include "setae/answers/curve_fields.hpp"
#include "setae/answers/diagnosis.hpp"
#include "setae/answers/draft_fields.hpp"
#include "setae/answers/format_list.hpp"
#include "setae/answers/front_fields.hpp"
#include "setae/answers/import_fields.hpp"
#include "setae/answers/kept_results.hpp"
#include "setae/answers/lens.hpp"
#include "setae/answers/line_fields.hpp"
#include "setae/answers/loop_fields.hpp"
#include "setae/answers/machine_stiffness.hpp"
#include "setae/answers/parameters.hpp"
#include "setae/answers/patch_survey_fields.hpp"
#include "setae/answers/persson_fields.hpp"
#include "setae/answers/power_spectrum_fields.hpp"
#include "setae/answers/processed_file.hpp"
#include "setae/answers/profile_fields.hpp"
#include "setae/answers/radius_fields.hpp"
#include "setae/answers/replicates.hpp"
#include "setae/answers/scale_fields.hpp"
#include "setae/answers/solve_fields.hpp"
#include "setae/answers/study_plan.hpp"
#include "setae/answers/sweep_fields.hpp"
#include "setae/answers/synthesis_fields.hpp"
#include "setae/answers/texture.hpp"
#include "setae/fields/describe.hpp"
#include "setae/output/contour_fields.hpp"
#include "setae/output/hysteresis_fields.hpp"
#include "setae/output/next_measurement_output.hpp"
#include "setae/output/study_description.hpp"
#include "setae/study_figures/figure_fields.hpp"

namespace setae::answers::schemas {
namespace {

template <fields::HasRows T>
constexpr DescribedOutput one(std::string_view command) {
    return {.command = command, .description = &fields::Described<T>::description};
}

/// A list of such results.
template <fields::HasRows T>
constexpr DescribedOutput list(std::string_view command) {
    return {.command = command, .description = &fields::Described<T>::description, .is_list = true};
}

constexpr DescribedOutput outputs[]{
    {.command = "acf", .description = &acf_description},
    one<Adhesion>("adhesion"),
    one<KeptResults>("cache"),
    one<RemovedResults>("cache"),
    list<diagnostics::Finding>("check"),
    one<ContactComparison>("contact compare"),
    one<ContactOutput<FrontAnswer>>("contact front"),
    one<PerssonContact>("contact persson"),
    one<ContactOutput<HardWallAnswer>>("contact solve"),
    one<ContactOutput<AdhesiveContactAnswer>>("contact solve"),
    one<ContactOutput<SweepAnswer>>("contact sweep"),
    one<CheckedContainers>("container check"),
    one<WrittenContainer>("container write"),
    one<output::ContourEntry>("contour"),
    one<ConvertedFile>("convert"),
    one<ConvertedFiles>("convert"),
    one<FormatList>("formats"),
    one<Contents>("info"),
    one<imaging::CameraScale>("jkr camera"),
    one<LoopEnergies>("jkr energy"),
    one<FittedLoop>("jkr fit"),
    one<SharedLoops>("jkr fit"),
    one<FittedCurve>("jkr fit"),
    one<study::ForceMap>("jkr fit"),
    one<ImportedLoop>("jkr import"),
    one<Lens>("jkr lens"),
    one<LineAnswer>("jkr line"),
    one<ComparedLine>("jkr line"),
    one<imaging::ContactRadii>("jkr radius"),
    one<StiffnessOfFile>("jkr stiffness"),
    one<ReplicateSummary>("jkr summary"),
    one<PatchSurveyAnswer>("lab conform"),
    one<ProcessingRecords>("level"),
    list<ParameterEntry>("params"),
    list<TextureEntry>("params"),
    one<study_figures::PlottedFigure>("plot"),
    one<study_figures::FigureList>("plot"),
    one<output::HysteresisEntry>("predict"),
    one<ProfileEntry>("profile"),
    one<PowerSpectrum>("psd"),
    {.command = "sdrp", .description = &sdrp_description},
    {.command = "study", .description = &output::study_description},
    one<StudyPlan>("study"),
    one<output::NextMeasurements>("study"),
    one<DraftEntry>("study init"),
    {.command = "synthesize", .description = &synthetic_surface_description},
    {.command = "synthesize", .description = &synthetic_line_description},
    one<BlindTipAnswer>("tip"),
    {.command = "vbw", .description = &vbw_description},
};

}  // namespace

std::span<const DescribedOutput> described_outputs() { return outputs; }

}  // namespace setae::answers::schemas
