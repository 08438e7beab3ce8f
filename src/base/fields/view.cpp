// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/fields/view.hpp"

#include <utility>

namespace setae::fields {
namespace {

/// Selects the fields of the columns.
class Picked final : public Sink {
public:
    explicit Picked(std::span<const Column> view) : view_(view) {
        for (const auto& column : view) cells_.push_back(holds_words(column) ? Cell{std::string()} : Cell{undefined});
    }
    [[nodiscard]] std::vector<Cell> cells() && { return std::move(cells_); }

    void flag(const Row& row, bool value) override { take(row, std::string(value ? "yes" : "no")); }
    void whole(const Row& row, long long value) override { take(row, static_cast<double>(value)); }
    void whole(const Row& row, std::uint64_t value) override { take(row, static_cast<double>(value)); }
    void number(const Row& row, double value) override { take(row, value); }
    void value(const Row& row, double value) override { take(row, value); }
    void quantity(const Row& row, const Estimate& value) override { take(row, value.value, value.standard_error); }
    void quantity(const Row& row, const Quantity& value) override { quantity(row, value.estimate); }
    void fields_of(const Quantity&) override {}
    void text(const Row& row, std::string_view value) override { take(row, std::string(value)); }
    void begin_list(const Row& row) override { begin(row); }
    void end_list(const Row& row) override { end(row); }
    void begin(const Row& row) override { path_.push_back(row.name); }
    void end(const Row&) override { path_.pop_back(); }
    void key(std::string_view) override {}
    void missing(const Row&, std::string_view) override {}

private:
    [[nodiscard]] bool is_at(std::string_view path, std::string_view name) const {
        for (const auto part : path_) {
            if (!path.starts_with(part) || path.size() <= part.size() || path[part.size()] != '.') return false;
            path.remove_prefix(part.size() + 1);
        }
        return path == name;
    }
    void take(const Row& row, std::variant<std::string, double> value, double standard_error = undefined) {
        for (std::size_t i = 0; i < view_.size(); ++i) {
            if (view_[i].row != &row || !is_at(view_[i].path, row.name)) continue;
            const double unit = view_[i].unit;
            if (auto* number = std::get_if<double>(&value)) cells_[i] = {*number / unit, standard_error / unit};
            else cells_[i] = {value};
        }
    }

    std::span<const Column> view_;
    std::vector<Cell> cells_;
    std::vector<std::string_view> path_;  ///< names of the open objects
};

}  // namespace

std::vector<Cell> cells(const void* result, const Description& description, std::span<const Column> view) {
    Picked sink(view);
    put(result, description, sink);
    return std::move(sink).cells();
}

bool holds_words(const Column& column) {
    const auto kind = column.row->kind;
    return kind == Kind::text || kind == Kind::choice || kind == Kind::flag;
}

bool has_error(const Column& column) {
    return column.row->kind == Kind::quantity && column.row->has_error && column.errors == Errors::beside;
}

}  // namespace setae::fields
