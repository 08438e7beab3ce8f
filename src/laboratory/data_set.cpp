// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/laboratory/data_set.hpp"

#include <filesystem>
#include <functional>

#include <fmt/format.h>

#include "data_files.hpp"
#include "setae/core/errors.hpp"
#include "setae/io/table_file.hpp"
#include "setae/io/whole_file.hpp"
#include "surface_patches.hpp"

namespace setae::laboratory {
namespace {

namespace fs = std::filesystem;
using synthesis::RandomKey;
using synthesis::substream;

/// Streams below the seed: one a surface and instrument, one a loop.
enum Stream : std::uint64_t { of_stylus, of_afm, of_tem };
constexpr std::uint64_t loop_streams = 1ull << 32;

/// The writing of one or more files, independent of all others.
using Job = std::function<void()>;

std::string tip_text(double radius, double standard_error) {
    return standard_error > 0.0 ? fmt::format("{} ± {} m", radius, standard_error) : fmt::format("{} m", radius);
}

/// Collects what is to be written, then writes it with all threads; the order of the list is that of the calls.
class DataSet {
public:
    DataSet(const Recipe& recipe, std::string folder) : recipe_(recipe), folder_(std::move(folder)) {}

    void add_surface(std::size_t index) {
        const SurfaceRecipe& rough = recipe_.surfaces[index];
        const RandomKey key = substream({.seed = recipe_.seed}, index);
        const std::string stem = file_stem(rough.surface.name);
        create(stem);
        std::vector<MeasurementFile> files;
        if (rough.stylus) {
            const auto names = named(stem, "stylus", "csv", rough.stylus->lengths.size());
            for (const auto& name : names)
                files.push_back({name, "stylus", tip_text(rough.stylus->tip_radius, rough.stylus->tip_radius_standard_error)});
            jobs_.push_back([this, &rough, key, names] {
                const auto scans = stylus_scans(rough.surface, *rough.stylus, substream(key, of_stylus));
                for (std::size_t k = 0; k < names.size(); ++k) write(names[k], scan_text(scans[k]));
            });
        }
        if (rough.afm) {
            const auto names = named(stem, "afm", "txt", rough.afm->sizes.size());
            for (std::size_t k = 0; k < names.size(); ++k) {
                files.push_back({names[k], "afm", tip_text(rough.afm->tip_radius, rough.afm->tip_radius_standard_error)});
                jobs_.push_back([this, &rough, key, k, name = names[k]] {
                    write(name, map_text(afm_scan(rough.surface, *rough.afm, k, substream(key, of_afm))));
                });
            }
        }
        if (rough.tem) {
            const auto names = named(stem, "tem", "csv", rough.tem->lengths.size());
            for (std::size_t k = 0; k < names.size(); ++k) {
                files.push_back({names[k], "tem", ""});
                jobs_.push_back([this, &rough, key, k, name = names[k]] {
                    write(name, contour_text(tem_contour(rough.surface, *rough.tem, k, substream(key, of_tem))));
                });
            }
        }
        measurements_.push_back(std::move(files));
    }

    void add_truth(std::size_t index) {
        truths_.push_back(surface_truth(recipe_.surfaces[index].surface));
        const auto& curve = truths_.back().C1D;
        if (curve.wavevector.size() == 0) return;
        const auto name = listed(file_stem(recipe_.surfaces[index].surface.name) + "/truth.csv");
        io::write_csv(path(name), {{{"wavevector", "1/m", curve.wavevector}, {"C1D", "m3", curve.values}}, {}});
    }

    void add_loops() {
        loops_ = planted_loops(recipe_);
        if (!loops_.empty()) create("loops");
        for (std::size_t i = 0; i < loops_.size(); ++i) {
            listed(loops_[i].file);
            jobs_.push_back([this, i] {
                LoopArtefacts artefacts = recipe_.loops->artefacts;
                artefacts.key = substream({.seed = recipe_.seed}, loop_streams + i);
                write(loops_[i].file, loop_text(simulated_loop(loops_[i].specimen, recipe_.loops->protocol, artefacts).loop));
            });
        }
    }

    std::vector<std::string> finish(parallel::Threads threads) {
        parallel::for_each_index(jobs_.size(), threads, [this](std::size_t i) { jobs_[i](); });
        write(listed("truth.json"), truth_text(recipe_, truths_, loops_));
        write(listed("study.toml"), study_text(recipe_, measurements_, loops_));
        return files_;
    }

private:
    [[nodiscard]] std::string path(const std::string& name) const { return (fs::path(folder_) / name).string(); }
    void write(const std::string& name, const std::string& text) const { io::write_whole_file(path(name), text); }

    const std::string& listed(std::string name) { return files_.emplace_back(std::move(name)); }

    std::vector<std::string> named(const std::string& stem, const char* instrument, const char* ending, std::size_t count) {
        std::vector<std::string> names;
        for (std::size_t k = 0; k < count; ++k) names.push_back(listed(fmt::format("{}/{}_{}.{}", stem, instrument, k + 1, ending)));
        return names;
    }

    void create(const std::string& name) const {
        std::error_code error;
        fs::create_directories(path(name), error);
        if (error) throw FileError(fmt::format("{}: cannot make the folder: {}", path(name), error.message()));
    }

    const Recipe& recipe_;
    std::string folder_;
    std::vector<std::string> files_;
    std::vector<Job> jobs_;
    std::vector<std::vector<MeasurementFile>> measurements_;
    std::vector<SurfaceTruth> truths_;
    std::vector<PlantedLoop> loops_;
};

}  // namespace

std::vector<std::string> make(const Recipe& recipe, const std::string& folder, parallel::Threads threads) {
    if (recipe.surfaces.empty()) throw InvalidArgument("a recipe without surfaces has nothing to make; declare [surfaces.NAME]");
    DataSet data(recipe, folder);
    data.add_loops();  // first: what contradicts itself is found before anything is made
    for (std::size_t i = 0; i < recipe.surfaces.size(); ++i) {
        data.add_surface(i);
        data.add_truth(i);
    }
    return data.finish(threads);
}

}  // namespace setae::laboratory
