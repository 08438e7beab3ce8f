// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "setae/formats/format.hpp"
#include "setae/processing/step_text.hpp"
#include "setae/study/pipeline_file.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace {

namespace fs = std::filesystem;
using namespace setae;

std::string content(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// A tilted map with jumps, spikes and a hole, as a file.
void write_measurement(const std::string& path) {
    auto map = synthesis::random_surface(spectra::density({1e-30, 1.3e7, 0.8, 1e9}), {200, 150, 2e-6, 1.5e-6});
    map.periodic = false;
    for (Index i = 0; i < 200; ++i)
        for (Index j = 0; j < 150; ++j)
            map.heights(i, j) += 1e-10 * static_cast<double>(i) + 1e-8 * static_cast<double>((j * 7919) % 13) +
                                 ((i * j) % 4999 == 17 ? 1e-6 : 0.0);
    map.heights.block(50, 60, 5, 4).setConstant(NAN);
    formats::format_to_write(path).write(path, map);
}

TEST(Pipeline, OnTheCommandLineGivesTheBytesOfTheLibrary) {
    const auto folder = fs::temp_directory_path() / "setae_front_ends_pipeline";
    fs::remove_all(folder);
    fs::create_directories(folder);
    const auto in = (folder / "in.nc").string(), file = (folder / "p.yml").string(),
               ours = (folder / "library.npy").string();
    write_measurement(in);
    processing::Pipeline pipeline;
    for (const char* step : {"align_rows method=median_of_differences", "despike threshold=7", "remove_scars",
                             "level_polynomial degree=4 region=\"exclude percentiles above 95\"", "level_facet",
                             "crop cut_left=3", "transpose"})
        pipeline.entries.push_back({processing::step_from_text(step)});
    study::write_pipeline(file, pipeline);
    formats::format_to_write(ours).write(
        ours, processing::apply(study::read_pipeline(file), study::measurement_loader()(in, ""), {}, {2}).measurement);

    std::string steps;
    for (const auto& line : study::step_lines(pipeline)) steps += " --step '" + line + "'";
    for (const std::string& given : {" --pipeline '" + file + "'", steps}) {
        const auto theirs = (folder / "program.npy").string();
        const auto command =
            std::string("'") + SETAE_PROGRAM + "' level '" + in + "'" + given + " -o '" + theirs + "' > /dev/null";
        ASSERT_EQ(std::system(command.c_str()), 0) << command;
        EXPECT_EQ(content(theirs), content(ours)) << given;
    }
    EXPECT_GT(content(ours).size(), 8u * 190u * 140u);
    fs::remove_all(folder);
}

}  // namespace
