"""samples/ci: the templates say what their CI knows, and what they run shows what has changed."""

import importlib.util
import json
import os
import re
import shutil
import subprocess
import unittest
from pathlib import Path

from batch_support import box_off
from git_support import GitTest, off_again

TEMPLATES = Path(os.environ["BURIN_SOURCE_DIR"]) / "samples/ci"
HAVE = importlib.util.find_spec("yaml")
if HAVE:
    import yaml
    from ci_support import Runner, copied, filled, names_in

GITHUB_STEP = {"name", "id", "if", "uses", "with", "run", "shell", "env", "working-directory", "continue-on-error", "timeout-minutes"}
GITHUB_JOB = {"name", "needs", "permissions", "runs-on", "environment", "concurrency", "outputs", "env", "defaults", "if", "steps", "timeout-minutes", "strategy", "container", "services"}
GITLAB_JOB = {"after_script", "allow_failure", "artifacts", "before_script", "cache", "coverage", "environment", "extends", "image", "interruptible", "needs", "parallel", "resource_group", "retry", "rules", "script", "services", "stage", "tags", "timeout", "variables", "when"}
GITLAB_ARTIFACTS = {"access", "exclude", "expire_in", "expose_as", "name", "paths", "public", "reports", "untracked", "when"}
GITLAB_CACHE = {"fallback_keys", "key", "paths", "policy", "unprotect", "untracked", "when"}


def load(name):
    return yaml.safe_load((TEMPLATES / name).read_text())


@unittest.skipUnless(HAVE, "PyYAML is not there: python3-yaml")
class Rules(unittest.TestCase):
    """The main rules of the public schemas of both."""

    def step(self, step, composite):
        self.assertLessEqual(set(step), GITHUB_STEP)
        self.assertEqual(("run" in step) + ("uses" in step), 1, step)
        if "run" in step:
            self.assertEqual("shell" in step, composite, step)
            # What others can choose is no text of the script.
            self.assertEqual(names_in(step["run"]), [])
            check = subprocess.run(["bash", "-n"], input=step["run"], text=True, capture_output=True)
            self.assertEqual(check.stderr, "")
        else:
            self.assertRegex(step["uses"], r"^(\./[\w./-]+|[\w-]+/[\w-]+@v\d+)$")

    def test_action(self):
        action = load("github/action.yml")
        self.assertLessEqual(set(action), {"name", "author", "description", "inputs", "outputs", "runs", "branding"})
        self.assertEqual(action["runs"]["using"], "composite")
        self.assertEqual(set(action["runs"]), {"using", "steps"})
        for entry in action["inputs"].values():
            self.assertLessEqual(set(entry), {"description", "required", "default"})
            self.assertIn("description", entry)
            self.assertTrue(entry.get("required") or "default" in entry)
        for entry in action["outputs"].values():
            self.assertEqual(set(entry), {"description", "value"})
        ids = [step["id"] for step in action["runs"]["steps"] if "id" in step]
        self.assertEqual(len(ids), len(set(ids)))
        for step in action["runs"]["steps"]:
            self.step(step, True)
        for name in names_in((TEMPLATES / "github/action.yml").read_text()):
            top, _, rest = name.partition(".")
            self.assertIn(top, {"inputs", "steps", "github", "cancelled", "contains", "fromJSON"})
            if top == "inputs":
                self.assertIn(rest, action["inputs"])
            if top == "steps":
                self.assertIn(rest.split(".")[0], ids)

    def test_workflow(self):
        workflow = load("github/drawings.yml")
        # YAML 1.1, which PyYAML reads, takes `on` for a truth.
        self.assertEqual({"on" if key is True else key for key in workflow}, {"name", "on", "permissions", "jobs"})
        action = load("github/action.yml")
        for job in workflow["jobs"].values():
            self.assertLessEqual(set(job), GITHUB_JOB)
            self.assertIn("runs-on", job)
            for step in job["steps"]:
                self.step(step, False)
            [ours] = [step for step in job["steps"] if step["uses"].startswith("./")]
            self.assertLessEqual(set(ours["with"]), set(action["inputs"]))
            self.assertLessEqual({name for name, entry in action["inputs"].items() if entry.get("required")}, set(ours["with"]))

    def test_gitlab(self):
        template = load("gitlab/burin.gitlab-ci.yml")
        pipeline = load("gitlab/.gitlab-ci.yml")
        self.assertTrue((TEMPLATES / "gitlab" / pipeline["include"][0]["local"]).is_file())
        jobs = {name: job for source in (template, pipeline) for name, job in source.items() if name != "include"}
        for job in jobs.values():
            self.assertLessEqual(set(job), GITLAB_JOB)
            self.assertTrue("script" in job or job["extends"] in jobs)
            self.assertTrue(all(isinstance(value, str) for value in job.get("variables", {}).values()))
            for line in [*job.get("before_script", []), *job.get("script", [])]:
                # A colon and a space would make a mapping of a line.
                self.assertIsInstance(line, str)
                self.assertEqual(subprocess.run(["sh", "-n"], input=line, text=True, capture_output=True).stderr, "")
        job = template[".burin-book"]
        self.assertLessEqual(set(job["artifacts"]), GITLAB_ARTIFACTS)
        self.assertLessEqual(set(job["cache"]), GITLAB_CACHE)
        self.assertEqual(set(job["image"]), {"name", "entrypoint"})
        # GitLab shows no artifacts in merge requests whose paths are variables.
        self.assertNotIn("$", " ".join(job["artifacts"]["paths"]))
        self.assertEqual(job["allow_failure"], {"exit_codes": [6]})

    def test_the_image_has_what_the_templates_ask_for(self):
        self.assertRegex((Path(os.environ["BURIN_SOURCE_DIR"]) / "Containerfile").read_text(), r"apt-get install[^&]* git ")


class Clones(GitTest):
    """`checkout` is a shallow clone of the newest revision, as a CI makes it."""

    def setUp(self):
        super().setUp()
        self.git("config", "uploadpack.allowAnySHA1InWant", "true")
        self.store = self.folder / "store"
        self.store.mkdir()
        self.checkouts = 0

    def checkout(self):
        self.checkouts += 1
        folder = self.folder / f"checkout-{self.checkouts}"
        self.git("clone", "-q", "--depth=1", f"file://{self.repository}", str(folder))
        return folder

    def look_at(self, folder):
        """What the page shows; all of it is there."""
        page = (folder / "index.html").read_text()
        for name in re.findall(r'src="([^"#]+)"', page):
            self.assertTrue((folder / name).is_file(), name)
        return {f["name"]: f["status"] for f in json.loads((folder / "differences.json").read_text())["figures"]}


CHANGED = {"both": "changed", "same": "same", "styled": "changed", "come": "added", "gone": "removed"}


@unittest.skipUnless(HAVE, "PyYAML is not there: python3-yaml")
class GitHub(Clones):
    def job(self, event, **given):
        """Runs the workflow for an event; the artifact, and what there is to see."""
        folder = self.checkout()
        workflow, action = load("github/drawings.yml"), load("github/action.yml")
        [job] = workflow["jobs"].values()
        sha = self.git("rev-parse", "HEAD", cwd=folder)
        github = {"sha": sha, "event": event, "run_attempt": 1}
        self.runner = Runner(folder, self.env, self.store, {"github": github})
        shutil.rmtree(self.store / "artifacts", ignore_errors=True)

        def use(runner, name, with_):
            if name == "actions/checkout@v4":
                return {}
            self.assertEqual(name, "./.github/actions/burin-book")
            context = {"github": github}
            inputs = {key: filled(str(entry.get("default", "")), context) for key, entry in action["inputs"].items()} | with_ | given
            inner = Runner(folder, self.env, self.store, {"github": github, "inputs": inputs})
            inner.steps(action["runs"]["steps"])
            inner.finish()
            runner.failed |= inner.failed
            runner.summary, runner.said = inner.summary, inner.said
            return {key: filled(entry["value"], inner.context) for key, entry in action["outputs"].items()}

        for step in job["steps"]:
            step.setdefault("id", "ours" if step["uses"].startswith("./") else "other")
        self.runner.steps(job["steps"], use)
        self.outputs_of_action = self.runner.context["steps"]["ours"]["outputs"]
        self.checked_out = folder
        return self.store / "artifacts/drawings"

    def test_a_pull_request(self):
        base = self.first()
        self.second()
        artifact = self.job({"pull_request": {"base": {"sha": base}}})
        self.assertFalse(self.runner.failed, self.runner.said)
        self.assertEqual(self.outputs_of_action, {"status": "6", "page": "https://ci.example/drawings"})
        self.assertEqual(self.look_at(artifact), CHANGED)
        self.assertEqual(self.runner.summary, (artifact / "differences.md").read_text())
        self.assertIn("moved pin: moved by 10 mm (0, 0, 10)", self.runner.summary)
        self.assertFalse((artifact / "old/.burin-batch").exists())
        self.assertFalse((artifact / "new/both.json").exists())
        self.assertTrue((self.checked_out / "manual/figures/both.pdf").is_file())
        # The next run has what this one drew.
        artifact = self.job({"pull_request": {"base": {"sha": base}}})
        self.assertEqual(self.look_at(artifact), CHANGED)
        self.assertEqual(sorted(re.findall(r"^(kept|made)  ", self.runner.said, re.M)), ["kept"] * 4)
        # A job that is to fail where something has changed.
        self.job({"pull_request": {"base": {"sha": base}}}, **{"fail-on": "changed"})
        self.assertTrue(self.runner.failed)

    def test_a_push_that_changes_no_drawing(self):
        base = self.first()
        self.commit(pin__off=off_again((self.manual / "pin.off").read_text()))
        artifact = self.job({"before": base}, **{"fail-on": "changed"})
        self.assertFalse(self.runner.failed, self.runner.said)
        self.assertEqual(self.outputs_of_action["status"], "0")
        self.assertEqual(set(self.look_at(artifact).values()), {"same"})
        self.assertIn("### Drawings of Two boxes: 4 same", self.runner.summary)

    def test_a_new_branch_and_a_run_by_hand(self):
        self.first()
        artifact = self.job({"before": "0" * 40})
        self.assertFalse(self.runner.failed, self.runner.said)
        self.assertEqual(set(self.look_at(artifact).values()), {"added"})
        artifact = self.job({})
        self.assertFalse(self.runner.failed, self.runner.said)
        self.assertFalse(artifact.exists())
        self.assertTrue((self.checked_out / "manual/figures/both.svg").is_file())

    def test_what_fails(self):
        base = self.first()
        self.commit(pin__off="OFF\nnonsense\n")
        artifact = self.job({"before": base})
        self.assertTrue(self.runner.failed)
        self.assertEqual(self.look_at(artifact), {"both": "failed", "same": "failed", "styled": "failed", "gone": "same"})
        self.assertIn("| same | failed | new revision: pin.off", self.runner.summary)
        self.job({"before": "ab" * 20})
        self.assertTrue(self.runner.failed)
        self.assertIn("has no revision 'abab", self.runner.said)
        # No page of another time is handed up.
        self.assertFalse(artifact.exists())
        # The old revision alone is broken: nothing is wrong with the figures of this one.
        broken = self.git("rev-parse", "HEAD")
        self.commit(pin__off=box_off(5, 6, 7))
        artifact = self.job({"before": broken}, **{"fail-on": "never"})
        self.assertFalse(self.runner.failed, self.runner.said)
        self.assertEqual(self.outputs_of_action["status"], "1")

    def test_packages_are_installed_by_name(self):
        base = self.first()
        for name in ("apt-get", "sudo"):
            path = self.folder / "bin" / name
            path.write_text(f'#!/bin/sh\n[ "${{0##*/}}" = sudo ] && exec "$@"\necho "$*" >>"{self.folder}/installed"\n')
            path.chmod(0o755)
        (self.repository / "packages").mkdir()
        for name in ("burin_1_amd64.deb", "python3-burin_1_amd64.deb"):
            (self.repository / "packages" / name).write_text("")
        self.commit()
        self.job({"before": base}, packages="packages/*.deb")
        self.assertFalse(self.runner.failed, self.runner.said)
        folder = self.checked_out.resolve() / "packages"
        self.assertEqual(
            (self.folder / "installed").read_text(),
            f"update\ninstall -y --no-install-recommends git ca-certificates {folder}/burin_1_amd64.deb {folder}/python3-burin_1_amd64.deb\n",
        )


@unittest.skipUnless(HAVE, "PyYAML is not there: python3-yaml")
class GitLab(Clones):
    def job(self, **given):
        """Runs the job; its exit status. What is kept between runs is, and the artifact is `artifact`."""
        folder = self.checkout()
        template, pipeline = load("gitlab/burin.gitlab-ci.yml"), load("gitlab/.gitlab-ci.yml")
        job = pipeline["drawings"]
        base = template[job["extends"]]
        predefined = {"CI_COMMIT_REF_SLUG": "topic", "CI_DEFAULT_BRANCH": "main"}
        variables = {**predefined, **base["variables"], **job["variables"], **given}

        def named(text):
            return re.sub(r"\$(\w+)", lambda m: variables[m[1]], text)

        cache, paths = self.store / named(base["cache"]["key"]), [named(path) for path in base["cache"]["paths"]]
        copied(cache, folder)
        script = "\n".join(["set -eo pipefail", *base["before_script"], *base["script"]])
        run = subprocess.run(["bash", "-c", script], cwd=folder, env={**self.env, **variables}, capture_output=True, text=True)
        for path in paths:
            copied(folder / path, cache / path)
        [artifact] = base["artifacts"]["paths"]
        self.artifact, self.said, self.folder_of_job = folder / artifact, run.stdout + run.stderr, folder
        self.warns = run.returncode in base["allow_failure"]["exit_codes"]
        return run.returncode

    def test_a_merge_request(self):
        base = self.first()
        self.second()
        given = {"CI_MERGE_REQUEST_DIFF_BASE_SHA": base, "CI_COMMIT_BEFORE_SHA": "0" * 40}
        self.assertEqual(self.job(**given), 6, self.said)
        self.assertTrue(self.warns)
        self.assertEqual(self.look_at(self.artifact), CHANGED)
        self.assertIn("moved pin: moved by 10 mm", (self.artifact / "differences.md").read_text())
        self.assertTrue((self.folder_of_job / "figures/both.pdf").is_file())
        self.assertEqual(self.job(**given), 6, self.said)
        self.assertEqual(sorted(re.findall(r"^(kept|made)  ", self.said, re.M)), ["kept"] * 4)

    def test_a_branch(self):
        base = self.first()
        self.commit(pin__off=off_again((self.manual / "pin.off").read_text()))
        self.assertEqual(self.job(CI_COMMIT_BEFORE_SHA=base), 0, self.said)
        self.assertEqual(set(self.look_at(self.artifact).values()), {"same"})
        self.assertEqual(self.job(CI_COMMIT_BEFORE_SHA="0" * 40), 6, self.said)
        self.assertEqual(set(self.look_at(self.artifact).values()), {"added"})

    def test_what_fails(self):
        base = self.first()
        self.commit(pin__off="OFF\nnonsense\n")
        self.assertEqual(self.job(CI_COMMIT_BEFORE_SHA=base), 1, self.said)
        self.assertFalse(self.warns)
        self.assertEqual(self.look_at(self.artifact)["same"], "failed")


if __name__ == "__main__":
    unittest.main()
