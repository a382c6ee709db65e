"""Pages of the manual that stand apart from the sources."""
import re

LINK = re.compile(r"(!?)\[([^\]]*)\]\(([^)\s#]*)(#[^)\s]*)?\)")


def keep_links_inside(folder):
    """Links of the pages in a folder lead to what is there, by its name alone where pages of several folders became neighbours.
    Those to files of the sources become their words; pictures that are not there go."""
    for page in sorted(folder.glob("*.md")):
        def kept(link, page=page):
            picture, words, path, place = link.groups(default="")
            if "://" in path or path.startswith("mailto:") or (not path and place) or (page.parent / path).exists():
                return link[0]
            name = path.rpartition("/")[2]
            if name.endswith(".md") and name != "README.md" and (folder / name).exists():
                return f"[{words}]({name}{place})"
            return "" if picture else words

        text = page.read_text(encoding="utf-8")
        # The innermost first: a picture may be the words of a link.
        changed = LINK.sub(kept, text)
        page.write_text(changed, encoding="utf-8")
