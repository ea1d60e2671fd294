// SPDX-License-Identifier: Apache-2.0
#include "analysis/separate_flows.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/error.h"

namespace frana {

std::optional<std::size_t> cell_at(const GridSpec& grid, Point place) {
    const auto column = static_cast<std::int64_t>(std::floor((place.x - grid.west) / grid.cell_size));
    const auto row = static_cast<std::int64_t>(std::floor((grid.north - place.y) / grid.cell_size));
    if (column < 0 || row < 0 || column >= grid.columns || row >= grid.rows) return std::nullopt;
    return static_cast<std::size_t>(row * grid.columns + column);
}

namespace {

/// A set of numbers 0 ... n - 1 whose members are joined into groups.
class Groups {
  public:
    explicit Groups(std::size_t count) : parent_(count) {
        for (std::size_t i = 0; i < count; ++i) parent_[i] = i;
    }
    /// Returns the smallest member of a group.
    std::size_t smallest(std::size_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::size_t a, std::size_t b) {
        a = smallest(a);
        b = smallest(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::size_t> parent_;
};

}  // namespace

SeparateFlows::SeparateFlows(const Raster& release, const Raster& reached, const std::vector<Point>& inflows) {
    const GridSpec& grid = reached.grid;
    if (!grid.same_cells(release.grid)) {
        throw Error(ErrorKind::input, Problem{"release and flow do not have the same cells", "run-out", "", "", ""});
    }
    const auto columns = static_cast<std::size_t>(grid.columns);
    const auto append = [columns](std::vector<Run>& runs, std::size_t first, std::size_t last) {
        const bool touches =
            !runs.empty() && runs.back().last >= first && runs.back().first / columns == first / columns;
        if (touches) {
            runs.back().last = std::max(runs.back().last, last);
        } else {
            runs.push_back({first, last, 0});
        }
    };
    const auto runs_of = [&](const Raster& raster) {
        std::vector<Run> runs;
        raster.values.for_each_stored([&](std::size_t cell, double value) {
            if (value > 0) append(runs, cell, cell + 1);
        });
        return runs;
    };
    const std::vector<Run> released = runs_of(release);
    std::vector<Run> all = runs_of(reached);
    const std::size_t n_reached = all.size();
    all.insert(all.end(), released.begin(), released.end());
    std::vector<std::size_t> sources;
    for (const Point& place : inflows) {
        const auto cell = cell_at(grid, place);
        if (!cell) continue;
        sources.push_back(*cell);
        all.push_back({sources.back(), sources.back() + 1, 0});
    }
    for (const Run& run : released) sources.push_back(run.first);
    const auto by_cell = [](const Run& a, const Run& b) { return a.first < b.first; };
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(n_reached);
    std::sort(middle, all.end(), by_cell);
    std::inplace_merge(all.begin(), middle, all.end(), by_cell);
    for (const Run& run : all) append(runs_, run.first, run.last);

    connect(grid.columns);
    if (!sources.empty()) {
        std::vector<bool> has_source(runs_.size(), false);
        for (const std::size_t cell : sources) has_source[flow_of(cell)] = true;
        join_islands(grid.columns, has_source);
    }
    number_flows();
}

/// Joins runs that touch those of the row above; a flow has the number of its first run.
void SeparateFlows::connect(std::int64_t columns) {
    const auto across = static_cast<std::size_t>(columns);
    Groups groups(runs_.size());
    std::size_t above = 0;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
        const Run& run = runs_[i];
        const std::size_t row = run.first / across;
        if (row == 0) continue;
        // Runs of the row above that end before this one's left corner touch none of the runs that follow.
        const std::size_t first = run.first - across, last = run.last - across;
        while (above < i && (runs_[above].first / across + 1 < row || runs_[above].last < first)) ++above;
        for (std::size_t k = above; k < i && runs_[k].first / across + 1 == row && runs_[k].first <= last; ++k)
            groups.join(i, k);
    }
    for (std::size_t i = 0; i < runs_.size(); ++i) runs_[i].flow = groups.smallest(i);
    count_ = runs_.size();
}

/// Regions without a source become part of the flow nearest to them.
void SeparateFlows::join_islands(std::int64_t columns, const std::vector<bool>& has_source) {
    struct Span {
        std::int64_t first, last;  // columns, both included
        std::size_t flow;
    };
    std::map<std::int64_t, std::vector<Span>> rows;  // of flows with a source
    const auto place = [columns](const Run& run) {
        const auto first = static_cast<std::int64_t>(run.first),
                   count = static_cast<std::int64_t>(run.last - run.first);
        return std::pair{first / columns, Span{first % columns, first % columns + count - 1, run.flow}};
    };
    for (const Run& run : runs_)
        if (has_source[run.flow]) rows[place(run).first].push_back(place(run).second);

    struct Nearest {
        double squared = std::numeric_limits<double>::infinity();
        std::size_t flow = 0;
    };
    std::map<std::size_t, Nearest> islands;
    for (const Run& run : runs_) {
        if (has_source[run.flow]) continue;
        Nearest& nearest = islands[run.flow];
        const auto [row, span] = place(run);
        const auto look_in = [&, row = row, span = span](std::int64_t other_row, const std::vector<Span>& spans) {
            // Runs of a row share no cell: the last that begins left of this one's end, and the next.
            auto next = std::upper_bound(spans.begin(), spans.end(), span.last,
                                         [](std::int64_t column, const Span& s) { return column < s.first; });
            const auto consider = [&](const Span& s) {
                const auto apart = std::max<std::int64_t>({0, s.first - span.last, span.first - s.last});
                const double dx = static_cast<double>(apart), dy = static_cast<double>(other_row - row);
                if (dx * dx + dy * dy < nearest.squared) nearest = {dx * dx + dy * dy, s.flow};
            };
            if (next != spans.begin()) consider(*std::prev(next));
            if (next != spans.end()) consider(*next);
        };
        auto below = rows.lower_bound(row), above = below;
        const auto off = [row = row](std::int64_t other) {
            const auto distance = static_cast<double>(other - row);
            return distance * distance;
        };
        while (above != rows.begin() && off(std::prev(above)->first) < nearest.squared) {
            --above;
            look_in(above->first, above->second);
        }
        for (; below != rows.end() && off(below->first) < nearest.squared; ++below)
            look_in(below->first, below->second);
    }
    for (Run& run : runs_)
        if (!has_source[run.flow]) run.flow = islands[run.flow].flow;
}

void SeparateFlows::number_flows() {
    std::map<std::size_t, std::size_t> numbers;
    for (Run& run : runs_) run.flow = numbers.try_emplace(run.flow, numbers.size()).first->second;
    count_ = numbers.size();
}

std::size_t SeparateFlows::flow_of(std::size_t cell) const noexcept {
    const auto next = std::upper_bound(runs_.begin(), runs_.end(), cell,
                                       [](std::size_t value, const Run& run) { return value < run.first; });
    if (next == runs_.begin() || std::prev(next)->last <= cell) return count_;
    return std::prev(next)->flow;
}

}  // namespace frana
