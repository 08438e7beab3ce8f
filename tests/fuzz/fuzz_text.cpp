// SPDX-License-Identifier: GPL-3.0-or-later
// One target a text that users write, or that setae wrote and reads again: the environment's SETAE_TEXT names it.
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <string>

#include "fuzz_input.hpp"
#include "running/serialization.hpp"
#include "setae/bytes/json_text.hpp"
#include "setae/bytes/source.hpp"
#include "setae/bytes/yaml_text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/core/units.hpp"
#include "setae/imaging/calibration_file.hpp"
#include "setae/loops/contact_point.hpp"
#include "setae/output/contour_file.hpp"
#include "setae/simulation/recipe.hpp"
#include "setae/study/pipeline_file.hpp"
#include "setae/study/study.hpp"
#include "setae/tables/loop_file.hpp"
#include "setae/tables/mapping.hpp"
#include "setae/tables/table_file.hpp"

namespace {

using namespace setae;
using Reading = std::function<void(const std::string& text)>;

/// A reading of a file of this ending, which holds the text.
Reading of_file(const std::string& ending, const std::function<void(const std::string& path)>& read) {
    static const auto folder = std::filesystem::exists("/dev/shm") ? std::filesystem::path("/dev/shm")
                                                                   : std::filesystem::temp_directory_path();
    const auto path = (folder / ("setae_fuzz_" + std::to_string(getpid()) + ending)).string();
    return [path, read](const std::string& text) {
        std::ofstream(path, std::ios::binary) << text;
        read(path);
    };
}

/// A quantity is finite, and is within the domain that it was asked for.
void read_quantity(const std::string& text) {
    const auto value = parse_uncertain_quantity(text, positive(dimension::length));
    if (!(value.value > 0.0) || !std::isfinite(value.value) || !(value.standard_error >= 0.0)) std::abort();
}

/// What is shown is UTF-8 without control characters.
void show(const std::string& text) {
    const auto shown = one_line(text);
    if (shown != one_line(shown) || shown != valid_utf8(shown)) std::abort();
    for (const char c : shown)
        if (static_cast<unsigned char>(c) < 0x20) std::abort();
}

const std::map<std::string, Reading>& readings() {
    static const std::map<std::string, Reading> list{
        {"study", of_file(".toml", [](const std::string& path) { (void)study::read_study(path); })},
        {"recipe", of_file(".toml", [](const std::string& path) { (void)simulation::read_recipe(path); })},
        {"mapping", of_file(".toml", [](const std::string& path) { (void)tables::read_mapping(path); })},
        {"pipeline_toml", of_file(".toml", [](const std::string& path) { (void)study::read_pipeline(path); })},
        {"pipeline_yaml", of_file(".yml", [](const std::string& path) { (void)study::read_pipeline(path); })},
        {"calibration", of_file(".json", [](const std::string& path) { (void)imaging::read_calibration(path); })},
        {"trace", of_file(".json", [](const std::string& path) { (void)output::read_trace(path); })},
        {"loop", of_file(".csv", [](const std::string& path) { (void)tables::read_table(path); })},
        {"unit", [](const std::string& text) { (void)parse_unit(text); }},
        {"quantity", read_quantity},
        {"contact_point", [](const std::string& text) { (void)loops::parse_contact_point(text); }},
        {"json", [](const std::string& text) { (void)bytes::parsed_json(text, "input", "no JSON").dump(); }},
        {"yaml", [](const std::string& text) { (void)bytes::parsed_yaml(text, "input"); }},
        {"entry", [](const std::string& text) { (void)study::value_of<study::SurfaceResult>(text); }},
        {"shown", show}};
    return list;
}

const Reading& chosen() {
    const char* name = std::getenv("SETAE_TEXT");
    const auto found = readings().find(name ? name : "");
    if (found != readings().end()) return found->second;
    std::fprintf(stderr, "SETAE_TEXT: expected one of");
    for (const auto& [known, reading] : readings()) std::fprintf(stderr, " %s", known.c_str());
    std::fprintf(stderr, "\n");
    std::exit(2);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const auto& reading = chosen();
    try {
        reading(std::string(fuzz::text_of(data, size)));
    } catch (const Error&) {
    }
    return 0;
}
