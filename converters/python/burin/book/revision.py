"""An older revision of a book, out of the Git repository that it lies in.

The tree is checked out as a work tree of that repository (`git worktree`), so that filters (Git LFS) run and objects that are
there already serve. Submodules are work trees of those that are checked out here, where they have the commit; else Git fetches
them. All of it is gone afterwards.
"""

import contextlib
import dataclasses
import os
import re
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path

from burin.batch.child import run_to_end
from burin.batch.errors import USAGE, BatchError

# What a push that makes a branch says was there before.
_NOTHING = re.compile("0{40}|0{64}")
# Set by Git for its hooks; they would lead all that follows to one repository.
_LEADING = ("GIT_DIR", "GIT_WORK_TREE", "GIT_INDEX_FILE", "GIT_PREFIX")


@dataclasses.dataclass
class OldBook:
    """The book as it was."""

    # None where there was none.
    path: Path | None
    # The revision in words.
    words: str
    # What a user should know of the tree.
    notes: list[str]


class _Git:
    def __init__(self, cancelled: Callable[[], bool]) -> None:
        self.cancelled = cancelled
        self.env = {k: v for k, v in os.environ.items() if k not in _LEADING} | {"GIT_TERMINAL_PROMPT": "0", "LC_ALL": "C.UTF-8"}

    def run(self, folder: Path, *words: str, **env: str) -> tuple[int, str, str]:
        try:
            return run_to_end(["git", "-c", f"core.hooksPath={os.devnull}", *words], folder, None, self.cancelled, self.env | env)
        except OSError as e:
            raise BatchError(f"option --since needs git ({e.strerror}); install the package git", USAGE) from e

    def ask(self, folder: Path, *words: str) -> str | None:
        status, said, _ = self.run(folder, *words)
        return said if status == 0 else None


@contextlib.contextmanager
def old_book(book: Path, since: str, cancelled: Callable[[], bool]) -> Iterator[OldBook]:
    """The book at REV, or at REV:PATH where it had another name, from the top of the repository. Throws BatchError."""
    revision, colon, name = since.partition(":")
    if _NOTHING.fullmatch(revision):
        yield OldBook(None, "nothing", ["there was no revision before"])
        return
    git = _Git(cancelled)
    here = book.resolve().parent
    status, said, errors = git.run(here, "rev-parse", "--show-toplevel")
    if status:
        raise BatchError(f"option --since: {book} lies in no repository of Git ({_last(errors)}); --compare OLD.toml takes any folder", USAGE)
    top = Path(said.rstrip("\n")).resolve()
    commit = (git.ask(top, "rev-parse", "--verify", "--quiet", "--end-of-options", f"{revision}^{{commit}}") or "").strip()
    if not commit:
        words = f"option --since: {top} has no revision '{revision}'; a shallow clone lacks older ones"
        raise BatchError(f"{words}: git fetch --depth=1 origin {revision}", USAGE)
    path = name if colon and name else os.path.relpath(book.resolve(), top)
    short = (git.ask(top, "rev-parse", "--short", commit) or commit).strip()
    with _tree(git, top, commit) as (folder, notes):
        found = folder / path
        if not found.is_file():
            if colon:
                raise BatchError(f"option --since: there is no file '{name}' in {revision}", USAGE)
            notes.append(f"there was no {path} in {revision}; a book that had another name is named by --since {revision}:PATH")
        yield OldBook(found if found.is_file() else None, short if commit.startswith(revision) else f"{revision} ({short})", notes)


@contextlib.contextmanager
def _tree(git: _Git, top: Path, commit: str) -> Iterator[tuple[Path, list[str]]]:
    notes: list[str] = []
    made: list[tuple[Path, Path]] = []
    with tempfile.TemporaryDirectory(prefix="burin-since-") as scratch:
        folder = Path(scratch).resolve() / "tree"
        try:
            _check_out(git, top, commit, folder, "", notes, made)
            yield folder, notes
        finally:
            # Also where we are cancelled; submodules first.
            last = _Git(lambda: False)
            for repository, tree in reversed(made):
                last.run(repository, "worktree", "remove", "--force", "--force", str(tree))


def _check_out(git: _Git, repository: Path, commit: str, folder: Path, name: str, notes: list[str], made: list[tuple[Path, Path]]) -> None:
    words = ("worktree", "add", "--force", "--detach", str(folder), commit)
    made.append((repository, folder))
    status, _, errors = git.run(repository, *words)
    if status:
        # One file that Git LFS cannot get fails all; so it is a pointer, and only what shows it fails.
        git.run(repository, "worktree", "remove", "--force", "--force", str(folder))
        status, _, _ = git.run(repository, *words, GIT_LFS_SKIP_SMUDGE="1")
        if status:
            raise BatchError(f"option --since: {commit[:12]} cannot be checked out: {_last(errors)}")
        notes.append(f"files of Git LFS are missing: {_last(errors)}")
    for entry in (git.ask(folder, "ls-tree", "-r", "-z", commit) or "").split("\0"):
        head, _, path = entry.partition("\t")
        if head.startswith("160000 "):
            _submodule(git, repository / path, head.split()[2], folder, path, f"{name}{path}", notes, made)


def _submodule(
    git: _Git, here: Path, commit: str, tree: Path, path: str, name: str, notes: list[str], made: list[tuple[Path, Path]]
) -> None:
    top = git.ask(here, "rev-parse", "--show-toplevel") if here.is_dir() else None
    if top and Path(top.rstrip("\n")).resolve() == here.resolve() and git.ask(here, "cat-file", "-e", f"{commit}^{{commit}}") is not None:
        _check_out(git, here, commit, tree / path, f"{name}/", notes, made)
        return
    status, _, errors = git.run(tree, "submodule", "update", "--init", "--recursive", "--", path)
    if status:
        notes.append(f"the submodule {name} is missing: {_last(errors)}")


def _last(errors: str) -> str:
    lines = [line.strip() for line in errors.splitlines() if line.strip()]
    return re.sub(r"^(fatal|error): ", "", lines[-1]) if lines else "git gave no message"
