# SPDX-License-Identifier: Apache-2.0
"""What an algorithm declares as its outputs, and where each is in a result's folder, so that steps of a model can chain."""
from __future__ import annotations

import glob
import json
import os
from dataclasses import dataclass
from typing import Any

from osgeo import ogr
from qgis.core import (QgsProcessingAlgorithm, QgsProcessingOutputFile, QgsProcessingOutputFolder,
                       QgsProcessingOutputMultipleLayers, QgsProcessingOutputNumber, QgsProcessingOutputRasterLayer,
                       QgsProcessingOutputString, QgsProcessingOutputVectorLayer)

# A report is a file: QGIS 3.22 ends the batch of an algorithm with an output of HTML in an error of its own.
_DEFINITIONS = {"raster": QgsProcessingOutputRasterLayer, "layer": QgsProcessingOutputVectorLayer,
                "file": QgsProcessingOutputFile, "folder": QgsProcessingOutputFolder,
                "rasters": QgsProcessingOutputMultipleLayers, "number": QgsProcessingOutputNumber,
                "text": QgsProcessingOutputString}


@dataclass(frozen=True)
class Output:
    kind: str  # of _DEFINITIONS
    name: str
    label: str
    place: str  # "max_depth.tif", "probability_*.tif", "extent.gpkg|trace", "summary.json|runout.horizontal_m"

    def find(self, folder: str) -> Any:
        """Returns the path or the value; None where the result has none."""
        file, _, inside = self.place.partition("|")
        path = os.path.join(folder, file)
        if self.kind == "rasters":
            return sorted(one for pattern in file.split() for one in
                          glob.glob(os.path.join(glob.escape(folder), pattern))) or None
        if not os.path.exists(path):
            return None
        if self.kind == "layer":
            package = ogr.Open(path)
            return f"{path}|layername={inside}" if package and package.GetLayerByName(inside) else None
        return _value(path, inside) if inside else path


def _value(path: str, inside: str) -> Any:
    with open(path, encoding="utf-8") as file:
        value = json.load(file)
    for step in inside.split("."):
        if not isinstance(value, dict) or step not in value:
            return None
        value = value[step]
    return "\n".join(map(str, value)) if isinstance(value, list) else value


def declare(algorithm: QgsProcessingAlgorithm, outputs: tuple[Output, ...]) -> None:
    for output in outputs:
        algorithm.addOutput(_DEFINITIONS[output.kind](output.name, output.label))


def collect(folder: str, outputs: tuple[Output, ...]) -> dict[str, Any]:
    """Returns those that the result has."""
    found = {output.name: output.find(folder) for output in outputs}
    return {name: value for name, value in found.items() if value is not None}


def _raster(name: str, label: str, file: str = "") -> Output:
    return Output("raster", name, label, (file or name.lower()) + ".tif")


COMPARISON = (
    _raster("COMPARISON", "Comparison: 1 hit, 2 false alarm, 3 miss"),
    Output("file", "SCORES", "Scores (JSON)", "comparison.json"),
    Output("file", "COMPARISON_PICTURE", "Picture of the comparison", "comparison.png"),
    Output("number", "JACCARD", "Jaccard index", "comparison.json|jaccard"),
    Output("number", "AREA_DIFFERENCE_PERCENT", "Difference of areas [%]", "comparison.json|area_difference_percent"),
    Output("number", "TRUE_POSITIVE_RATE", "True positive rate", "comparison.json|true_positive_rate"),
    Output("number", "RUNOUT_DIFFERENCE_M", "Difference of run-out [m]", "comparison.json|runout_difference_m"),
)
EXPOSURE = tuple(Output("layer", "EXPOSED_" + kind.upper(), f"Exposed {kind} with what reaches them",
                        f"exposure.gpkg|exposure_{kind}") for kind in ("points", "lines", "areas")) + (
    Output("file", "EXPOSURE_TABLE", "Exposed features (CSV)", "exposure.csv"),
    Output("number", "EXPOSED_REACHED", "Exposed features that are reached", "summary.json|exposure.reached"),
)
RUN = (
    _raster("MAX_DEPTH", "Maximum depth [m]"), _raster("MAX_VELOCITY", "Maximum velocity [m/s]"),
    _raster("MAX_PRESSURE", "Maximum pressure [kPa]"), _raster("ARRIVAL_TIME", "Arrival time [s]"),
    _raster("FINAL_DEPTH", "Final depth [m]"), _raster("RELEASE", "Release thickness [m]"),
    _raster("DTM", "Terrain as used [m]"), _raster("BED", "Sliding surface [m]"),
    _raster("HAZARD", "Classes of intensity, with a hazard scheme"),
    _raster("MU", "Bed friction coefficient, with a friction table"),
    _raster("XI", "Turbulence coefficient [m/s2], with a friction table"),
    Output("layer", "TRACE", "Outline of the trace", "extent.gpkg|trace"),
    Output("layer", "DEPOSIT", "Outline of the deposit", "extent.gpkg|deposit"),
    Output("layer", "RELEASE_OUTLINE", "Outline of the release", "extent.gpkg|release"),
    Output("layer", "HAZARD_ZONES", "Zones of intensity, with a hazard scheme", "hazard_zones.gpkg|hazard_zones"),
    Output("file", "REPORT", "Report", "report.html"),
    Output("file", "ANIMATION", "Animation", "animation.mp4"),
    Output("folder", "FRAMES", "Frames over time", "frames"),
    Output("folder", "MAPS", "Maps", "maps"), Output("folder", "CHARTS", "Charts", "charts"),
    Output("file", "TIME_SERIES", "Time series (CSV)", "timeseries.csv"),
    Output("layer", "PROFILES", "Profiles and flow path", "profiles.gpkg|lines"),
    Output("file", "PROFILE_TABLE", "Profiles (CSV)", "profiles.csv"),
    Output("file", "GAUGES", "Gauges (CSV)", "gauges.csv"), Output("file", "SECTIONS", "Cross-sections (CSV)", "sections.csv"),
    Output("file", "PROJECT", "QGIS project", "result.qgz"),
    Output("file", "SCENE_USED", "Scene as used", "scene.ini"),
    Output("file", "SUMMARY", "Summary (JSON)", "summary.json"),
    Output("number", "VOLUME_M3", "Released volume [m3]", "summary.json|volume.initial_m3"),
    Output("number", "COVERED_AREA_M2", "Covered area [m2]", "summary.json|covered_area_m2"),
    Output("number", "MAX_DEPTH_M", "Greatest depth [m]", "summary.json|max_depth_m"),
    Output("number", "MAX_VELOCITY_MS", "Greatest speed [m/s]", "summary.json|max_velocity_ms"),
    Output("number", "RUNOUT_M", "Run-out, horizontal [m]", "summary.json|runout.horizontal_m"),
    Output("number", "DROP_M", "Drop [m]", "summary.json|runout.drop_m"),
    Output("number", "REACH_ANGLE_DEG", "Reach angle [degrees]", "summary.json|runout.reach_angle_deg"),
    Output("number", "SIMULATED_SECONDS", "Simulated time [s]", "summary.json|simulated_seconds"),
    Output("text", "STOP_REASON", "Why the run ended", "summary.json|stop_reason_text"),
    Output("text", "CRS_USED", "Working CRS", "summary.json|crs"),
    Output("text", "WARNINGS", "Warnings", "summary.json|warnings"),
) + EXPOSURE + COMPARISON
CONVERGE = (
    _raster("UNCERTAINTY", "Estimated error of the depth [m]"),
    Output("file", "TABLE", "Levels (CSV)", "convergence.csv"),
    Output("file", "CONVERGENCE", "Convergence (JSON)", "convergence.json"),
    Output("file", "PICTURE", "Chart", "convergence.png"),
) + tuple(Output("number", name + "_ERROR", f"Estimated error of the {label}",
                 f"convergence.json|statistics.{key}.estimated_error")
          for name, label, key in (("MAX_DEPTH", "maximum depth [m]", "max_depth_m"),
                                   ("MAX_VELOCITY", "maximum velocity [m/s]", "max_velocity_ms"),
                                   ("AREA", "covered area [m2]", "covered_area_m2"), ("RUNOUT", "run-out [m]", "runout_m")))
ENSEMBLE = (
    _raster("QUANTILE_DEPTH_05", "Maximum depth, 5 % quantile [m]", "quantile_max_depth_05"),
    _raster("QUANTILE_DEPTH_50", "Maximum depth, median [m]", "quantile_max_depth_50"),
    _raster("QUANTILE_DEPTH_95", "Maximum depth, 95 % quantile [m]", "quantile_max_depth_95"),
    _raster("QUANTILE_VELOCITY_50", "Maximum velocity, median [m/s]", "quantile_max_velocity_50"),
    _raster("QUANTILE_VELOCITY_95", "Maximum velocity, 95 % quantile [m/s]", "quantile_max_velocity_95"),
    _raster("HIT_COUNT", "Number of runs that came"),
    Output("rasters", "PROBABILITIES", "All probabilities and their margins", "probability_*.tif"),
    Output("rasters", "STATISTICS", "All quantiles", "quantile_*.tif"),
    Output("rasters", "SENSITIVITY_MAPS", "Maps of sensitivity", "sensitivity_*.tif"),
    Output("layer", "OUTLINES", "Outlines of the runs", "members.gpkg|members"),
    Output("file", "MEMBERS", "Runs: values and figures (CSV)", "members.csv"),
    Output("file", "SENSITIVITIES", "Sensitivities (CSV)", "sensitivity.csv"),
    Output("file", "REPORT", "Report", "report.html"),
    Output("file", "PROJECT", "QGIS project", "result.qgz"),
    Output("file", "STUDY_USED", "Study as used", "study.ini"),
    Output("file", "SUMMARY", "Summary (JSON)", "summary.json"),
    Output("number", "FINISHED", "Runs finished", "summary.json|finished"),
    Output("number", "FAILED", "Runs failed", "summary.json|failed"),
    Output("number", "LARGEST_STANDARD_ERROR", "Largest standard error", "summary.json|largest_standard_error"),
    Output("text", "WARNINGS", "Warnings", "summary.json|warnings"),
) + EXPOSURE
BATCH = tuple(_raster(f"UNION_{name}", f"{label} that any slope causes") for name, label in (
    ("MAX_DEPTH", "Greatest depth [m]"), ("MAX_VELOCITY", "Greatest speed [m/s]"),
    ("MAX_PRESSURE", "Greatest pressure [kPa]"), ("ARRIVAL_TIME", "Earliest arrival [s]"))) + (
    _raster("HIT_COUNT", "Number of slopes that reach the cell"), _raster("WORST_SOURCE", "Slope with the greatest depth"),
    _raster("HAZARD_DEGREE", "Degree of hazard, with a scheme and return periods"),
    Output("rasters", "SCENARIOS", "Rasters of each scenario", "scenario_*.tif"),
    Output("layer", "HAZARD_DEGREE_ZONES", "Zones of hazard", "hazard_degree_zones.gpkg|hazard_degree_zones"),
    Output("layer", "SLOPES", "Slopes: values, figures, reasons of failures", "members.gpkg|slopes"),
    Output("layer", "OUTLINES", "Outlines of what each slope reaches", "members.gpkg|members"),
    Output("layer", "TRACE", "Outline of the trace", "extent.gpkg|trace"),
    Output("file", "MEMBERS", "Slopes: values and figures (CSV)", "members.csv"),
    Output("file", "REPORT", "Report", "report.html"), Output("file", "PROJECT", "QGIS project", "result.qgz"),
    Output("file", "REGION_USED", "Region as used", "region.ini"),
    Output("file", "SUMMARY", "Summary (JSON)", "summary.json"),
    Output("number", "FINISHED", "Slopes finished", "summary.json|finished"),
    Output("number", "FAILED", "Slopes failed", "summary.json|failed"),
    Output("text", "WARNINGS", "Warnings", "summary.json|warnings"),
) + EXPOSURE
CALIBRATE = (
    Output("file", "POSTERIOR", "Draws of the values (CSV)", "posterior.csv"),
    Output("file", "BEST_SCENE", "Best scene", "best.ini"),
    Output("file", "REPORT", "Report", "report.html"),
    Output("file", "CALIBRATION", "Calibration (JSON)", "calibration.json"),
    Output("rasters", "POSTERIOR_MAPS", "Posterior probability of each event", "posterior_*.tif"),
    Output("number", "BEST_SCORE", "Best score", "calibration.json|best_score"),
    Output("text", "WARNINGS", "Warnings", "summary.json|warnings"),
)
