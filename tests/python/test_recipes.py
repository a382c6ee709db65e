"""The recipes of kernel/docs/catalogues.md for more machines: what stands there is run, and gives the hash of a serial run."""

import importlib.util
import os
import re
import shutil
import subprocess
import unittest
from pathlib import Path

from batch_support import COMMAND, BatchTest

HAVE = importlib.util.find_spec("yaml")
if HAVE:
    import yaml
    from ci_support import Runner

PAGE = (Path(os.environ["BURIN_SOURCE_DIR"]) / "kernel/docs/catalogues.md").read_text()
CATALOGUE = 'views = ["front", "iso"]\n[[parts]]\nfiles = ["parts/*"]\nstyles = ["outline"]\n'

# Stands for ssh: a machine that sees the same folders is this one. As there all words make one line for a shell, and SHELL
# names the user's, which sshd always sets: GNU parallel starts nothing where it is missing.
SSH = """#!/bin/sh
while [ "${1#-}" != "$1" ]; do shift; done
echo "$1" >>"$HOSTS"
shift
[ "$1" != -- ] || shift
SHELL=/bin/sh exec sh -c "$*"
"""


def after(heading):
    """The code block that follows a heading of the page: indented, or between fences."""
    text = PAGE[PAGE.index(f"**{heading}") :]
    fenced = re.search(r"^```\w*\n(.*?)^```", text, re.S | re.M)
    indented = re.search(r"\n\n((?:    .*\n)+)", text)
    first = min((m for m in (fenced, indented) if m), key=lambda m: m.start())
    return re.sub(r"^    ", "", first[1], flags=re.M) if first is indented else first[1]


class Recipe(BatchTest):
    def setUp(self):
        super().setUp()
        self.parts("a.off", "b.off", "c.off", "d.off", "e.off")
        (self.folder / "parts/broken.off").write_text("OFF\nnonsense\n")
        (self.folder / "catalogue.toml").write_text(CATALOGUE)
        self.env = {k: v for k, v in os.environ.items() if not k.startswith(("PARALLEL", "GITHUB_"))}
        (self.folder / "bin").mkdir()
        (self.folder / "bin/burin").write_text(f'#!/bin/sh\nexec "{COMMAND}" "$@"\n')
        (self.folder / "bin/burin").chmod(0o755)
        self.env |= {"PATH": f"{self.folder}/bin:{os.environ['PATH']}", "HOME": str(self.folder), "BURIN_COMMAND": COMMAND}

    def serial(self):
        """What a run on this machine reports, elsewhere."""
        here, self.folder = self.folder, self.folder / "serial"
        shutil.copytree(here / "parts", self.folder / "parts")
        self.plan(CATALOGUE)
        self.run_all("--jobs", "1", status=1)
        told = self.report()
        self.folder = here
        self.assertEqual(told[0], "10 drawn, 2 failed")
        return told

    def test_gnu_parallel(self):
        version = subprocess.run(["parallel", "--version"], capture_output=True, text=True).stdout if shutil.which("parallel") else ""
        if "GNU" not in version:
            self.skipTest("GNU parallel is not there: parallel")
        (self.folder / "bin/ssh").write_text(SSH)
        (self.folder / "bin/ssh").chmod(0o755)
        line = after("GNU parallel")
        self.assertTrue(line.startswith("parallel --sshlogin a,b,c "), line)
        self.plan(CATALOGUE)
        env = {**self.env, "HOSTS": str(self.folder / "hosts")}
        run = subprocess.run(["bash", "-e", "-c", line], cwd=self.folder, env=env, capture_output=True, text=True)
        # As many as have failed drawings.
        self.assertEqual(run.returncode, 1, run.stderr)
        self.assertEqual(len(re.findall("failed: broken-|failed: parts/broken-", run.stderr)), 2, run.stderr)
        self.assertEqual(set((self.folder / "hosts").read_text().split()), {"a", "b", "c"})
        self.assertEqual(self.report(), self.serial())

    @unittest.skipUnless(HAVE, "PyYAML is not there: python3-yaml")
    def test_a_matrix_in_ci(self):
        jobs = yaml.safe_load(after("A matrix in CI"))["jobs"]
        store = self.folder / "store"
        store.mkdir()
        shards = jobs["draw"]["strategy"]["matrix"]["shard"]
        said = ""
        self.assertEqual(len(shards), 4)
        for attempt in ("one", "two"):
            shutil.rmtree(store / "artifacts", ignore_errors=True)
            for shard in shards:
                runner = self.runner(f"{attempt}-{shard}", store, {"matrix": {"shard": shard}, "github": {"sha": attempt}})
                runner.steps(jobs["draw"]["steps"])
                runner.finish()
                said += runner.said if attempt == "two" else ""
                # One that has the part that fails hands up what it drew, too.
                self.assertFalse(runner.failed, runner.said)
        self.assertEqual(jobs["report"]["needs"], "draw")
        # What the first runs drew the second ones did not.
        self.assertEqual(sum(map(int, re.findall(r"(\d+) of them were done", said))), 10)
        runner = self.runner("report", store, {"github": {"sha": "two"}})
        runner.steps(jobs["report"]["steps"])
        self.assertIn(f"hash {self.serial()[1]}\n", runner.said)
        self.assertIn("12 of 12 drawings, 10 of them were done, 2 failed; 0.0 s of drawing", runner.said)
        self.assertTrue(runner.failed)
        self.assertTrue((runner.folder / "out/index.html").is_file())

    def runner(self, name, store, context):
        folder = self.folder / "jobs" / name
        shutil.copytree(self.folder / "parts", folder / "parts")
        (folder / "catalogue.toml").write_text(CATALOGUE)
        return Runner(folder, self.env, store, context)

    @unittest.skipUnless(HAVE, "PyYAML is not there: python3-yaml")
    def test_kubernetes(self):
        # Fewer pods, so that most have something to draw.
        text = after("Kubernetes").replace("64", "4")
        job = yaml.safe_load(text)
        self.assertEqual((job["apiVersion"], job["kind"]), ("batch/v1", "Job"))
        self.assertRegex(job["metadata"]["name"], r"^[a-z0-9]([-a-z0-9]*[a-z0-9])?$")
        spec = job["spec"]
        self.assertLessEqual(set(spec), {"completions", "parallelism", "completionMode", "backoffLimit", "template", "ttlSecondsAfterFinished", "activeDeadlineSeconds"})
        self.assertEqual((spec["completions"], spec["completionMode"]), (4, "Indexed"))
        pod = spec["template"]["spec"]
        self.assertIn(pod["restartPolicy"], ("OnFailure", "Never"))
        [container] = pod["containers"]
        self.assertLessEqual(set(container), {"name", "image", "command", "args", "env", "resources", "volumeMounts", "workingDir"})
        [mount] = container["volumeMounts"]
        self.assertIn(mount["name"], [volume["name"] for volume in pod["volumes"]])
        self.plan(CATALOGUE)
        drawn = 0
        for index in reversed(range(spec["completions"])):
            command = [word.replace(f"{mount['mountPath']}/", f"{self.folder}/") for word in container["command"]]
            run = subprocess.run(command, env={**self.env, "JOB_COMPLETION_INDEX": str(index)}, capture_output=True, text=True)
            # A pod that draws all but what cannot be is not begun anew.
            self.assertEqual(run.returncode, 0, run.stderr)
            drawn += int(re.search(r"(\d+) of \1 drawings", run.stderr)[1])
        self.assertEqual(drawn, 12)
        self.assertEqual(self.report(), self.serial())
        run = subprocess.run([*command[:-1], command[-1].replace("jobs.jsonl", "none.jsonl")], env={**self.env, "JOB_COMPLETION_INDEX": "0"}, capture_output=True)
        self.assertNotEqual(run.returncode, 0)


if __name__ == "__main__":
    unittest.main()
