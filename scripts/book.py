#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""book.py [DIR]: gathers docs/, the techniques' pages and the project's own into DIR/source (default build/book), builds the
site with mkdocs --strict into DIR/site and checks every link and anchor of it. Pages that the navigation lacks fail; those of
techniques are put into it here.
Exit codes: 0 fine, 1 a link leads nowhere or mkdocs complains, 3 mkdocs is not installed."""
import html.parser
import pathlib
import re
import shutil
import subprocess
import sys
import urllib.parse

ROOT = pathlib.Path(__file__).resolve().parent.parent
LINK = re.compile(r"\[([^\]]*)\]\(([^)\s]+)\)")
TOP_PAGES = ("CONTRIBUTING.md", "CHANGELOG.md", "THIRD_PARTY.md")


def page_of(path):
    """Where a file of the repository stands in the book; None when it is no page."""
    parts = path.relative_to(ROOT).parts
    if parts[0] == "docs":
        return "/".join(parts[1:])
    if parts[:2] == ("realtime", "techniques") and path.name in ("README.md", "picture.png"):
        return f"techniques/{parts[2]}{path.suffix}"
    if path.name == "README.md" and len(parts) == 1:
        return "index.md"
    return path.name if path.name in TOP_PAGES and len(parts) == 1 else None


def rewrite(text, file, problems):
    """Links as they hold in the repository, to links as they hold in the book. What is no page stays as text."""
    here = page_of(file)
    depth = here.count("/")

    def replace(match):
        label, target = match.groups()
        if re.match(r"[a-z]+:", target) or target.startswith("#"):
            return match[0]
        name, _, anchor = target.partition("#")
        linked = (file.parent / name).resolve()
        if not linked.exists() or not linked.is_relative_to(ROOT):
            problems.append(f"{file.relative_to(ROOT)}: the link to {target} leads nowhere")
            return match[0]
        page = page_of(linked)
        if page is None:
            return f"{label} (`{linked.relative_to(ROOT)}`)"
        return f"[{label}]({'../' * depth}{page}{'#' + anchor if anchor else ''})"

    return LINK.sub(replace, text)


def gather(source):
    problems = []
    files = [*ROOT.glob("docs/**/*.md"), *ROOT.glob("realtime/techniques/*/README.md"), ROOT / "README.md",
             *(ROOT / name for name in TOP_PAGES)]
    for file in files:
        target = source / page_of(file)
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(rewrite(file.read_text(), file, problems))
    for picture in ROOT.glob("realtime/techniques/*/picture.png"):
        shutil.copy(picture, source / page_of(picture))
    shutil.copytree(ROOT / "docs" / "images", source / "images", dirs_exist_ok=True)
    return problems


def with_techniques(config):
    """The configuration with a page a technique, by title, after the page of all."""
    pages = []
    for manifest in ROOT.glob("realtime/techniques/*/technique.toml"):
        title = re.search(r'^title = "(.*)"$', manifest.read_text(), re.M)[1]
        pages.append(f'          - "{title}": techniques/{manifest.parent.name}.md\n')
    line = "      - All of them, measured: techniques.md\n"
    assert line in config and pages
    return config.replace(line, line + "      - One by one:\n" + "".join(sorted(pages, key=str.lower)))


class Page(html.parser.HTMLParser):
    def __init__(self):
        super().__init__()
        self.links, self.anchors = [], set()

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name == "id" or (tag == "a" and name == "name"):
                self.anchors.add(value)
            if name in ("href", "src") and value:
                self.links.append(value)


def check_links(site):
    pages = {}
    for file in site.rglob("*.html"):
        page = Page()
        page.feed(file.read_text())
        pages[file] = page
    links = 0
    for file, page in pages.items():
        if file.name == "404.html":
            continue
        for link in page.links:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            links += 1
            target = (file.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else file
            if not target.exists():
                yield f"{file.relative_to(site)}: {link} leads nowhere"
            elif parts.fragment and target in pages and parts.fragment not in pages[target].anchors:
                yield f"{file.relative_to(site)}: {link}: no such anchor"
    if links < 100:
        yield f"only {links} links were found"


def self_test():
    """The checks themselves must be able to fail."""
    problems = []
    assert rewrite("[a](design.md#rooms) [b](https://x) [c](../LICENSE)", ROOT / "docs" / "truth.md", problems) == \
        "[a](design.md#rooms) [b](https://x) c (`LICENSE`)" and not problems
    rewrite("[a](none.md)", ROOT / "docs" / "truth.md", problems)
    assert len(problems) == 1, problems
    page = Page()
    page.feed('<h2 id="x"></h2><a href="y.html#z">')
    assert page.anchors == {"x"} and page.links == ["y.html#z"]


def unlisted(source):
    listed = (ROOT / "mkdocs.yml").read_text()
    for page in sorted(source.glob("*.md")):
        if not re.search(rf": {re.escape(page.name)}$", listed, re.M):
            yield f"{page.name} is not in mkdocs.yml's navigation"


def main():
    if shutil.which("mkdocs") is None:
        print("book: mkdocs is not installed (packages mkdocs, mkdocs-material): the book was not built", file=sys.stderr)
        return 3
    self_test()
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build" / "book").resolve()
    source, site = folder / "source", folder / "site"
    shutil.rmtree(source, ignore_errors=True)
    source.mkdir(parents=True)
    problems = gather(source)
    problems += unlisted(source)
    config = folder / "mkdocs.yml"
    text = with_techniques((ROOT / "mkdocs.yml").read_text())
    config.write_text(text.replace("build/book/source", str(source)).replace("build/book/site", str(site)))
    built = subprocess.run(["mkdocs", "build", "--strict", "--quiet", "--clean", "-f", str(config)])
    if built.returncode != 0:
        problems.append("mkdocs complains")
    problems += check_links(site) if site.is_dir() else []
    for problem in problems:
        print(f"book: {problem}", file=sys.stderr)
    if not problems:
        print(f"book: {len(list(site.rglob('*.html')))} pages in {site}")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
