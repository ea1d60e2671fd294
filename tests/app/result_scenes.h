// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/tiny_scene.h"

namespace frana::test {

inline const std::string k_every_output =
    "[output]\nframes = on\nmap-size = 640x480\nmap-formats = png, pdf, svg\nmaps = max_depth, "
    "max_velocity_3d\n"
    "formats = geotiff, particles-gpkg\n"
    "gauges = gauge.geojson\ncross-sections = section.geojson\n"
    "[hazard]\nscheme = austrian-torrent\n[scar]\nperimeter = scar.geojson\n";

/// Runs with many outputs on coarse cells.
class ResultScenes : public TinyScene {
  protected:
    ResultScenes() {
        write_features("gauge", {{"Point", {{45, 75}}, named("top")}});
        write_features("section", {{"LineString", {{80, 0}, {80, 150}}, named("bridge")}});
        write_polygon("scar", {{15, 50}, {180, 50}, {180, 100}, {15, 100}});
    }
    /// Runs a scene's text on cells of 10 m into a folder.
    void run(const std::string& text, const std::string& result, const std::vector<std::string>& more = {}) const {
        write("scene.ini",
              "[terrain]\ndtm = dtm.asc\ncell-size = 10\n[release]\nperimeter = perimeter.geojson\n"
              "thickness = 2\n[time]\nend = 2\nframe-interval = 0.5\nstop-when-still = off\n[output]\n" +
                  k_one_day + text);
        succeeded(frana(with_more({"run", "scene.ini", "--out", result, "--quiet"}, more)));
    }
    void render(const std::vector<std::string>& words) const { succeeded(frana(with_more({"render", "old"}, words))); }
    /// Everything that can be drawn later.
    void render_all() const {
        render({"--charts", "--size", "640x480"});
        render({"--animation", "old/film.gif", "--size", "640x480"});
        render({"--map", "depth@1", "--map", "dtm", "--size", "640x480"});
        render({"--map", "max_depth", "--out", "old/more", "--size", "640x480"});
        succeeded(frana({"compare", "old", "--scar", "scar.geojson", "--size", "640x480", "--out", "old/compared"}));
    }
    void copy(const std::string& from, const std::string& to) const {
        std::filesystem::copy(path(from), path(to),
                              std::filesystem::copy_options::recursive | std::filesystem::copy_options::copy_symlinks);
    }
    [[nodiscard]] bool exists(const std::string& name) const {
        return std::filesystem::exists(std::filesystem::symlink_status(path(name)));
    }
};

inline const std::string k_voellmy = "[material]\nfriction-angle = 15\nturbulence = 500\n";
inline const std::string k_structured =
    "[material]\nmodel = structured\n[structured]\nphases = solids-and-fluid\ncohesion = 2e3\n"
    "internal-friction-angle = 28\nbed-friction-angle = 12\nyoung-modulus = 1e6\nbulk-modulus = 1e6\nmanning "
    "= 0.05\n"
    "[numerics]\nparticles-per-cell = 9\n";
inline const std::string k_stress = "[output]\nrasters = plane_stress\n";
inline const std::string k_entrainment =
    "[entrainment]\nerosion = growth\ngrowth-rate = 0.005\nerodible-depth = 0.5\ndeposition = on\n"
    "deposition-rate = 0.01\ndeposition-shear-stress = 2000\ndetrainment = on\ndetrainment-coefficient = 20\n";

}  // namespace frana::test
