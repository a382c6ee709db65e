"""Runs what the files of a CI say, as the CI does: steps of GitHub's actions and workflows, scripts of GitLab."""

import json
import os
import re
import shutil
import subprocess
from pathlib import Path

_FUNCTIONS = {"cancelled": lambda: False, "always": lambda: True, "fromJSON": json.loads, "contains": lambda many, one: one in many}
_TOKENS = re.compile(r"\s*(?:('(?:[^']|'')*')|(\|\||&&|==|!=|!|\(|\)|,)|([A-Za-z_][\w-]*(?:\.[A-Za-z_*][\w-]*)*)|(-?\d+(?:\.\d+)?))")


def expression(text, context):
    """The value of an expression of GitHub: names, texts, || && == != ! and parentheses, and some functions."""
    words = []
    at = 0
    text = text.strip()
    while at < len(text):
        match = _TOKENS.match(text, at)
        if not match:
            raise ValueError(f"no expression: {text!r} at {at}")
        at = match.end()
        if match[1]:
            words.append(repr(match[1][1:-1].replace("''", "'")))
        elif match[2]:
            words.append({"||": " or ", "&&": " and ", "!": " not "}.get(match[2], match[2]))
        elif match[3] in _FUNCTIONS:
            words.append(match[3])
        elif match[3]:
            words.append(f"look({match[3]!r})")
        else:
            words.append(match[4])
    value = eval("".join(words), {"look": lambda name: look(context, name), **_FUNCTIONS})
    return "" if value is None else value


def look(context, name):
    """A name with dots; empty where there is none, as GitHub has it."""
    value = context
    for key in name.split("."):
        value = value.get(key) if isinstance(value, dict) else None
    return "" if value is None else value


def filled(text, context):
    """A text with its `${{ }}`."""
    return re.sub(r"\$\{\{(.*?)\}\}", lambda match: str(expression(match[1], context)), text)


def names_in(text):
    """All names that the expressions of a text look at."""
    return [match[3] for part in re.findall(r"\$\{\{(.*?)\}\}", text, re.S) for match in _TOKENS.finditer(part) if match[3]]


class Runner:
    """One job of GitHub in a work tree. `store` stands for its caches and artifacts."""

    def __init__(self, folder, env, store, context):
        self.folder, self.env, self.store, self.context = folder, env, store, {"steps": {}, **context}
        self.failed = False
        self.said = ""
        self.summary = ""

    def steps(self, steps, use=None):
        """Runs steps; `use` does what others' actions do, with (runner, name, with)."""
        for number, step in enumerate(steps):
            condition = str(step.get("if", ""))
            own = any(f"{word}()" in condition for word in ("always", "cancelled", "failure"))
            condition = re.sub(r"^\$\{\{(.*)\}\}$", r"\1", condition.strip(), flags=re.S)
            if (self.failed and not own) or (condition and not expression(condition, self.context)):
                continue
            if "uses" in step:
                given = {key: filled(value, self.context) if isinstance(value, str) else value for key, value in step.get("with", {}).items()}
                outputs = (use or actions)(self, step["uses"], given) or {}
            else:
                outputs = self.run(step, number)
            if "id" in step:
                self.context["steps"][step["id"]] = {"outputs": outputs}

    def run(self, step, number):
        files = {name: self.store / f"{name}-{number}" for name in ("GITHUB_OUTPUT", "GITHUB_STEP_SUMMARY")}
        for path in files.values():
            path.write_text("")
        env = {key: filled(str(value), self.context) for key, value in step.get("env", {}).items()}
        script = self.store / "step.sh"
        script.write_text(filled(step["run"], self.context))
        words = ["bash", "--noprofile", "--norc", "-e", "-o", "pipefail", str(script)]
        run = subprocess.run(words, cwd=self.folder, env={**self.env, **env, **{n: str(p) for n, p in files.items()}}, capture_output=True, text=True)
        self.said += run.stdout + run.stderr
        self.failed |= run.returncode != 0
        self.summary += files["GITHUB_STEP_SUMMARY"].read_text()
        return dict(line.split("=", 1) for line in files["GITHUB_OUTPUT"].read_text().splitlines())

    def finish(self):
        """What an action does after all steps: caches are kept."""
        for key, paths in getattr(self, "kept", []):
            save(self.folder, paths, self.store / "cache" / key)


def copied(source, target, hidden=True):
    """Copies what lies below a folder into another one."""
    for folder, folders, names in os.walk(source):
        folders[:] = [name for name in folders if hidden or not name.startswith(".")]
        for name in names:
            if hidden or not name.startswith("."):
                path = Path(folder) / name
                (target / path.relative_to(source)).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(path, target / path.relative_to(source))


def save(folder, paths, target):
    for path in paths:
        copied(folder / path, target / path)


def actions(runner, name, given):
    """What actions/cache, upload-artifact and download-artifact do, over folders."""
    store = runner.store
    if name == "actions/cache@v4":
        paths = given["path"].split()
        caches = [*(store / "cache").glob("*")] if (store / "cache").is_dir() else []
        keys = [given["key"], *given.get("restore-keys", "").split("\n")]
        key = safe(given["key"])
        found = [c for k in keys if k for c in sorted(caches, key=lambda c: c.stat().st_mtime_ns, reverse=True) if c.name.startswith(safe(k.strip()))]
        if found:
            copied(found[0], runner.folder)
        runner.kept = [*getattr(runner, "kept", []), (key, paths)]
        return {"cache-hit": str(bool(found))}
    if name == "actions/upload-artifact@v4":
        path, *without = given["path"].split("\n")
        target = store / "artifacts" / given["name"]
        copied(runner.folder / path.strip(), target, given.get("include-hidden-files") in (True, "true"))
        for pattern in (line.strip() for line in without if line.strip()):
            assert pattern.startswith(f"!{path.strip()}/"), pattern
            for file in target.glob(pattern[len(path.strip()) + 2 :]):
                file.unlink()
        return {"artifact-url": f"https://ci.example/{given['name']}"}
    if name == "actions/download-artifact@v4":
        assert given.get("merge-multiple") in (True, "true"), given
        for folder in sorted((store / "artifacts").glob(given["pattern"])):
            copied(folder, runner.folder / given["path"])
        return {}
    raise AssertionError(f"the tests do not know the action {name}")


def safe(key):
    return key.replace("/", "_")
