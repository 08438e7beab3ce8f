// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the corpora that fuzzing begins with, FOLDER/<target>/…, from the builders of the tests.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "import_samples.hpp"
#include "setae/bytes/archive.hpp"
#include "setae/bytes/hdf5_handle.hpp"
#include "tests/format_samples.hpp"
#include "tests/micrograph_samples.hpp"
#include "tests/recordings.hpp"

namespace {

using namespace setae::imaging::tests;

std::string target_of(const std::string& name) {
    const auto format = name.substr(0, name.find(' '));
    if (format == "dm3" || format == "dm4") return "dm";
    if (format == "png" || format == "jpeg" || format == "bmp") return "picture";
    return format;
}

std::vector<Sample> films() {
    setae::imaging::FramePixels frame(6, 8);
    for (long i = 0; i < frame.size(); ++i) frame.data()[i] = static_cast<float>(5 * i);
    const auto rows = [&](int bytes) { return bitmap_rows(frame, bytes); };
    return {{"avi 8 bit", avi({rows(1), rows(1)}, 8, 6, 8, std::string(4, '\0'), 20, grey_palette())},
            {"avi 24 bit", avi({rows(3), rows(3)}, 8, 6, 24, std::string(4, '\0'), 20)},
            {"avi Motion JPEG", avi({encoded(frame, ".jpg"), encoded(frame, ".jpg")}, 8, 6, 24, "MJPG", 20)},
            {"avi yuyv", avi({rows(2)}, 8, 6, 16, "YUY2", 20)}};
}

/// Descriptions of EMDs, as fuzz_emd.cpp understands them.
std::vector<Sample> descriptions() {
    const auto told = [](std::initializer_list<unsigned char> numbers, const std::string& text) {
        return std::string(numbers.begin(), numbers.end()) + text;
    };
    return {
        {"emd NCEM", told({0, 0, 1, rows, columns, 129}, "[n_m]\n[n_m]\n")},
        {"emd packed", told({2, 4, 2, 2, rows, columns, 130}, "[u_m]\n[n_m^-1]\n")},
        {"emd spectrum", told({0, 5, 0, 9, 129}, "[eV]\n[eV]\n")},
        {"emd huge", told({4, 1, 1, 30, 255, 129}, "m\nm\n")},
        {"emd Velox",
         told(
             {1, 1, 2, rows, columns, 2, 129},
             "m\nm\n{\"BinaryResult\": {\"PixelSize\": {\"width\": \"1e-10\", \"height\": \"1e-10\"}, \"PixelUnitX\": \"m\", \"PixelUnitY\": \"m\"}}")}};
}

/// Descriptions of HDF5 files of each format, as fuzz_hdf5.cpp understands them: format, structures, type, sides,
/// packing, attributes.
std::vector<Sample> hdf5_descriptions() {
    const auto told = [](std::initializer_list<unsigned char> numbers, const std::string& text) {
        return std::string(numbers.begin(), numbers.end()) + text;
    };
    return {{"hdf5 map", told({0, 0, 9, 2, 6, 4, 0, 0, 0, 0}, "nm\n")},
            {"hdf5 packed", told({0, 1, 2, 2, 6, 4, 14, 3, 0, 0}, "um\n")},
            {"hdf5 line", told({0, 2, 8, 1, 9, 0, 0, 7, 3, 1, 2, 3}, "")},
            {"hdf5 nc", told({1, 25, 9, 2, 6, 4, 14, 2, 2, 9, 3, 2, 17, 3, 0, 0}, "nm\n")},
            {"hdf5 datx",
             told({2, 0, 9, 2, 6, 4, 0, 0}, "a\n") + told({23, 1, 5, 10, 5, 0, 1, 11, 5, 0, 1, 8, 0}, "Fringes\n")},
            {"hdf5 jpk", told({3, 0, 4, 2, 15, 2, 0, 0, 12, 1, 5, 19, 8}, "height\n")},
            {"hdf5 mat", told({4, 0, 9, 2, 6, 4, 14, 2, 17, 0}, "double\n")}};
}

std::string content_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Texts that users write, as fuzz_text.cpp names them.
std::vector<Sample> texts() {
    const std::filesystem::path examples = std::filesystem::path(SETAE_SOURCE_DIR) / "examples";
    std::vector<Sample> list{
        {"study", content_of(examples / "nanodiamond/published.toml")},
        {"study",
         "title = \"a\"\n[analysis]\nshortest_wavelength = \"4 A\"\nspectrum = \"average\"\n[rough_solid]\nyoungs_modulus = "
         "\"1.1 TPa\"\npoisson_ratio = 0.06\n[surfaces.A]\nmeasurements = [{ file = \"a.csv\", tip_radius = \"5 ± 1 um\", "
         "size = [\"1 um\"], direction = \"30 deg\" }]\n[elastomers.E]\nsurface_energy = \"25 mJ/m2\"\n[[experiments]]\nfile = "
         "\"l.csv\"\nsurface = \"A\"\nelastomer = \"E\"\nsegments = [\"loading=120:900\"]\nmodels = [\"jkr\"]\n"},
        {"recipe", content_of(examples / "laboratory/recipe.toml")},
        {"mapping", content_of(examples / "mappings/eoh.toml")},
        {"pipeline_toml", "[[steps]]\nstep = \"level_plane\"\n[[steps]]\nstep = \"crop\"\nregion = \"0 um x 1 um\"\n"},
        {"pipeline_yaml", "steps:\n  - level_plane\n  - step: despike\n    threshold: 5\n    on: false\n"},
        {"calibration", "{\"format\": \"setae calibration\", \"version\": 1, \"pixel_size\": [1e-10, 1e-10]}"},
        {"trace", "{\"anchors\": [[1, 2], [3.5, 4]], \"format\": \"setae contour\", \"version\": 1}"},
        {"loop",
         "# format: setae loop\n# sphere_radius: 1.25 mm\ntime [s],force [uN],displacement [nm]\n0,1,2\n1,2,3\n2,\"3\",4\n"},
        {"loop", "Zeit;Kraft\n0,5;1,25\n1,5;2,25\n2,5;3,5\n"},
        {"contact_point", "force_departure"},
        {"contact_point", "12 nm"},
        {"json", "{\"a\": [1, 2.5e-3, null, \"\\u00e4\"], \"b\": {}}"},
        {"yaml", "base: &b {x: 1}\nlist: [*b, \"t\", 1.5]\n"},
        {"entry", std::string(64, '\0')},
        {"shown", "a\x1b[31m\xc3\xa4\xff\n"}};
    for (const auto* unit : {"mJ/m2", "m^-1", "N m^-1 um2/kg", "µm³", "1/(s m)", "°C"}) list.emplace_back("unit", unit);
    for (const auto* quantity : {"37.0 ± 3.7 nm", "1e-9 m", "8 A", "5 um +- 1 nm", "-1 mm", "nan m"})
        list.emplace_back("quantity", quantity);
    return list;
}

/// Members of an archive in the layout of fuzz_force_curve.cpp.
std::string told_members(const std::string& content) {
    const auto archive = setae::bytes::Archive(setae::bytes::memory_source("corpus", content));
    std::string told;
    for (const auto& name : archive.names()) told += '\x1e' + name + '\x1f' + archive.read(name);
    return told;
}

std::vector<Sample> force_curves() {
    using namespace setae::tests;
    const std::vector<JpkMapCurve> two{{.number = 3, .x = 0.0, .y = -1e-6}, {.number = 12, .x = 2e-6, .y = -0.6e-6}};
    std::vector<Sample> list{{"nanosurf metres", nanosurf_force_file()},
                             {"nanosurf volts", nanosurf_force_file("V")},
                             {"igor little", igor_force_file("SpringConstant: 0.1\rInvOLS: 5e-8\r")},
                             {"igor big", igor_force_file("SpringConstant: 0.1\r", true)},
                             {"afm workshop", afm_workshop_file()},
                             {"nanoscope ramp", nanoscope_force_file()},
                             {"nanoscope volume", nanoscope_force_file(6, true, 4)},
                             {"jpk text", jpk_text_file(2)},
                             {"nt-mdt", nt_mdt_file()}};
    for (const auto& archive : {jpk_force_file(), jpk_force_file(true), jpk_force_file_of_2015(), jpk_map_file(two),
                                jpk_map_file(two, jpk_map_header(2, 1, 0.0, true))}) {
        list.emplace_back("archive " + std::to_string(list.size()), archive);
        list.emplace_back("members " + std::to_string(list.size()), told_members(archive));
    }
    return list;
}

void write(const std::filesystem::path& folder, std::string name, const std::string& content) {
    std::filesystem::create_directories(folder);
    for (auto& c : name)
        if (c == ' ' || c == '/') c = '_';
    std::ofstream(folder / name, std::ios::binary) << content;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: make_corpus FOLDER\n", stderr);
        return 2;
    }
    auto samples = micrograph_samples();
    const std::filesystem::path corpus = argv[1];
    std::erase_if(samples, [&](const Sample& sample) {
        if (target_of(sample.first) != "emd") return false;
        write(corpus / "hdf5_bytes", sample.first, sample.second);
        return true;
    });
    for (const auto& description : descriptions()) samples.push_back(description);
    for (const auto& large : micrographs_of(30000)) samples.emplace_back(large.first + " large", large.second);
    for (const auto& description : hdf5_descriptions()) samples.push_back(description);
    for (const auto& film : films()) samples.push_back(film);
    for (const auto& [name, content] : samples) write(corpus / target_of(name), name, content);
    for (const auto& sample : setae::formats::tests::format_samples()) {
        if (setae::bytes::find_hdf5(sample.content)) {
            write(corpus / "hdf5_bytes", sample.format + " " + sample.name, sample.content);
            continue;
        }
        write(corpus / ("topography_" + sample.format), sample.name, sample.content);
        write(corpus / "topography_any", sample.format + " " + sample.name, sample.content);
    }
    for (const auto& [name, content] : force_curves()) write(corpus / "force_curve", name, content);
    int number = 0;
    for (const auto& [kind, text] : texts()) write(corpus / ("text_" + kind), std::to_string(++number), text);
    return 0;
}
