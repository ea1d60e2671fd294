# SPDX-License-Identifier: Apache-2.0
"""Runs the program: its progress to QGIS, a cancel from QGIS to it."""
from __future__ import annotations

import os
import queue
import re
import signal
import struct
import subprocess
import tempfile
import threading
from dataclasses import dataclass, field

from qgis.core import QgsProcessingException, QgsProcessingFeedback

from .fields import Field
from .messages import problems_of, progress_of, warning_of
from .translation import tr
from .wsl import command, inside, is_wsl, outside

try:
    import fcntl
    import pty
    import termios
except ImportError:  # Windows
    pty = None

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
        line = outside(line)
        self.lines.append(line)
        warning = warning_of(line)
        if warning is not None:
            self.warnings.append(warning)
            self.feedback.pushWarning(warning)
        else:
            self.feedback.pushInfo(line)


def _terminal() -> tuple[int, int]:
    """Two ends of what the program writes messages to. On a terminal it shows progress five times a second, else, as on
    Windows, every ten seconds."""
    if pty is None:
        return os.pipe()
    master, slave = pty.openpty()
    fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", 50, _WIDTH, 0, 0))
    return master, slave


def run_program(words: list[str], feedback: QgsProcessingFeedback) -> Finished:
    """Runs the program, words[0], to its end. On cancel it gets SIGINT: a run writes its checkpoint and what it has."""
    master, slave = _terminal()
    reader, lines = _Reader(feedback), _Lines()
    with tempfile.TemporaryFile() as output:
        try:
            process = subprocess.Popen(command(words[0], words[1:]), stdin=subprocess.DEVNULL, stdout=output, stderr=slave)
        except OSError as error:
            os.close(master)
            raise QgsProcessingException(tr("{0} could not be started: {1}", words[0], error.strerror)) from error
        finally:
            os.close(slave)
        try:
            _follow(process, words, master, lines, reader, feedback)
        finally:
            os.close(master)
        for line in lines.end():
            reader.take(line)
        output.seek(0)
        text = output.read().decode("utf-8", "replace")
    code = process.returncode if process.returncode >= 0 else 128 - process.returncode
    return Finished(code, outside(text), reader.lines, reader.warnings)


def _read(end: int, data: queue.Queue) -> None:
    """Puts what comes into the queue; at last nothing."""
    while True:
        try:
            part = os.read(end, 65536)
        except OSError:  # the other side of the terminal is closed
            part = b""
        data.put(part)
        if not part:
            return


def _follow(process: subprocess.Popen, words: list[str], master: int, lines: _Lines, reader: _Reader,
            feedback: QgsProcessingFeedback) -> None:
    asked_to_stop = False
    data: queue.Queue = queue.Queue()
    thread = threading.Thread(target=_read, args=(master, data), daemon=True)
    thread.start()
    while True:
        try:
            part = data.get(timeout=_INTERVAL)
            for line in lines.add(part):
                reader.take(line)
            if not part:
                process.wait()
                break
        except queue.Empty:
            if process.poll() is not None:
                return
        if feedback.isCanceled() and not asked_to_stop:
            asked_to_stop = True
            feedback.setProgressText(tr("Stopping: the program writes what it has"))
            if is_wsl(words[0]):  # a signal does not pass from Windows to Linux
                own = "--out " + inside(words[words.index("--out") + 1]) if "--out" in words else "frana"
                run = re.sub(r"([.^$*+?()\[\]{}|\\])", r"\\\1", own)
                subprocess.run([words[0], "--", "pkill", "-INT", "-f", "--", run], check=False)
            else:
                process.send_signal(signal.SIGINT)
    thread.join()


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
