// SPDX-License-Identifier: Apache-2.0
#include "facade/prepare_inflows.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/shortest_text.h"
#include "facade/particle_count.h"
#include "simulation/inflow.h"
#include "simulation/release.h"

namespace frana::facade {
namespace {

bool is_amount(double value) {
    return value >= 0 && value <= k_most_of_hydrograph;
}

bool check_line(const std::vector<Point>& line, const std::string& where, Problems& problems) {
    const bool finite =
        std::all_of(line.begin(), line.end(), [](const Point& p) { return std::isfinite(p.x) && std::isfinite(p.y); });
    if (finite && line.size() >= 2) return true;
    problems.add({"has no line", where, std::to_string(line.size()) + " points", "2 or more, finite",
                  "Give the points of a line"});
    return false;
}

bool check_hydrograph(const std::vector<HydrographPoint>& hydrograph, const std::string& where, Problems& problems) {
    if (hydrograph.size() < 2) {
        problems.add({"the hydrograph has fewer than two rows", where, std::to_string(hydrograph.size()), "2 or more",
                      "Give its start and its end"});
        return false;
    }
    bool flows = false;
    double before = 0;
    for (const HydrographPoint& point : hydrograph) {
        const double speed = point.velocity.value_or(0);
        if (!is_amount(point.time) || !is_amount(point.discharge) || !is_amount(speed)) {
            problems.add({"the hydrograph is out of range", where,
                          shortest_text(point.time) + " s, " + shortest_text(point.discharge) + " m3/s, " +
                              shortest_text(speed) + " m/s",
                          "0 to " + shortest_text(k_most_of_hydrograph), "Correct it"});
            return false;
        }
        if (point.time < before) {
            problems.add({"the times of the hydrograph fall", where, shortest_text(point.time) + " s",
                          shortest_text(before) + " s or later", "Sort it by time"});
            return false;
        }
        if (point.discharge > 0 && point.velocity && !(speed > 0)) {
            problems.add({"the hydrograph has a discharge without velocity", where,
                          "at " + shortest_text(point.time) + " s", "greater than 0 m/s",
                          "Correct it, or give none for the critical speed"});
            return false;
        }
        flows = flows || point.discharge > 0;
        before = point.time;
    }
    if (!flows) problems.add({"the hydrograph has no discharge", where, "", "", "Give a discharge above zero"});
    return flows;
}

}  // namespace

std::vector<frana::Inflow> inflows_of(const Scene::Data& data, const SceneSpec& spec, Problems& problems) {
    constexpr double k_turn = 360;
    std::vector<frana::Inflow> inflows;
    for (std::size_t i = 0; i < data.inflows.size(); ++i) {
        const Inflow& inflow = data.inflows[i];
        const std::string where = "inflow " + std::to_string(i + 1);
        frana::Inflow own;
        for (const Point& p : inflow.line) own.line.push_back({p.x, p.y});
        if (inflow.direction) {
            if (!(*inflow.direction >= 0 && *inflow.direction <= k_turn))
                problems.add({"is out of range", where + ": direction", shortest_text(*inflow.direction) + " degrees",
                              "0 to " + shortest_text(k_turn), "Count clockwise from north"});
            own.azimuth = *inflow.direction * std::numbers::pi / 180;
        }
        if (!check_line(inflow.line, where, problems) || !check_hydrograph(inflow.hydrograph, where, problems))
            continue;
        const double length = length_of(own.line);
        for (const HydrographPoint& point : inflow.hydrograph) {
            const double critical = critical_speed(spec.numerics.gravity, point.discharge, length);
            own.hydrograph.push_back({point.time, point.discharge, point.velocity.value_or(critical)});
        }
        inflows.push_back(std::move(own));
    }
    return inflows;
}

void check_inflow_counts(const frana::Scene& scene, Problems& problems) {
    for (std::size_t i = 0; i < scene.inflows.size(); ++i)
        check_particle_count(particles_of(scene.inflows[i], lattice_spacing(scene), scene.time.end),
                             "inflow " + std::to_string(i + 1), problems);
}

}  // namespace frana::facade
