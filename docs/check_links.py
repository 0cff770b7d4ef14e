"""Whether every link and picture of a built site is there, anchors included: check_links.py FOLDER"""

import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote


class Page(HTMLParser):
    """What a page links, and what in it can be linked."""

    def __init__(self, text):
        super().__init__()
        self.links, self.anchors = [], set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name == "id" or (tag == "a" and name == "name"):
                self.anchors.add(value)
            elif name in ("href", "src") and value:
                self.links.append(value)


def broken(folder):
    """Lines on what is not there."""
    pages = {path: Page(path.read_text(encoding="utf-8")) for path in sorted(folder.rglob("*.html"))}
    for path, page in pages.items():
        for link in page.links:
            target, _, anchor = unquote(link).partition("#")
            if "://" in target or target.startswith(("data:", "mailto:")):
                continue
            place = (path.parent / target.partition("?")[0]).resolve() if target else path
            if place.is_dir():
                place /= "index.html"
            if not place.exists():
                yield f"{path.relative_to(folder)} links {target}, which is not there"
            elif anchor and place in pages and anchor not in pages[place].anchors:
                yield f"{path.relative_to(folder)} links {link}: there is no such anchor"


def main(folder):
    found = list(broken(folder.resolve()))
    for line in found:
        print(line)
    count = len(list(folder.rglob("*.html")))
    print(f"{count} pages, {len(found)} broken links")
    return 1 if found or not count else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
