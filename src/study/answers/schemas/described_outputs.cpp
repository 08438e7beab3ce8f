// SPDX-License-Identifier: GPL-3.0-or-later
#include "schemas/described_outputs.hpp"

#include "setae/answers/curve_fields.hpp"
#include "setae/answers/import_fields.hpp"
#include "setae/answers/lens.hpp"
#include "setae/answers/line_fields.hpp"
#include "setae/answers/loop_fields.hpp"
#include "setae/answers/radius_fields.hpp"

namespace setae::answers::schemas {
namespace {

template <fields::HasRows T>
constexpr DescribedOutput one(std::string_view command) {
    return {.command = command, .description = &fields::Described<T>::description};
}

constexpr DescribedOutput outputs[]{
    one<FittedLoop>("jkr fit"),      one<SharedLoops>("jkr fit"), one<FittedCurve>("jkr fit"),
    one<study::ForceMap>("jkr fit"), one<Lens>("jkr lens"),
};

}  // namespace

std::span<const DescribedOutput> described_outputs() { return outputs; }

}  // namespace setae::answers::schemas
