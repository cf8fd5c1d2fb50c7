# SPDX-License-Identifier: BSD-3-Clause
"""The answer of the program to an arbitrary file, with its processor time and memory."""
import os
import re
import resource
import signal
import subprocess
import tempfile
import time

MEMORY = 2 << 30  # bytes of address space that a command may ask for
SECONDS = 60  # of processor time that it may take
STANDSTILL = 20  # seconds in which it takes none: it waits for something that does not come
CODES = (0, 1, 2, 3, 4)
CONTROL = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f]")
INTERNAL = re.compile(r"internal error|terminate called|Assertion|what\(\):|::_M_|basic_string|map::at|crashed in|bad_variant|bad_optional|"
                      r"stack smashing")
WRONGS = ("signal", "hang", "memory", "internal error", "control characters", "no place")


def seconds_of(pid):
    """Processor time of a process so far [s]."""
    with open(f"/proc/{pid}/stat", encoding="ascii", errors="replace") as stat:
        fields = stat.read().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def limit():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS + 5))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def stands_still(process):
    """Waits for the end of a process; true if it takes no processor time for long."""
    used, since = -1, time.monotonic()
    while os.waitid(os.P_PID, process.pid, os.WEXITED | os.WNOHANG | os.WNOWAIT) is None:
        now = seconds_of(process.pid)
        if now != used:
            used, since = now, time.monotonic()
        elif time.monotonic() - since > STANDSTILL:
            return True
        time.sleep(0.005)
    return False


class Answer:
    """code: exit code, or minus a signal; out, err: texts; seconds: processor time; peak: most memory [bytes]; hangs."""

    def __init__(self, netloft, words, folder, environment=None):
        self.words = words
        with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
            process = subprocess.Popen([netloft, *words], cwd=folder, stdin=subprocess.DEVNULL, stdout=out, stderr=err, preexec_fn=limit,
                                       env={**os.environ, "OMP_THREAD_LIMIT": "1", **(environment or {})})
            self.hangs = stands_still(process)
            if self.hangs:
                process.kill()
            _, status, usage = os.wait4(process.pid, 0)
            self.code = process.returncode = os.waitstatus_to_exitcode(status)
            self.seconds, self.peak = usage.ru_utime + usage.ru_stime, 1024 * usage.ru_maxrss
            self.hangs |= self.code == -signal.SIGXCPU or self.seconds > SECONDS
            self.out, self.err = (read(stream) for stream in (out, err))

    def wrongs(self, *names):
        """Names of WRONGS. `names`: the files to be read, one of which an error must name, and a line of it unless it is binary."""
        found = []
        if self.hangs:
            found.append("hang")
        elif self.code not in CODES:
            found.append("signal")
        if self.peak > MEMORY:
            found.append("memory")
        if INTERNAL.search(self.err):
            found.append("internal error")
        if CONTROL.search(self.out) or CONTROL.search(self.err):
            found.append("control characters")
        if names and self.code in (1, 2) and not self.is_short_of_memory() and not any(name in self.err for name in names):
            found.append("no place")
        return found

    def is_short_of_memory(self):
        return "not enough memory" in self.err

    def has_a_line(self, names):
        """Whether an error names a line of one of these files."""
        return any(re.search(rf"{re.escape(name)}(:| is not UTF-8 text: line )\d+", self.err) for name in names)


def read(stream):
    stream.seek(0)
    return stream.read().decode("utf-8", "replace")
