"""Pages of the manual that stand apart from the sources."""
import re

LINK = re.compile(r"(!?)\[([^\]]*)\]\(([^)\s#]*)(#[^)\s]*)?\)")


def keep_links_inside(folder):
    """Links of the pages in a folder lead to what is there, by its name alone where pages of several folders became neighbours.
    Those to files of the sources become their words; pictures that are not there go."""
    def kept(link):
        picture, words, path, place = link.groups(default="")
        if "://" in path or path.startswith("mailto:") or (not path and place) or (folder / path).exists():
            return link[0]
        name = path.rpartition("/")[2]
        if name.endswith(".md") and name != "README.md" and (folder / name).exists():
            return f"[{words}]({name}{place})"
        return "" if picture else words

    for page in folder.glob("*.md"):
        page.write_text(LINK.sub(kept, page.read_text(encoding="utf-8")), encoding="utf-8")
