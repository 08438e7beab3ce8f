// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/io/netcdf.hpp"

#include <netcdf.h>
#include <netcdf_mem.h>

#include <cstdlib>
#include <memory>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/io/whole_file.hpp"

namespace setae::io {
namespace {

/// A NetCDF dataset being written in memory.
class Dataset {
public:
    explicit Dataset(std::string path) : path_(std::move(path)) { check(nc_create_mem(path_.c_str(), NC_64BIT_OFFSET, 0, &id_)); }
    Dataset(const Dataset&) = delete;
    Dataset& operator=(const Dataset&) = delete;
    ~Dataset() {
        if (id_ >= 0) nc_abort(id_);
    }

    [[nodiscard]] int id() const { return id_; }

    void check(int status) const {
        if (status != NC_NOERR) throw InvalidArgument(fmt::format("{}: NetCDF: {}", path_, nc_strerror(status)));
    }

    void put_text(int variable, const char* name, const std::string& text) const {
        check(nc_put_att_text(id_, variable, name, text.size(), text.data()));
    }

    /// Closes and gives up the bytes written.
    [[nodiscard]] std::string release() {
        NC_memio memory{};
        check(nc_close_memio(std::exchange(id_, -1), &memory));
        const std::unique_ptr<void, decltype(&std::free)> owned(memory.memory, &std::free);
        return {static_cast<const char*>(memory.memory), memory.size};
    }

private:
    std::string path_;
    int id_ = -1;
};

}  // namespace

void write_netcdf(const std::string& path, const Table& table) {
    for (const auto& column : table.columns)
        if (column.values.size() != table.rows())
            throw InvalidArgument(fmt::format("{}: column '{}' has {} rows, expected {}", path, column.name, column.values.size(), table.rows()));
    Dataset dataset(path);
    int rows = 0;
    dataset.check(nc_def_dim(dataset.id(), "row", static_cast<std::size_t>(table.rows()), &rows));
    std::vector<int> variables;
    for (const auto& column : table.columns) {
        variables.emplace_back();
        dataset.check(nc_def_var(dataset.id(), column.name.c_str(), NC_DOUBLE, 1, &rows, &variables.back()));
        dataset.put_text(variables.back(), "units", column.unit);
        dataset.put_text(variables.back(), "long_name", column.name);
    }
    for (const auto& [key, value] : table.metadata) dataset.put_text(NC_GLOBAL, key.c_str(), value);
    dataset.check(nc_enddef(dataset.id()));
    for (std::size_t k = 0; k < variables.size(); ++k)
        dataset.check(nc_put_var_double(dataset.id(), variables[k], table.columns[k].values.data()));
    write_whole_file(path, dataset.release());
}

}  // namespace setae::io
