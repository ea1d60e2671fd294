# SPDX-License-Identifier: Apache-2.0
"""A key of a scene file, as `frana params --json` describes it, and which keys a dialogue shows first."""
from __future__ import annotations

import re
from dataclasses import dataclass

_LONGEST_LABEL = 64  # letters; longer ones would widen the dialogue


@dataclass(frozen=True)
class Key:
    name: str  # "release.dtm-contains-release"
    section: str
    key: str
    type: str
    unit: str
    default: str | None  # a fixed one; else see absent
    absent: str  # the effect if not given
    limits: str
    meaning: str
    content: str  # of a file
    is_first: bool  # a main key; all others are advanced

    @property
    def parameter(self) -> str:
        """Name of the parameter of an algorithm: letters, digits and _ only."""
        return re.sub(r"\W", "_", self.name)

    def label(self) -> str:
        """"Terrain: cell size [m] (0.01 to 1000; otherwise the DTM's own)", as much as fits into a dialogue."""
        label = self.title() + (f" [{self.unit}]" if self.unit else "")
        limits = "" if self.type in ("choice", "on | off") else self.limits
        for facts in ((limits, self.otherwise()), (self.otherwise(),), (limits,)):
            text = "; ".join(fact for fact in facts if fact)
            if text and len(label) + len(text) <= _LONGEST_LABEL:
                return f"{label} ({text})"
        return label

    def otherwise(self) -> str:
        """What counts if the key is not given."""
        if self.default is not None:
            return f"otherwise {self.default}"
        if self.absent == "required":
            return "needed, unless a scene file is given"
        if self.absent.startswith("required"):
            return "needed" + self.absent[len("required"):]
        return f"otherwise {self.absent}" if self.absent else ""

    def help(self) -> str:
        """Everything about it."""
        facts = [f"Allowed: {self.limits}" if self.limits else "", self.otherwise(), f"Key: {self.name}"]
        return "\n".join([self.meaning, "", *(fact for fact in facts if fact)])

    def title(self) -> str:
        """Section and key as words: "Terrain: cell size"."""
        return f"{self.section.capitalize()}: {self.key.replace('-', ' ')}"

    def range(self) -> tuple[float, float] | None:
        """The limits of a number; None where the text says more than two numbers."""
        number = r"([-+\d.e]+)"
        match = (re.fullmatch(f"{number} to {number}", self.limits) or
                 re.fullmatch(f"greater than {number}, at most {number}", self.limits))
        return (float(match.group(1)), float(match.group(2))) if match else None

    def words(self) -> list[str]:
        """The words of a choice or of a list of words; empty if the limits are something else."""
        allowed = re.sub(r" \(.*\)$", "", self.limits)
        words = allowed.split(", ")
        return words if all(re.fullmatch(r"[\w-]+", word) for word in words) else []

    def is_fixed(self) -> bool:
        """Whether it has one possible value only."""
        limits = self.range()
        return limits is not None and limits[0] == limits[1]


def key_from_json(row: dict) -> Key:
    return Key(row["name"], row["section"], row["key"], row["type"], row["unit"], row["default"],
               row.get("when_absent", ""), row["limits"], row["meaning"], row.get("content", ""), row.get("main", False))


def in_order_of_dialogue(keys: list[Key]) -> list[Key]:
    """The first ones, then the others, both section by section."""
    sections = list(dict.fromkeys(key.section for key in keys))
    return sorted(keys, key=lambda key: (not key.is_first, sections.index(key.section)))
