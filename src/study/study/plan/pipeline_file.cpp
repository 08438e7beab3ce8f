// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/pipeline_file.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <vector>

#include <fmt/format.h>
#include <toml++/toml.h>
#include <yaml-cpp/yaml.h>

#include "setae/bytes/source.hpp"
#include "setae/bytes/toml_reader.hpp"
#include "setae/bytes/toml_text.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/bytes/yaml_text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/processing/step_text.hpp"

namespace setae::study {
namespace {

namespace fs = std::filesystem;
using processing::Entry;
using processing::Pipeline;

constexpr const char* list_key = "steps";
constexpr const char* name_key = "step";
constexpr const char* switch_key = "enabled";
constexpr const char* file_parameter = "file";  // its value is a path
constexpr std::size_t longest_file = 1 << 20;

/// A key or a text of a file with its line.
struct Item {
    std::string key, value;
    std::uint64_t line = 0;
};

/// A file as items: the common part of YAML and TOML.
class Builder {
public:
    explicit Builder(std::string path) : path_(std::move(path)) {}

    [[noreturn]] void fail(std::uint64_t line, const std::string& what) const {
        throw FormatError(path_, {.line = line}, what);
    }

    /// A key next to the list of steps.
    [[noreturn]] void refuse_key(const Item& item) const {
        const std::vector<std::string> known{list_key};
        const auto nearest = nearest_match(item.key, known);
        fail(item.line, fmt::format("unknown key '{}'{}", item.key,
                                    nearest.empty() ? fmt::format("; expected {}", list_key)
                                                    : fmt::format("; did you mean '{}'?", nearest)));
    }

    /// "despike threshold=5".
    void add_line(const Item& item) {
        guarded(item.line, [&] { pipeline_.entries.push_back({processing::step_from_text(item.value)}); });
        resolve_file(pipeline_.entries.back().step);
    }

    /// The keys of one step, whose table begins on `line`.
    void add_step(const std::vector<Item>& items, std::uint64_t line) {
        const auto named =
            std::find_if(items.begin(), items.end(), [](const Item& item) { return item.key == name_key; });
        if (named == items.end())
            fail(line, fmt::format("a step without a name; expected a key '{}', such as {}: level_plane", name_key,
                                   name_key));
        Entry entry;
        guarded(named->line, [&] { entry.step = processing::step_named(named->value); });
        std::set<std::string> seen;
        for (const auto& item : items) {
            if (!seen.insert(item.key).second)
                fail(item.line, fmt::format("key '{}' is given twice in a step", item.key));
            if (item.key == name_key) continue;
            if (item.key == switch_key) entry.on = flag(item);
            else guarded(item.line, [&] { processing::set_parameter(entry.step, {item.key, item.value}); });
        }
        resolve_file(entry.step);
        pipeline_.entries.push_back(std::move(entry));
    }

    [[nodiscard]] Pipeline take() { return std::move(pipeline_); }

private:
    template <class Body>
    void guarded(std::uint64_t line, const Body& body) const {
        try {
            body();
        } catch (const InvalidArgument& error) {
            fail(line, error.what());
        }
    }

    [[nodiscard]] bool flag(const Item& item) const {
        if (item.value != "true" && item.value != "false")
            fail(item.line, fmt::format("{}: '{}'; expected true or false", item.key, item.value));
        return item.value == "true";
    }

    /// Paths in a pipeline are relative to its file.
    void resolve_file(processing::Step& step) const {
        for (const auto& parameter : processing::changed_parameters(step))
            if (parameter.name == file_parameter && !fs::path(parameter.value).is_absolute())
                processing::set_parameter(
                    step,
                    {file_parameter, (fs::path(path_).parent_path() / parameter.value).lexically_normal().string()});
    }

    std::string path_;
    Pipeline pipeline_;
};

std::uint64_t line_of(const YAML::Node& node) { return static_cast<std::uint64_t>(node.Mark().line + 1); }

/// The text of a value; a list of texts, as regions have them, joined.
std::string value_of(const YAML::Node& node, const std::string& key, const Builder& builder) {
    if (node.IsScalar()) return node.Scalar();
    if (!node.IsSequence()) builder.fail(line_of(node), fmt::format("{}: expected a value, or a list of texts", key));
    std::string all;
    for (const auto& element : node) {
        if (!element.IsScalar()) builder.fail(line_of(element), fmt::format("{}: expected a list of texts", key));
        all += (all.empty() ? "" : "; ") + element.Scalar();
    }
    return all;
}

Pipeline from_yaml(const std::string& text, const std::string& path) {
    Builder builder(path);
    const auto root = bytes::parsed_yaml(text, path);
    if (!root.IsMap()) builder.fail(1, fmt::format("expected a key '{}' with a list of steps", list_key));
    for (const auto& entry : root) {
        if (!entry.first.IsScalar()) builder.fail(line_of(entry.first), "a key is not a text");
        if (entry.first.Scalar() != list_key) builder.refuse_key({entry.first.Scalar(), "", line_of(entry.first)});
        if (entry.second.IsNull()) continue;
        if (!entry.second.IsSequence())
            builder.fail(line_of(entry.second),
                         fmt::format("{}: expected a list, with a dash before each step", list_key));
        for (const auto& step : entry.second) {
            if (step.IsScalar()) {
                builder.add_line({"", step.Scalar(), line_of(step)});
                continue;
            }
            if (!step.IsMap())
                builder.fail(line_of(step),
                             fmt::format("expected a step: a key '{}' and its parameters, or one text", name_key));
            std::vector<Item> items;
            for (const auto& pair : step) {
                if (!pair.first.IsScalar()) builder.fail(line_of(pair.first), "a key is not a text");
                items.push_back(
                    {pair.first.Scalar(), value_of(pair.second, pair.first.Scalar(), builder), line_of(pair.first)});
            }
            builder.add_step(items, line_of(step));
        }
    }
    return builder.take();
}

std::uint64_t line_of(const toml::node& node) { return node.source().begin.line; }

std::string value_of(const toml::node& node, const std::string& key, const Builder& builder) {
    if (const auto* text = node.as_string()) return text->get();
    if (const auto* whole = node.as_integer()) return std::to_string(whole->get());
    if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
    if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
    const auto* list = node.as_array();
    if (!list) builder.fail(line_of(node), fmt::format("{}: expected a value, or a list of texts", key));
    std::string all;
    for (const auto& element : *list) {
        const auto* text = element.as_string();
        if (!text) builder.fail(line_of(element), fmt::format("{}: expected a list of texts", key));
        all += (all.empty() ? "" : "; ") + text->get();
    }
    return all;
}

Pipeline from_toml(const std::string& path) {
    Builder builder(path);
    const auto root = bytes::parse_toml_file(path);
    for (const auto& [key, node] : root) {
        if (key.str() != list_key) builder.refuse_key({std::string(key.str()), "", key.source().begin.line});
        const auto* list = node.as_array();
        if (!list) builder.fail(line_of(node), fmt::format("{}: expected tables [[{}]] or a list", list_key, list_key));
        for (const auto& step : *list) {
            if (const auto* text = step.as_string()) {
                builder.add_line({"", text->get(), line_of(step)});
                continue;
            }
            const auto* table = step.as_table();
            if (!table)
                builder.fail(line_of(step),
                             fmt::format("expected a step: a key '{}' and its parameters, or one text", name_key));
            std::vector<Item> items;
            for (const auto& [name, value] : *table)
                items.push_back({std::string(name.str()), value_of(value, std::string(name.str()), builder),
                                 name.source().begin.line});
            builder.add_step(items, line_of(step));
        }
    }
    return builder.take();
}

/// Whether a text is a number or a switch, which are written without quotes.
bool plain(const std::string& value) {
    if (value == "true" || value == "false") return true;
    return !value.empty() && value.find_first_not_of("0123456789.-") == std::string::npos;
}

std::string written(const std::string& value) { return plain(value) ? value : bytes::toml_quoted(value); }

enum class Ending { yaml, toml };

Ending ending_of(const std::string& path) {
    const auto ending = fs::path(path).extension().string();
    if (ending == ".yml" || ending == ".yaml") return Ending::yaml;
    if (ending == ".toml") return Ending::toml;
    throw InvalidArgument(
        fmt::format("{}: the name gives no format of a pipeline; expected an ending .yml, .yaml or .toml", path));
}

}  // namespace

Pipeline read_pipeline(const std::string& path) {
    const auto source = bytes::file_source(path);
    if (source.size > longest_file)
        throw FormatError(
            path, {},
            fmt::format("{} bytes are too many for a pipeline; expected at most {}", source.size, longest_file));
    return ending_of(path) == Ending::yaml ? from_yaml(source.all(), path) : from_toml(path);
}

std::string pipeline_yaml(const Pipeline& pipeline) {
    std::string text = pipeline.entries.empty() ? "steps: []\n" : "steps:\n";
    for (const auto& entry : pipeline.entries) {
        text += fmt::format("  - {}: {}\n", name_key, processing::name(entry.step));
        for (const auto& parameter : processing::changed_parameters(entry.step))
            text += fmt::format("    {}: {}\n", parameter.name, written(parameter.value));
        if (!entry.on) text += fmt::format("    {}: false\n", switch_key);
    }
    return text;
}

std::string pipeline_toml(const Pipeline& pipeline) {
    std::string text = pipeline.entries.empty() ? "steps = []\n" : "";
    for (const auto& entry : pipeline.entries) {
        text += fmt::format("{}[[{}]]\n{} = {}\n", text.empty() ? "" : "\n", list_key, name_key,
                            bytes::toml_quoted(processing::name(entry.step)));
        for (const auto& parameter : processing::changed_parameters(entry.step))
            text += fmt::format("{} = {}\n", parameter.name, written(parameter.value));
        if (!entry.on) text += fmt::format("{} = false\n", switch_key);
    }
    return text;
}

void write_pipeline(const std::string& path, const Pipeline& pipeline) {
    const auto ending = ending_of(path);
    auto beside = pipeline;
    for (auto& entry : beside.entries)
        for (const auto& parameter : processing::changed_parameters(entry.step))
            if (parameter.name == file_parameter && !fs::path(parameter.value).is_absolute())
                processing::set_parameter(
                    entry.step, {file_parameter,
                                 fs::path(parameter.value).lexically_proximate(fs::path(path).parent_path()).string()});
    bytes::write_whole_file(path, ending == Ending::yaml ? pipeline_yaml(beside) : pipeline_toml(beside));
}

processing::LoadMeasurement measurement_loader(formats::ReadOptions options) {
    return
        [options = std::move(options)](const std::string& file, const std::string& channel) -> topography::Measurement {
            return formats::read(file, channel.empty() ? formats::ChannelChoice{} : channel, options);
        };
}

std::vector<std::string> step_lines(const Pipeline& pipeline) {
    std::vector<std::string> lines;
    for (const auto& entry : pipeline.entries)
        if (entry.on) lines.push_back(processing::text(entry.step));
    return lines;
}

Pipeline pipeline_of_lines(const std::vector<std::string>& lines) {
    Pipeline pipeline;
    for (const auto& line : lines) pipeline.entries.push_back({processing::step_from_text(line)});
    return pipeline;
}

std::vector<std::string> files_of_steps(const std::vector<std::string>& lines) {
    std::vector<std::string> files;
    for (const auto& entry : pipeline_of_lines(lines).entries)
        for (const auto& parameter : processing::changed_parameters(entry.step))
            if (parameter.name == file_parameter) files.push_back(parameter.value);
    return files;
}

}  // namespace setae::study
