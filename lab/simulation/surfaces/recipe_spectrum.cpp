// SPDX-License-Identifier: GPL-3.0-or-later
#include "recipe_spectrum.hpp"

#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/spectra/model_spectra.hpp"
#include "setae/tables/table_file.hpp"
#include "spectral_moment.hpp"

namespace setae::simulation {
namespace {

using bytes::TomlReader;

/// The numbers of one spectrum: drawn where a range is given, and written down.
class SpectrumNumbers {
public:
    SpectrumNumbers(TomlReader& reader, const RangeDraws& draws, std::vector<SpectrumParameter>& taken)
        : reader_(&reader), draws_(&draws), taken_(&taken) {}

    [[nodiscard]] std::optional<double> optional(const char* key, const Dimension& dimension) {
        const auto value = draws_->quantity(*reader_, key, dimension);
        if (value) taken_->push_back({key, *value, reader_->is_list(key)});
        return value;
    }
    [[nodiscard]] double required(const char* key, const Dimension& dimension) {
        if (const auto value = optional(key, dimension)) return *value;
        return reader_->required_uncertain(key, dimension).value;  // reports the missing key
    }
    [[nodiscard]] double number_or(const char* key, double fallback) {
        return optional(key, dimension::none).value_or(fallback);
    }
    [[nodiscard]] double wavevector(const char* key) { return 2.0 * pi / required(key, dimension::length); }

    [[nodiscard]] TomlReader& reader() { return *reader_; }

private:
    TomlReader* reader_;
    const RangeDraws* draws_;
    std::vector<SpectrumParameter>* taken_;
};

/// The density with the given amplitude; density_of_plateau: by C_0.
template <class Function>
spectra::SpectralDensity with_amplitude(SpectrumNumbers& numbers, const Band& band,
                                        const Function& density_of_plateau) {
    const auto height = numbers.optional("rms_height", dimension::length);
    const auto slope = numbers.optional("rms_slope", dimension::none);
    const auto plateau = numbers.optional("plateau", dimension::power_spectrum_2d);
    if (static_cast<int>(height.has_value()) + static_cast<int>(slope.has_value()) +
            static_cast<int>(plateau.has_value()) !=
        1)
        numbers.reader().fail("rms_height", "expected exactly one of rms_height, rms_slope, plateau");
    if (plateau) return density_of_plateau(*plateau);
    const double order = height ? 0.0 : 2.0, wanted = height ? *height : *slope;
    const double unit = spectral_moment(density_of_plateau(1.0), order, band.lower, {0.0, band.upper}) / (2.0 * pi);
    return density_of_plateau(wanted * wanted / unit);
}

/// C_iso ends where it has decreased to exp(−16) of the power law: 1e-7.
constexpr double end_of_soft_cutoff = 4.0;

spectra::SpectralDensity soft_cutoff(const spectra::SoftCutoff& model) {
    return [inner = spectra::density(model), end = end_of_soft_cutoff * model.short_wavevector](double q) {
        return q > end ? 0.0 : inner(q);
    };
}

void read_model(SpectrumNumbers& numbers, const std::string& model, KnownSurface& surface) {
    surface.rolloff_wavelength = numbers.required("rolloff_wavelength", dimension::length);
    surface.short_wavelength = numbers.required("short_wavelength", dimension::length);
    const double hurst = numbers.required("hurst_exponent", dimension::none);
    const Band band = surface.band();
    const auto affine = [=](double plateau) { return spectra::SelfAffine{plateau, band.lower, hurst, band.upper}; };
    if (model == "self_affine") {
        surface.C_iso =
            with_amplitude(numbers, band, [&](double plateau) { return spectra::density(affine(plateau)); });
    } else if (model == "soft_cutoff") {
        surface.short_wavelength /= end_of_soft_cutoff;
        surface.C_iso = with_amplitude(numbers, surface.band(), [&](double plateau) {
            return soft_cutoff({plateau, band.lower, hurst, band.upper});
        });
    } else if (model == "two_slopes") {
        const double crossover = numbers.wavevector("crossover_wavelength");
        const double short_hurst = numbers.number_or("short_hurst_exponent", hurst);
        surface.C_iso = with_amplitude(numbers, band, [&](double plateau) {
            return spectra::density(spectra::TwoSlopes{plateau, band.lower, hurst, crossover, short_hurst, band.upper});
        });
    } else {
        const double wavevector = numbers.wavevector("bump_wavelength"),
                     excess = numbers.required("bump_excess", dimension::none);
        const double width = numbers.number_or("bump_width", spectra::Bump{}.width);
        surface.C_iso = with_amplitude(numbers, band, [&](double plateau) {
            return spectra::density(spectra::Bump{affine(plateau), excess, wavevector, width});
        });
    }
}

spectra::SpectralDensity table_density(const std::string& path, KnownSurface& surface) {
    const Table table = tables::read_table(path);
    if (table.columns.size() != 2)
        throw FormatError(
            path, {}, fmt::format("{} columns, expected the wavevector [1/m] and C_iso [m4]", table.columns.size()));
    const Array1D &q = table.columns[0].values, &C_iso = table.columns[1].values;
    const auto density = spectra::tabulated_density(q, C_iso);
    surface.rolloff_wavelength = 2.0 * pi / q[0];
    surface.short_wavelength = 2.0 * pi / q[q.size() - 1];
    return density;
}

void read_spectrum_table(TomlReader reader, const std::string& folder, const RangeDraws& draws, SurfaceRecipe& recipe) {
    const auto model = reader.required_text("model");
    KnownSurface& surface = recipe.surface;
    try {
        if (model == "table") {
            surface.C_iso =
                table_density((std::filesystem::path(folder) / reader.required_text("file")).string(), surface);
        } else if (model == "self_affine" || model == "soft_cutoff" || model == "two_slopes" || model == "bump") {
            SpectrumNumbers numbers(reader, draws, recipe.parameters);
            read_model(numbers, model, surface);
        } else {
            reader.fail("model",
                        fmt::format("'{}', expected one of self_affine, soft_cutoff, two_slopes, bump, table", model));
        }
    } catch (const InvalidArgument& error) {
        reader.fail("model", error.what());
    }
    reader.finish();
}

void read_anisotropy(TomlReader reader, const RangeDraws& draws, SurfaceRecipe& recipe) {
    SpectrumNumbers numbers(reader, draws, recipe.parameters);
    auto& anisotropy = recipe.surface.anisotropy;
    anisotropy.stretch = numbers.required("stretch", dimension::none);
    if (!(anisotropy.stretch >= 1.0) || !(anisotropy.stretch <= 100.0))
        reader.fail("stretch",
                    fmt::format("{}; expected 1 to 100, along the direction `angle` in which features are long",
                                anisotropy.stretch));
    anisotropy.angle = numbers.number_or("angle", 0.0);
    reader.finish();
}

}  // namespace

void read_spectrum(TomlReader& reader, const std::string& folder, const RangeDraws& draws, SurfaceRecipe& recipe) {
    if (!reader.is_table("spectrum")) reader.fail("spectrum", "missing");
    reader.table("spectrum", [&](TomlReader inner) { read_spectrum_table(std::move(inner), folder, draws, recipe); });
    reader.table("anisotropy", [&](TomlReader inner) { read_anisotropy(std::move(inner), draws, recipe); });
    SpectrumNumbers own(reader, draws, recipe.parameters);
    recipe.surface.skewness = own.number_or("skewness", 0.0);
    if (!recipe.surface.gaussian() && !recipe.surface.isotropic())
        reader.fail("skewness", "of an anisotropic surface; expected Gaussian heights there");
}

}  // namespace setae::simulation
