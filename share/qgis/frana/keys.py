# SPDX-License-Identifier: Apache-2.0
"""A key of a scene file, as `frana params --json` describes it."""
from __future__ import annotations

import re
from dataclasses import dataclass

from .translation import tr

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
    words_of_key: str  # in the user's language, as are the section's title, the meaning and the effect
    section_title: str
    place: int | None  # among the fields that a dialogue does not hide
    is_required: bool  # under some condition at least

    @property
    def parameter(self) -> str:
        """Name of the parameter of an algorithm: letters, digits and _ only."""
        return re.sub(r"\W", "_", self.name)

    def short_title(self) -> str:
        """"Cell size": within its section."""
        words = self.words_of_key
        if words == self.name.partition(".")[2]:  # a key without a title of its own
            words = words.replace("-", " ")
        return words[:1].upper() + words[1:]

    def title(self) -> str:
        """"Release area"; of the many others with the section: "Time: Frame interval"."""
        return self.short_title() if self.place is not None else f"{self.section_title}: {self.short_title()}"

    def label(self, title: str) -> str:
        """A title with unit and, where it fits into a dialogue, what counts if the field stays empty."""
        label = title + (f" [{self.unit}]" if self.unit else "")
        text = "" if self.is_required or self.type == "on | off" else self.otherwise()
        return f"{label} ({text})" if text and len(label) + len(text) <= _LONGEST_LABEL else label

    def otherwise(self) -> str:
        """What counts if the key is not given."""
        return self.absent if self.default is None else self.default

    def help(self) -> str:
        """Everything about it."""
        facts = [tr("Allowed: {0}", self.limits) if self.limits else "",
                 tr("Empty: {0}", self.otherwise()) if self.otherwise() else "", tr("Key: {0}", self.name)]
        return "\n".join([self.meaning, "", *(fact for fact in facts if fact)])

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
               row.get("when_absent", ""), row["limits"], row["meaning"], row.get("content", ""), row["title"],
               row["section_title"], row.get("place"), row["required"])
