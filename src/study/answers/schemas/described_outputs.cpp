// SPDX-License-Identifier: GPL-3.0-or-later
#include "schemas/described_outputs.hpp"

#include "setae/answers/adhesion_fields.hpp"
#include "setae/answers/container_fields.hpp"
#include "setae/answers/contents_fields.hpp"
#include "setae/answers/format_list.hpp"
#include "setae/answers/lens.hpp"
#include "setae/answers/patch_survey_fields.hpp"
#include "setae/answers/power_spectrum_fields.hpp"
#include "setae/fields/describe.hpp"
#include "setae/output/contour_fields.hpp"
#include "setae/study_figures/figure_fields.hpp"

namespace setae::answers::schemas {
namespace {

template <fields::HasRows T>
constexpr DescribedOutput one(std::string_view command) {
    return {.command = command, .description = &fields::Described<T>::description};
}

constexpr DescribedOutput outputs[]{
    one<Adhesion>("adhesion"),
    one<CheckedContainers>("container check"),
    one<WrittenContainer>("container write"),
    one<output::ContourEntry>("contour"),
    one<FormatList>("formats"),
    one<Contents>("info"),
    one<Lens>("jkr lens"),
    one<PatchSurveyAnswer>("lab conform"),
    one<study_figures::PlottedFigure>("plot"),
    one<study_figures::FigureList>("plot"),
    one<PowerSpectrum>("psd"),
};

}  // namespace

std::span<const DescribedOutput> described_outputs() { return outputs; }

}  // namespace setae::answers::schemas
