"""`burin batch slurm`: a real slurmctld and slurmd with munge on this machine."""

import os
import re
import shutil
import socket
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

from batch_support import BatchTest, end

PROGRAMS = ("slurmctld", "slurmd", "munged", "mungekey", "sbatch", "scontrol", "squeue")
MISSING = [name for name in PROGRAMS if not shutil.which(name, path=os.environ["PATH"] + ":/usr/sbin")]
PLAIN = '[[parts]]\nfiles = ["parts/*"]\nstyles = ["outline"]\n'
CONF = """
ClusterName=one
SlurmctldHost=localhost
AuthType=auth/munge
AuthInfo=socket={dir}/munge.socket
SlurmUser=root
SlurmdUser=root
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
SlurmctldPidFile={dir}/slurmctld.pid
SlurmdPidFile={dir}/slurmd.pid
StateSaveLocation={dir}/state
SlurmdSpoolDir={dir}/spool
SlurmctldLogFile={dir}/slurmctld.log
SlurmdLogFile={dir}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
MpiDefault=none
KillWait=2
NodeName=localhost NodeAddr=127.0.0.1 CPUs={cores} RealMemory=500 State=UNKNOWN
PartitionName=main Nodes=localhost Default=YES MaxTime=INFINITE State=UP OverSubscribe=NO
"""


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for s in sockets:
        s.bind(("127.0.0.1", 0))
    ports = [s.getsockname()[1] for s in sockets]
    for s in sockets:
        s.close()
    return ports


class Script(BatchTest):
    """What needs no Slurm."""

    def test_the_script(self):
        self.parts(*(f"{n} x.off" for n in range(6)))
        self.plan(PLAIN)
        words = ("slurm", "jobs.jsonl", "--script", "task.sh", "--each", "25", "--memory", "2G", "--sbatch=--partition=long")
        said = self.batch(*words)
        self.assertIn("--array=1-2 --requeue", said)  # six drawings of 25 s are two tasks of a minute or more
        self.assertIn("--partition=long", said)
        script = (self.folder / "task.sh").read_text()
        self.assertIn('--shard "$SLURM_ARRAY_TASK_ID/2"', script)
        # It does what Slurm would have it do.
        for task in (1, 2):
            subprocess.run(["sh", "task.sh"], cwd=self.folder, env={**os.environ, "SLURM_ARRAY_TASK_ID": str(task)}, check=True)
        self.assertEqual(self.report()[0], "6 drawn, 0 failed")
        self.assertIn("--array=1-3 ", self.batch("slurm", "jobs.jsonl", "--script", "task.sh", "--tasks", "3"))

    @unittest.skipIf(shutil.which("sbatch"), "there is an sbatch here")
    def test_no_slurm(self):
        self.parts("a.off")
        self.plan(PLAIN)
        self.batch("slurm", "jobs.jsonl", status=1)
        self.refused("install the package slurm-client")


@unittest.skipIf(MISSING, f"slurm-wlm and munge are not installed: {' '.join(MISSING)}")
@unittest.skipUnless(os.geteuid() == 0, "Slurm's daemons are started as root here")
class Slurm(BatchTest):
    def setUp(self):
        super().setUp()
        # Paths of sockets are short.
        scratch = tempfile.TemporaryDirectory(prefix="burin-slurm-", ignore_cleanup_errors=True)
        self.addCleanup(scratch.cleanup)
        self.dir = Path(scratch.name)
        for name in ("state", "spool"):
            (self.dir / name).mkdir()
        (self.dir / "slurm.conf").write_text(CONF.format(dir=self.dir, ports=free_ports(2), cores=os.cpu_count()))
        # From 23.02 on it wants control groups, which a container has none of; older ones know no such word.
        version = subprocess.run(["slurmd", "-V"], capture_output=True, text=True, env={**os.environ, "PATH": os.environ["PATH"] + ":/usr/sbin"})
        if int(re.search(r"(\d+)\.", version.stdout)[1]) >= 23:
            (self.dir / "cgroup.conf").write_text("CgroupPlugin=disabled\n")
        self.env = {**os.environ, "SLURM_CONF": str(self.dir / "slurm.conf"), "PATH": os.environ["PATH"] + ":/usr/sbin"}
        subprocess.run(["mungekey", "-c", "-k", self.dir / "key"], env=self.env, check=True)
        (self.dir / "key").chmod(0o400)
        self.dir.chmod(0o755)
        files = [f"--{what}-file={self.dir / what}" for what in ("key", "pid", "log", "seed")]
        self.daemon("munged", "--foreground", f"--socket={self.dir}/munge.socket", "--force", *files)
        self.wait_for((self.dir / "munge.socket").exists)
        self.daemon("slurmctld", "-D")
        self.daemon("slurmd", "-D", "-N", "localhost")
        self.wait_for(lambda: "idle" in self.slurm("sinfo", "-h", "-o", "%t", check=False))

    def daemon(self, *words):
        with open(self.dir / f"{words[0]}.said", "wb") as log:
            process = subprocess.Popen(words, env=self.env, stdout=log, stderr=log, cwd=self.dir)
        self.addCleanup(end, process)

    def slurm(self, *words, check=True):
        run = subprocess.run(words, env=self.env, capture_output=True, text=True)
        if check:
            self.assertEqual(run.returncode, 0, run.stderr)
        return run.stdout

    def logs(self):
        return "".join(p.read_text() for p in sorted((self.folder / "out/.burin-batch").glob("slurm-*.log")))

    def wait_for_job(self, job):
        """Waits for all tasks, and lets none wait: Slurm holds back what was requeued for two minutes."""
        end_time = time.monotonic() + 150
        while states := self.slurm("squeue", "-h", "-r", "-j", job, "-o", "%i %T %r", check=False).splitlines():
            if time.monotonic() > end_time:
                self.fail(f"{states}\n{self.logs()}")
            for line in states:
                if "BeginTime" in line:
                    self.slurm("scontrol", "update", f"JobId={line.split()[0]}", "StartTime=now", check=False)
            time.sleep(0.5)

    def test_a_task_is_requeued(self):
        self.parts(*(f"slow{n}.off" for n in range(60)))
        self.plan(PLAIN)
        self.run_all()
        told = self.report()
        shutil.rmtree(self.folder / "out")
        said = self.batch("--burin", self.odd(), "slurm", "jobs.jsonl", "--tasks", "3", env=self.env)
        job = re.match(r"job (\d+): 3 tasks, 60 drawings; logs in ", said)[1]
        self.wait_for(lambda: len(self.outputs()) >= 8)
        running = self.slurm("squeue", "-h", "-r", "-t", "R", "-j", job, "-o", "%i").split()
        self.assertTrue(running)
        self.slurm("scontrol", "requeue", running[0])
        time.sleep(1)
        before = self.identities()
        self.assertLess(len(before), 60)
        self.wait_for_job(job)
        self.assertIn("burin: error: cancelled", self.logs())
        now = self.identities()
        self.assertEqual(len(now), 60, self.logs())
        # What was done before the task was requeued was not done again.
        again = [name for name in before if before[name] != now[name]]
        self.assertLessEqual(len(again), len(running))
        self.assertEqual(self.report(), told)

    def test_its_failures_are_told(self):
        self.parts("a.off", "crash.off")
        self.plan(PLAIN)
        self.batch("--burin", self.odd(), "slurm", "jobs.jsonl", "--wait", env=self.env, status=1)
        self.assertIn("failed: parts/crash-iso.svg: crash: was ended by SIGSEGV", self.logs())
        self.assertEqual(self.report()[0], "1 drawn, 1 failed")


if __name__ == "__main__":
    unittest.main()
