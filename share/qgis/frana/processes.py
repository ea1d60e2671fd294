# SPDX-License-Identifier: Apache-2.0
"""What a process and a country imply for keys whose fields are left empty."""
from __future__ import annotations

# Of each process: the preset, whose density and friction it has, and the longest simulated time [s]: at the latest, since a
# run ends when nothing that maps show changes any more.
PROCESSES: dict[str, dict[str, str]] = {
    "avalanche": {"material.preset": "snow-avalanche", "time.end": "600"},
    "debris-flow": {"material.preset": "debris-flow", "time.end": "1800"},
    "hillslope-flow": {"material.preset": "debris-flow", "time.end": "900"},
    "rock-avalanche": {"material.preset": "rock-avalanche", "time.end": "600"},
    "mud": {"material.preset": "mudflow", "time.end": "3600"},
}
# Of each country: the scheme of intensity of a process. Where none was read there is none.
COUNTRIES: dict[str, dict[str, dict[str, str]]] = {
    "switzerland": {"avalanche": {"hazard.scheme": "swiss-avalanche"},
                    "debris-flow": {"hazard.scheme": "swiss-debris-flow", "hazard.process": "channel-debris-flow"},
                    "hillslope-flow": {"hazard.scheme": "swiss-hillslope-debris-flow",
                                       "hazard.process": "hillslope-debris-flow"}},
    "austria": {"avalanche": {"hazard.scheme": "austrian-avalanche"}, "debris-flow": {"hazard.scheme": "austrian-torrent"}},
    "italy": {"avalanche": {"hazard.scheme": "italian-avalanche"}},
    "other": {},
}


def implied(process: str, country: str, has_return_period: bool) -> dict[str, str]:
    """The texts of keys. An empty word: not chosen. Avalanches of a return period have the friction table of it."""
    found = {**PROCESSES.get(process, {}), **COUNTRIES.get(country, {}).get(process, {})}
    if process == "avalanche" and has_return_period:
        found["material.friction-table"] = "ngi-avalanche"
    return found
