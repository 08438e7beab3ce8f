// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/contact_problem.hpp"

#include "setae/answers/diagnosis.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/study/pipeline_file.hpp"

namespace setae::cli {

void add_body_options(Options& options, answers::BodyRequest& body) {
    options.add("--contact-modulus", body.contact_modulus, "E* of the body, such as \"1 GPa\"")
        .quantity(positive(dimension::pressure));
    options.add("--layer", body.layer, "thickness of an elastic layer on a rigid base, such as \"1 um\"")
        .quantity(positive(dimension::length));
    options.flag("--bonded", body.bonded, "the layer sticks to its base");
    options.flag("--frictionless", body.frictionless, "the layer slides on its base");
    options.add("--nu,--poisson-ratio", body.poisson_ratio, "Poisson ratio of the layer, up to 0.5");
}

void add_interaction_options(Options& options, answers::InteractionRequest& interaction) {
    options.add("--w,--work-of-adhesion", interaction.work_of_adhesion, "work of adhesion, such as \"50 mJ/m2\"")
        .quantity(positive(dimension::surface_energy));
    options
        .add("--range", interaction.range,
             "range of the attraction, such as \"0.3 nm\": its greatest tension is w over it")
        .quantity(positive(dimension::length));
    options.add("--law", interaction.law, "how the attraction falls with the gap")
        .one_of({"exponential", "cubic", "dugdale", "lennard_jones"})
        .default_shown();
}

void ContactSurface::add_to(Options& options) {
    options.add("file", path, "a map or a line, or a file or container that holds one").of_inputs();
    file.add_to(options);
    processing.add_to(options);
}

processing::PipelineResult ContactSurface::processed() const {
    if (path.empty()) throw InvalidArgument("no file; expected a map");
    return processing::apply(processing.pipeline(), answers::measurements_of(path, file).front(),
                             study::measurement_loader(file.read_options()));
}

}  // namespace setae::cli
