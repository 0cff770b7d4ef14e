"""The manual that the zip brings: pages of HTML from addon/manual, in all languages, sections of the README and their pictures.

A page is Markdown. On a separate line it may say

    <!-- README: A section -->       to have the text of that section of the README here
    <!-- F1: a b.c* -->              below a heading: F1 over these leads to it. a is an operator of the add-on, b.c a property
                                     of a class, b alone a panel or menu; * stands for anything
"""

import argparse
import functools
import html
import io
import json
import posixpath
import re
from pathlib import Path
from urllib.parse import unquote

from manual_pages import ENGLISH, IN_ENGLISH, LANGUAGES, PAGES, PROJECT, SOURCE, Broken, address, languages_of, path, text, title
from markdown_it import MarkdownIt
from PIL import Image

#: Files that the README links and the add-on brings, by where they lie in the project.
_BROUGHT = {"LICENSE": "../LICENSE", "addon/splinewright/CHANGELOG.md": "../CHANGELOG.md"}
#: Pictures are no wider, in pixels, and as good as this, of 100.
_WIDTH, _QUALITY = 960, 80


def content():
    """[(path inside the manual, bytes)]."""
    manual = _Manual()
    made = {address(name, language): manual.page(name, language) for name in PAGES for language in languages_of(name)}
    for name, page in made.items():
        _require_links(name, page, made)
    return [*((f"{name}.html", page.encode()) for name, page in made.items()),
            *((place, _picture(source)) for place, source in sorted(manual.pictures.items())),
            ("style.css", (SOURCE / "style.css").read_bytes()),
            ("f1.json", json.dumps(manual.map, indent=0).encode())]


class _Manual:
    """The contents gathered while pages are made."""

    def __init__(self):
        self.pictures, self.map = {}, []
        self.anchors = functools.cache(_anchors)

    def page(self, name, language=ENGLISH):
        """One page as HTML."""
        markdown = _parser()
        tokens = markdown.parse(text(name, language))
        headings = self._settle(name, language, tokens)
        body = markdown.renderer.render(tokens, markdown.options, {})
        return _TEMPLATE.format(title=html.escape(title(name, language)), body=body, language=language, root=_root(language),
                                languages=_languages(name, language), contents=_contents(name, language, headings))

    def _settle(self, name, language, tokens):
        """Give headings anchors and links and pictures the addresses they have in the manual; [(anchor, heading)] of parts."""
        headings, anchor, anchors = [], "", iter(self.anchors(name, language).values())
        for i, token in enumerate(tokens):
            if token.type == 'heading_open':
                anchor = next(anchors)
                token.attrSet('id', anchor)
                if token.tag == 'h2':
                    headings.append((anchor, _plain(tokens[i + 1])))
            elif token.type == 'html_block':
                names = re.fullmatch(r"<!-- F1: (.+) -->", token.content.strip(), re.S)
                if not names or language != ENGLISH:
                    raise Broken(f"{address(name, language)}: what does {token.content.strip()} mean?")
                self.map += [(_of_blender(each), f"{name}.html#{anchor}") for each in names[1].split()]
                token.content = ""
            for child in token.children or ():
                if child.type == 'image':
                    self._settle_picture(child, name, language)
                elif child.type == 'link_open':
                    _settle_link(child, name, language, self.anchors)
        return headings

    def _settle_picture(self, token, name, language):
        places = (folder / token.attrs['src'] for folder in (PROJECT, path(name, language).parent))
        source = next((place for place in places if place.is_file()), None)
        if source is None:
            raise Broken(f"there is no picture {token.attrs['src']}")
        source = source.resolve()
        place = f"pictures/{source.stem}.webp"
        if self.pictures.setdefault(place, source) != source:
            raise Broken(f"two pictures are called {source.stem}")
        token.attrs['src'] = _root(language) + place
        token.attrSet('loading', 'lazy')


def _settle_link(token, name, language, anchors):
    """anchors: tells those of a page in a language."""
    target, _, heading = unquote(token.attrs['href']).partition("#")
    spoken = ENGLISH if target.startswith("../") else language
    page = target.removeprefix("../").removesuffix(".md") if target else name
    if target in _BROUGHT:
        token.attrs['href'] = _root(language) + _BROUGHT[target]
    elif page in PAGES:
        if spoken != language and language in languages_of(page):
            raise Broken(f"{address(name, language)} links {target}, which is there in {LANGUAGES[language]}")
        there = anchors(page, spoken) if spoken in languages_of(page) else {}
        token.attrs['href'] = ((target[:-3] + ".html") if target else "") + (f"#{there.get(heading, heading)}" if heading else "")
    elif "://" not in target:
        del token.attrs['href']         # what lies in the project and not in the add-on


def _root(language):
    """From a page to the folder of the manual."""
    return "" if language == ENGLISH else "../"


def _parser():
    return MarkdownIt('commonmark').enable('table')


def _headings(name, language):
    tokens = _parser().parse(text(name, language))
    return [tokens[i + 1].content for i, token in enumerate(tokens) if token.type == 'heading_open']


def _anchors(name, language):
    """{the anchor that a heading's words give: its anchor}; that is the same in all languages, so F1 leads to each."""
    english = [_anchor(heading) for heading in _headings(name, ENGLISH)]
    own = english if language == ENGLISH else [_usual_anchor(heading) for heading in _headings(name, language)]
    if len(own) != len(english):
        raise Broken(f"{address(name, language)} has {len(own)} headings, and {len(english)} in English")
    return dict(zip(own, english, strict=True))


def _languages(name, language):
    """A line of links to the same page in other languages; none if there is but one."""
    known = languages_of(name)
    links = (LANGUAGES[other] if other == language else
             f'<a href="{_root(language)}{address(name, other)}.html" hreflang="{other}" lang="{other}">{LANGUAGES[other]}</a>'
             for other in known)
    return f'<p class="languages">{" · ".join(links)}</p>\n' if len(known) > 1 else ""


def _contents(name, language, headings):
    """Links to all pages: to those in the language of this one, and then to those that are in English alone."""
    here = [other for other in PAGES if language in languages_of(other)]
    lines = [_entry(other, language, headings if other == name else None) for other in here]
    if language != ENGLISH:
        rest = (f'<li><a href="../{other}.html" hreflang="en" lang="en">{html.escape(title(other))}</a></li>'
                for other in PAGES if other not in here)
        lines.append(f"<li>{IN_ENGLISH[language].capitalize()}:\n<ul>{''.join(rest)}</ul></li>")
    return "\n".join(lines)


def _entry(name, language, headings):
    """A page's line in the contents; of the page itself the anchors and words of its headings, too."""
    here = "" if headings is None else ' aria-current="page"'
    parts = "".join(f'<li><a href="#{anchor}">{html.escape(said)}</a></li>' for anchor, said in headings or ())
    inside = f"\n<ul>{parts}</ul>" if len(headings or ()) > 1 else ""
    return f'<li><a href="{name}.html"{here}>{html.escape(title(name, language))}</a>{inside}\n</li>'


def _anchor(heading):
    return re.sub(r"[^a-z0-9]+", "-", heading.lower()).strip("-")


def _usual_anchor(heading):
    """As programs name it that show Markdown: translations link it so."""
    return re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-")


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


def _require_links(name, page, made):
    """Raises Broken unless every page and anchor that a page links is there."""
    for target in re.findall(r'href="([^":]*)"', page):
        other, _, anchor = target.partition("#")
        if other.endswith(".html") or not other:
            linked = made.get(posixpath.normpath(posixpath.join(posixpath.dirname(name), other[:-5])), "") if other else page
            if not linked or (anchor and f'id="{anchor}"' not in linked):
                raise Broken(f"{name} links {target}, which is not there")


_TEMPLATE = """<!doctype html>
<html lang="{language}">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title} · Splinewright</title>
<link rel="stylesheet" href="{root}style.css">
</head>
<body>
<nav>
<ul>
{contents}
</ul>
</nav>
<main>
{languages}{body}</main>
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
