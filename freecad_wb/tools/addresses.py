#!/usr/bin/env python3
"""addresses.py ADDRESS [BRANCH]: writes the public address of the repository, and those of its page, its issues and its manual, into
both package.xml, in place of those that are there. BRANCH is `main` where it is not said. Which addresses a site has follows from
its name: those of GitLab and of Forgejo (Codeberg) differ from GitHub's, which stand for all others."""
import pathlib
import re
import sys
import urllib.parse
from xml.sax.saxutils import escape, quoteattr

ROOT = pathlib.Path(__file__).resolve().parents[2]
FILES = (ROOT / "package.xml", ROOT / "freecad_wb/package.xml")


def addresses(repository, branch):
    """[(type, address)] as FreeCAD's index of add-ons wants them."""
    host = urllib.parse.urlsplit(repository).hostname
    source, issues = "blob/", "issues"
    if "gitlab" in host:
        source, issues = "-/blob/", "-/issues"
    elif any(name in host for name in ("codeberg", "forgejo", "gitea")):
        source = "src/branch/"
    page = f"{repository}/{source}{branch}/"
    return [("repository", repository), ("readme", page + "freecad_wb/docs/README.md"), ("bugtracker", f"{repository}/{issues}"),
            ("documentation", page + "kernel/docs/freecad.md")]


def written(text, urls, branch):
    """The text of a package.xml with these addresses; none of those before is left."""
    text = re.sub(r" *<url .*</url>\n", "", text)
    lines = ""
    for kind, address in urls:
        of_branch = f" branch={quoteattr(branch)}" if kind == "repository" else ""
        lines += f'  <url type="{kind}"{of_branch}>{escape(address)}</url>\n'
    return text.replace("  <icon>", lines + "  <icon>", 1)


def main(words):
    if not 1 <= len(words) <= 2:
        sys.exit(__doc__)
    repository, branch = words[0].rstrip("/").removesuffix(".git"), (words[1:] or ["main"])[0]
    if not re.fullmatch(r"https?://[^/\s]+/\S+", repository):
        sys.exit(f"addresses.py: {words[0]} is no address of a repository, such as https://HOST/OWNER/NAME")
    for file in FILES:
        file.write_text(written(file.read_text(encoding="utf-8"), addresses(repository, branch), branch), encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
