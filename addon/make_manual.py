"""The manual that the zip brings: pages of HTML from addon/manual, sections of the README and their pictures.

A page is Markdown. On a separate line it may say

    <!-- README: A section -->       to have the text of that section of the README here
    <!-- F1: a b.c* -->              below a heading: F1 over these leads to it. a is an operator of the add-on, b.c a property
                                     of a class, b alone a panel or menu; * stands for anything
"""

import argparse
import html
import io
import json
import re
from pathlib import Path

from markdown_it import MarkdownIt
from PIL import Image

PROJECT = Path(__file__).resolve().parent.parent
SOURCE = PROJECT / "addon/manual"
#: In the order in which they are read.
PAGES = ("index", "five-minutes", "workflows", "choosing", "tools", "keyboard", "nets", "curves", "surfaces", "modify", "continuity",
         "seeing", "following", "animation", "shapes", "teaching", "lectures", "files", "python", "preferences", "performance", "troubleshooting")
#: Files that the README links and the add-on brings, by where they lie in the project.
_BROUGHT = {"LICENSE": "../LICENSE", "addon/splinewright/CHANGELOG.md": "../CHANGELOG.md"}
#: Pictures are no wider, in pixels, and as good as this, of 100.
_WIDTH, _QUALITY = 960, 80


class Broken(ValueError):
    """A page links a target that is not there."""


def content():
    """[(path inside the manual, bytes)]."""
    manual = _Manual()
    made = {name: manual.page(name) for name in PAGES}
    for name, text in made.items():
        _require_links(name, text, made)
    return [*((f"{name}.html", text.encode()) for name, text in made.items()),
            *((path, _picture(source)) for path, source in sorted(manual.pictures.items())),
            ("style.css", (SOURCE / "style.css").read_bytes()),
            ("f1.json", json.dumps(manual.map, indent=0).encode())]


class _Manual:
    """The contents gathered while pages are made."""

    def __init__(self):
        self.readme = (PROJECT / "README.md").read_text()
        self.titles = {name: _title(_source(name)) for name in PAGES}
        self.pictures, self.map = {}, []

    def page(self, name):
        """One page as HTML."""
        markdown = MarkdownIt('commonmark').enable('table')
        text = re.sub(r"^<!-- README: (.+) -->$", lambda found: section(self.readme, found[1]), _source(name), flags=re.M)
        tokens = markdown.parse(text)
        headings = self._settle(name, tokens)
        body = markdown.renderer.render(tokens, markdown.options, {})
        return _TEMPLATE.format(title=html.escape(self.titles[name]), body=body, contents=self._contents(name, headings))

    def _settle(self, name, tokens):
        """Give headings anchors and links and pictures the addresses they have in the manual; [(anchor, heading)] of parts."""
        headings, anchor = [], ""
        for i, token in enumerate(tokens):
            if token.type == 'heading_open':
                anchor = _anchor(tokens[i + 1].content)
                token.attrSet('id', anchor)
                if token.tag == 'h2':
                    headings.append((anchor, _plain(tokens[i + 1])))
            elif token.type == 'html_block':
                names = re.fullmatch(r"<!-- F1: (.+) -->", token.content.strip(), re.S)
                if not names:
                    raise Broken(f"{name}: what does {token.content.strip()} mean?")
                self.map += [(_of_blender(each), f"{name}.html#{anchor}") for each in names[1].split()]
                token.content = ""
            for child in token.children or ():
                self._settle_inline(child)
        return headings

    def _settle_inline(self, token):
        if token.type == 'image':
            source = next((path for folder in (PROJECT, SOURCE) if (path := (folder / token.attrs['src'])).is_file()), None)
            if source is None:
                raise Broken(f"there is no picture {token.attrs['src']}")
            source = source.resolve()
            path = f"pictures/{source.stem}.webp"
            if self.pictures.setdefault(path, source) != source:
                raise Broken(f"two pictures are called {source.stem}")
            token.attrs['src'] = path
            token.attrSet('loading', 'lazy')
        elif token.type == 'link_open':
            target = token.attrs['href']
            page, _, anchor = target.partition("#")
            if page.endswith(".md") and page[:-3] in PAGES:
                token.attrs['href'] = f"{page[:-3]}.html" + (f"#{anchor}" if anchor else "")
            elif target in _BROUGHT:
                token.attrs['href'] = _BROUGHT[target]
            elif "://" not in target and not target.startswith("#"):
                del token.attrs['href']         # what lies in the project and not in the add-on

    def _contents(self, name, headings):
        lines = []
        for other in PAGES:
            here = ' aria-current="page"' if other == name else ""
            lines.append(f'<li><a href="{other}.html"{here}>{html.escape(self.titles[other])}</a>')
            if other == name and len(headings) > 1:
                parts = "".join(f'<li><a href="#{anchor}">{html.escape(text)}</a></li>' for anchor, text in headings)
                lines.append(f"<ul>{parts}</ul>")
            lines.append("</li>")
        return "\n".join(lines)


def _source(name):
    return (SOURCE / f"{name}.md").read_text()


def _title(text):
    return re.match(r"# (.+)", text)[1]


def section(readme, title):
    """The text below a heading of the README, up to the next one of its rank."""
    found = re.search(rf"^## {re.escape(title)}\n(.*?)(?=^## |\Z)", readme, re.S | re.M)
    if not found:
        raise Broken(f"the README has no section {title}")
    return found[1]


def _anchor(text):
    return re.sub(r"[^a-z0-9]+", "-", text.lower()).strip("-")


def _plain(inline):
    return "".join(child.content for child in inline.children)


def _of_blender(name):
    """Blender's name for what a page calls by a short one; it looks them up in small letters."""
    is_class = "." in name or re.match(r"SPLINEWRIGHT_[A-Z]T_", name)
    return (f"bpy.types.{name}" if is_class else f"bpy.ops.splinewright.{name}").lower()


def _picture(source):
    """A picture as small as it may be shown."""
    with Image.open(source) as picture:
        picture = picture.convert('RGB')
        if picture.width > _WIDTH:
            picture = picture.resize((_WIDTH, round(picture.height * _WIDTH / picture.width)), Image.LANCZOS)
        made = io.BytesIO()
        picture.save(made, 'WEBP', quality=_QUALITY, method=6)
        return made.getvalue()


def _require_links(name, text, made):
    """Raises Broken unless every page and anchor that a page links is there."""
    for target in re.findall(r'href="([^":]*)"', text):
        page, _, anchor = target.partition("#")
        if page.endswith(".html") or not page:
            linked = made.get(page[:-5], "") if page else text
            if not linked or (anchor and f'id="{anchor}"' not in linked):
                raise Broken(f"{name} links {target}, which is not there")


_TEMPLATE = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title} · Splinewright</title>
<link rel="stylesheet" href="style.css">
</head>
<body>
<nav>
<ul>
{contents}
</ul>
</nav>
<main>
{body}</main>
</body>
</html>
"""


def main():
    parser = argparse.ArgumentParser(description="Write the manual into a folder, to look at it.")
    parser.add_argument("folder", type=Path)
    folder = parser.parse_args().folder
    for path, data in content():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_bytes(data)
    print((folder / "index.html").resolve().as_uri())


if __name__ == "__main__":
    main()
