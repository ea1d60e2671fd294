# SPDX-License-Identifier: Apache-2.0
"""Runs the program: its progress to QGIS, a cancel from QGIS to it."""
from __future__ import annotations

import fcntl
import os
import pty
import re
import select
import signal
import struct
import subprocess
import tempfile
import termios
from dataclasses import dataclass, field

from qgis.core import QgsProcessingException, QgsProcessingFeedback

from .fields import Field
from .messages import problems_of, progress_of, warning_of
from .translation import tr

STOPPED = 128 + signal.SIGINT
_INTERVAL = 0.1  # seconds between looks at the cancel button
_WIDTH = 1000  # of the terminal: no line is broken


@dataclass
class Finished:
    code: int
    output: str
    lines: list[str] = field(default_factory=list)  # of stderr, without progress
    warnings: list[str] = field(default_factory=list)

    @property
    def was_stopped(self) -> bool:
        return self.code == STOPPED


class _Lines:
    """Splits what comes from a terminal into lines; a line of progress is overwritten, so a carriage return ends it too."""

    def __init__(self) -> None:
        self.rest = b""

    def add(self, data: bytes) -> list[str]:
        *complete, self.rest = re.split(rb"[\r\n]+", self.rest + data)
        return [text for text in map(self._text, complete) if text.strip()]

    def end(self) -> list[str]:
        return self.add(b"\n")

    @staticmethod
    def _text(line: bytes) -> str:
        return re.sub(r"\x1b\[[0-9;]*[A-Za-z]", "", line.decode("utf-8", "replace"))


class _Reader:
    """Sorts the lines."""

    def __init__(self, feedback: QgsProcessingFeedback) -> None:
        self.feedback, self.lines, self.warnings = feedback, [], []

    def take(self, line: str) -> None:
        percent = progress_of(line)
        if percent is not None:
            self.feedback.setProgress(percent)
            self.feedback.setProgressText(line.removeprefix("frana: ").strip())
            return
        self.lines.append(line)
        warning = warning_of(line)
        if warning is not None:
            self.warnings.append(warning)
            self.feedback.pushWarning(warning)
        else:
            self.feedback.pushInfo(line)


def run_program(words: list[str], feedback: QgsProcessingFeedback) -> Finished:
    """Runs the program to its end. On cancel it gets SIGINT: a run writes its checkpoint and what it has."""
    # On a terminal the program shows progress five times a second, else every ten seconds.
    master, slave = pty.openpty()
    fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", 50, _WIDTH, 0, 0))
    reader, lines = _Reader(feedback), _Lines()
    with tempfile.TemporaryFile() as output:
        try:
            process = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=output, stderr=slave)
        except OSError as error:
            os.close(master)
            raise QgsProcessingException(tr("{0} could not be started: {1}", words[0], error.strerror)) from error
        finally:
            os.close(slave)
        try:
            _follow(process, master, lines, reader, feedback)
        finally:
            os.close(master)
        for line in lines.end():
            reader.take(line)
        output.seek(0)
        text = output.read().decode("utf-8", "replace")
    code = process.returncode if process.returncode >= 0 else 128 - process.returncode
    return Finished(code, text, reader.lines, reader.warnings)


def _follow(process: subprocess.Popen, master: int, lines: _Lines, reader: _Reader,
            feedback: QgsProcessingFeedback) -> None:
    asked_to_stop = False
    while True:
        ready, _, _ = select.select([master], [], [], _INTERVAL)
        if ready:
            try:
                data = os.read(master, 65536)
            except OSError:  # the other side of the terminal is closed
                data = b""
            for line in lines.add(data):
                reader.take(line)
            if not data:
                process.wait()
                return
        elif process.poll() is not None:
            return
        if feedback.isCanceled() and not asked_to_stop:
            asked_to_stop = True
            feedback.setProgressText(tr("Stopping: the program writes what it has"))
            process.send_signal(signal.SIGINT)


def run_or_refuse(words: list[str], feedback: QgsProcessingFeedback, fields: list[Field], names: dict[str, str],
                  resume_hint: str = "") -> Finished:
    """As run_program; throws with the program's sentences unless it succeeded. `names`: see problems_of."""
    feedback.pushCommandInfo(" ".join(words))
    done = run_program(words, feedback)
    if done.code == 0:
        return done
    if done.was_stopped:
        raise QgsProcessingException(tr("Stopped") + (". " + resume_hint if resume_hint else ""))
    problems = problems_of(done.lines, fields, names)
    raise QgsProcessingException("\n".join(problems) or tr("{0} ended with exit code {1}", "frana", done.code))
