# SPDX-License-Identifier: BSD-3-Clause
"""Slurm on this machine alone: munged, slurmctld and slurmd with all their files in one folder, until the test ends."""
import os
import shutil
import socket
import subprocess
import time
from pathlib import Path

CONFIGURATION = """\
ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
SlurmUser={user}
SlurmdUser={user}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1,batch_sched_delay=0
JobAcctGatherType=jobacct_gather/none
ReturnToService=2
MpiDefault=none
NodeName={host} NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def why_not():
    """Why Slurm cannot be started here; empty: a start can be tried."""
    lacking = [name for name in ("munged", "slurmctld", "slurmd", "sbatch") if not find(name)]
    if lacking:
        return f"Slurm is not installed: there is no {', '.join(lacking)} (Debian: slurmctld slurmd slurm-client munge)"
    return "" if os.geteuid() == 0 else "slurmd wants to be started by root"


def find(name):
    return shutil.which(name, path=f"{os.environ.get('PATH', '')}:/usr/sbin:/usr/local/sbin")


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


class LocalSlurm:
    def __init__(self, folder):
        self.folder = Path(folder)
        self.programs = []
        self.environment = {**os.environ, "SLURM_CONF": str(self.folder / "slurm.conf")}

    def start(self):
        """Why it could not be started; empty: it runs."""
        for name in ("state", "spool"):
            (self.folder / name).mkdir(parents=True)
        os.chmod(self.folder, 0o755)
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o400)
        text = CONFIGURATION.format(host=socket.gethostname().split(".")[0], folder=self.folder, ports=free_ports(2), user="root")
        (self.folder / "slurm.conf").write_text(text)
        (self.folder / "cgroup.conf").write_text("CgroupPlugin=cgroup/v1\n")
        at = lambda name: str(self.folder / name)
        self.begin("munged", "--foreground", "--force", f"--key-file={key}", f"--socket={at('munge.socket')}",
                   f"--pid-file={at('munge.pid')}", f"--log-file={at('munge.log')}", f"--seed-file={at('munge.seed')}")
        self.wait_for(lambda: (self.folder / "munge.socket").exists())
        self.begin("slurmctld", "-D")
        self.begin("slurmd", "-D")
        return "" if self.wait_for(self.is_idle) else f"Slurm does not start here: {self.last_words()}"

    def begin(self, name, *words):
        with open(self.folder / f"{name}.out", "wb") as log:
            self.programs.append(subprocess.Popen([find(name), *words], env=self.environment, stdin=subprocess.DEVNULL, stdout=log, stderr=log))

    def is_idle(self):
        said = subprocess.run([find("sinfo"), "-h", "-o", "%T"], env=self.environment, capture_output=True, text=True)
        return said.stdout.strip() == "idle"

    def wait_for(self, happened, seconds=120):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if happened():
                return True
            if any(program.poll() is not None for program in self.programs):
                return False
            time.sleep(0.1)
        return False

    def last_words(self):
        words = [(self.folder / f"{name}.out").read_text(errors="replace").strip().splitlines() for name in ("munged", "slurmctld", "slurmd")
                 if (self.folder / f"{name}.out").exists()]
        return "; ".join(lines[-1] for lines in words if lines)

    def stop(self):
        for program in reversed(self.programs):
            program.terminate()
        for program in self.programs:
            try:
                program.wait(timeout=10)
            except subprocess.TimeoutExpired:
                program.kill()
                program.wait()
