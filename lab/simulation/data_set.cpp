// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/simulation/data_set.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>

#include <fmt/format.h>

#include "data_files.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/tables/table_file.hpp"
#include "stated_draws.hpp"
#include "stated_records.hpp"
#include "surfaces/surface_patches.hpp"

namespace setae::simulation {
namespace {

namespace fs = std::filesystem;
using numerics::RandomKey;
using numerics::substream;

/// Random streams: one per surface and instrument, one per loop.
enum InstrumentStream : std::uint64_t { of_stylus, of_afm, of_tem };
constexpr std::uint64_t loop_streams = 1ull << 32;

/// The writing of one or more files, independent of all others.
struct Job {
    double cost = 0.0;  ///< expensive ones are started first, so that no thread works at the end without the others
    std::function<void()> run;
};
constexpr double cost_of_strip = 1e9;

/// Tip in the study: its name where it is that of all surfaces, empty without a tip.
template <class Protocol>
std::string tip_text(const Protocol& protocol, const std::optional<StatedQuantity>& shared) {
    if (protocol.tip_radius == 0.0) return "";
    return shared ? mention(*shared) : stated_text({protocol.tip_radius, protocol.tip_radius_standard_error}, "m");
}

/// Entry of a measurement of an instrument, without its file.
MeasurementFile entry_of(const char* instrument, const InstrumentCalibration& factors, std::string tip) {
    const auto text_of = [](const std::optional<StatedQuantity>& factor) { return factor ? mention(*factor) : ""; };
    return {.instrument = instrument,
            .tip_radius = std::move(tip),
            .height_calibration = text_of(factors.height),
            .lateral_calibration = text_of(factors.lateral)};
}

/// Collects the files, then writes them with all threads; the order of the list is that of the calls.
class DataSet {
public:
    DataSet(const Recipe& recipe, std::string folder) : recipe_(recipe), folder_(std::move(folder)) {}

    void add_surface(std::size_t index) {
        const SurfaceRecipe& rough = recipe_.surfaces[index];
        const RandomKey key = substream({.seed = recipe_.seed}, index);
        const std::string stem = file_stem(rough.surface.name);
        create(stem);
        std::vector<MeasurementFile> files;
        const auto C1D = std::make_shared<const LineSpectrum>(rough.surface);
        if (rough.stylus) add_stylus(rough, stem, C1D, substream(key, of_stylus), files);
        if (rough.afm) {
            const auto names = named(stem, "afm", "txt", rough.afm->sizes.size());
            const auto& factors = recipe_.calibrations.afm;
            const auto entry = entry_of("afm", factors, tip_text(*rough.afm, recipe_.afm_tip));
            for (std::size_t k = 0; k < names.size(); ++k) {
                files.emplace_back(entry).file = names[k];
                const auto side = static_cast<double>(rough.afm->pixels_of(k));
                jobs_.push_back({side * side, [this, &rough, &factors, key, k, name = names[k]] {
                                     const auto map = afm_scan(rough.surface, *rough.afm, k, substream(key, of_afm));
                                     write(name, map_text(stated(map, factors)));
                                 }});
            }
        }
        if (rough.tem) {
            const auto names = named(stem, "tem", "csv", rough.tem->lengths.size());
            const auto& factors = recipe_.calibrations.tem;
            auto entry = entry_of("tem", factors, "");
            entry.foil_thickness = rough.tem->foil_thickness;
            for (std::size_t k = 0; k < names.size(); ++k) {
                files.emplace_back(entry).file = names[k];
                jobs_.push_back({0.0, [this, &rough, &factors, C1D, key, k, name = names[k]] {
                                     const auto contour =
                                         tem_contour(rough.surface, *C1D, *rough.tem, k, substream(key, of_tem));
                                     write(name, contour_text(stated(contour, factors)));
                                 }});
            }
        }
        measurements_.push_back(std::move(files));
    }

    void add_true_curve(TrueSurfaceValues truth, std::size_t index) {
        truths_.push_back(std::move(truth));
        const auto& curve = truths_.back().C1D;
        if (curve.wavevector.size() == 0) return;
        const auto name = listed(file_stem(recipe_.surfaces[index].surface.name) + "/truth.csv");
        tables::write_csv(path(name), {{{"wavevector", "1/m", curve.wavevector}, {"C1D", "m3", curve.density}}, {}});
    }

    void add_loops(std::vector<KnownLoop> loops) {
        loops_ = std::move(loops);
        if (!loops_.empty()) create("loops");
        for (std::size_t i = 0; i < loops_.size(); ++i) {
            if (!loops_[i].measured) continue;
            listed(loops_[i].file);
            jobs_.push_back({1.0, [this, i] {
                                 LoopArtefacts artefacts = recipe_.loops->artefacts;
                                 artefacts.key = substream({.seed = recipe_.seed}, loop_streams + i);
                                 const auto& loop = loops_[i];
                                 const auto simulated = simulated_loop(
                                     loop.specimen, recipe_.loops->protocol_on(loop.surface), artefacts, loop.body);
                                 write(loops_[i].file, loop_text(stated(simulated.loop, recipe_.calibrations)));
                             }});
        }
    }

    std::vector<std::string> finish(parallel::Threads threads) {
        std::stable_sort(jobs_.begin(), jobs_.end(), [](const Job& a, const Job& b) { return a.cost > b.cost; });
        parallel::for_each_index(jobs_.size(), threads, [this](std::size_t i) { jobs_[i].run(); });
        write(listed("truth.json"), true_values_text(recipe_, truths_, loops_));
        write(listed("study.toml"), study_text(recipe_, measurements_, loops_));
        return files_;
    }

private:
    void add_stylus(const SurfaceRecipe& rough, const std::string& stem, const std::shared_ptr<const LineSpectrum>& C1D,
                    RandomKey key, std::vector<MeasurementFile>& files) {
        const StylusProtocol& protocol = *rough.stylus;
        const auto names = named(stem, "stylus", "csv", protocol.lengths.size());
        std::vector<std::string> references;
        if (protocol.artefact > 0.0) references = named(stem, "stylus_reference", "csv", protocol.lengths.size());
        const auto& factors = recipe_.calibrations.stylus;
        const auto entry = entry_of("stylus", factors, tip_text(protocol, recipe_.stylus_tip));
        for (std::size_t k = 0; k < names.size(); ++k) {
            auto& listed = files.emplace_back(entry);
            listed.file = names[k];
            if (!references.empty()) listed.references = {references[k]};
        }
        jobs_.push_back({cost_of_strip, [this, &rough, &protocol, &factors, C1D, key, names, references] {
                             const auto scans = stylus_scans(rough.surface, *C1D, protocol, key);
                             for (std::size_t k = 0; k < names.size(); ++k)
                                 write(names[k], scan_text(stated(scans[k], factors)));
                             if (references.empty()) return;
                             const auto flats = stylus_references(protocol, key);
                             for (std::size_t k = 0; k < references.size(); ++k)
                                 write(references[k], scan_text(stated(flats[k], factors)));
                         }});
    }

    [[nodiscard]] std::string path(const std::string& name) const { return (fs::path(folder_) / name).string(); }
    void write(const std::string& name, const std::string& text) const { bytes::write_whole_file(path(name), text); }

    const std::string& listed(std::string name) { return files_.emplace_back(std::move(name)); }

    std::vector<std::string> named(const std::string& stem, const char* instrument, const char* ending,
                                   std::size_t count) {
        std::vector<std::string> names;
        for (std::size_t k = 0; k < count; ++k)
            names.push_back(listed(fmt::format("{}/{}_{}.{}", stem, instrument, k + 1, ending)));
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
    std::vector<TrueSurfaceValues> truths_;
    std::vector<KnownLoop> loops_;
};

}  // namespace

std::vector<std::string> make(const Recipe& recipe, const std::string& folder, parallel::Threads threads) {
    if (recipe.surfaces.empty())
        throw InvalidArgument("a recipe without surfaces has nothing to make; declare [surfaces.NAME]");
    std::vector<TrueSurfaceValues> truths(recipe.surfaces.size());
    parallel::for_each_index(truths.size(), threads,
                             [&](std::size_t i) { truths[i] = true_surface_values(recipe.surfaces[i].surface); });
    DataSet data(recipe, folder);
    data.add_loops(known_loops(recipe, truths));  // first, so that contradictions are found before any file is made
    for (std::size_t i = 0; i < recipe.surfaces.size(); ++i) {
        data.add_surface(i);
        data.add_true_curve(std::move(truths[i]), i);
    }
    return data.finish(threads);
}

}  // namespace setae::simulation
