// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/yaml_text.hpp"

#include <yaml-cpp/eventhandler.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

#include <fmt/format.h>

#include "setae/bytes/nesting.hpp"
#include "setae/core/errors.hpp"

namespace setae::bytes {
namespace {

/// Follows a parser and stops it if a document is too deep or its aliases expand to too much.
class Bounds : public YAML::EventHandler {
public:
    /// Size of a node including its aliases.
    struct Extent {
        std::size_t nodes = 1, bytes = 0, levels = 1;
    };

    Bounds(const Extent& most, const std::string& name) : max_(most), name_(name) {}

    void OnDocumentStart(const YAML::Mark&) override {}
    void OnDocumentEnd() override {}
    void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override { leaf(mark, anchor, 0); }
    void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor, const std::string& text) override {
        leaf(mark, anchor, text.size());
    }
    void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
        const auto known = extents_.find(anchor);
        if (known == extents_.end()) fail(mark, "an alias of a node that contains this alias");
        add(mark, known->second);
    }
    void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                         YAML::EmitterStyle::value) override {
        begin(mark, anchor);
    }
    void OnSequenceEnd() override { end(); }
    void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                    YAML::EmitterStyle::value) override {
        begin(mark, anchor);
    }
    void OnMapEnd() override { end(); }

private:
    struct Open {
        YAML::anchor_t anchor;
        Extent extent;
    };

    [[noreturn]] void fail(const YAML::Mark& mark, const std::string& what) const {
        throw FormatError(name_, {.line = static_cast<std::uint64_t>(std::max(mark.line, 0)) + 1}, "YAML: " + what);
    }
    void add(const YAML::Mark& mark, const Extent& extent) {
        if (open_.size() + extent.levels > max_levels)
            fail(mark, fmt::format("more than {} levels of nesting", max_levels));
        if (open_.empty()) return;
        auto& around = open_.back().extent;
        around.nodes += extent.nodes;
        around.bytes += extent.bytes;
        around.levels = std::max(around.levels, extent.levels + 1);
        if (around.nodes > max_.nodes || around.bytes > max_.bytes) fail(mark, "its aliases repeat too much text");
    }
    void leaf(const YAML::Mark& mark, YAML::anchor_t anchor, std::size_t bytes) {
        add(mark, {.bytes = bytes});
        if (anchor != YAML::NullAnchor) extents_[anchor] = {.bytes = bytes};
    }
    void begin(const YAML::Mark& mark, YAML::anchor_t anchor) {
        if (open_.size() >= max_levels) fail(mark, fmt::format("more than {} levels of nesting", max_levels));
        open_.push_back({anchor, {}});
        mark_ = mark;
    }
    void end() {
        const auto closed = open_.back();
        open_.pop_back();
        if (closed.anchor != YAML::NullAnchor) extents_[closed.anchor] = closed.extent;
        add(mark_, closed.extent);
    }

    Extent max_;
    const std::string& name_;
    std::vector<Open> open_;
    std::map<YAML::anchor_t, Extent> extents_;
    YAML::Mark mark_;
};

}  // namespace

YAML::Node parsed_yaml(const std::string& text, const std::string& name) {
    try {
        std::istringstream stream(text);
        YAML::Parser parser(stream);
        Bounds bounds({.nodes = 16 + 2 * text.size(), .bytes = 1024 + 16 * text.size()}, name);
        parser.HandleNextDocument(bounds);
        return YAML::Load(text);
    } catch (const YAML::Exception& error) {
        const auto line = static_cast<std::uint64_t>(std::max(error.mark.line, 0)) + 1;
        throw FormatError(name, {.line = line}, fmt::format("YAML: {}", error.msg));
    }
}

}  // namespace setae::bytes
