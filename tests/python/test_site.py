"""The site that ./scripts/site builds: whole, with nothing fetched from elsewhere and nothing untold."""

import json
import re
import sys
import urllib.parse

import pytest
import tdmf_slip
from conftest import ROOT
from lxml import html
from tdmf_slip.cli.main import COMMANDS

SOURCES = ROOT / "documentation"
sys.path.insert(0, str(SOURCES / "extensions"))
pytest.importorskip("sphinx", reason="NOT TESTED: the site, Sphinx is not installed")
LOADS = (
    "//script/@src|//link[not(@rel='canonical')]/@href|//img/@src|//iframe/@src|//object/@data|//source/@src"
)
"""Addresses that a browser fetches by itself."""


class Page:
    """Links, anchors and what is loaded."""

    def __init__(self, path):
        page = html.document_fromstring(path.read_bytes())
        self.links, self.loaded = (list(map(str, page.xpath(what))) for what in ("//a/@href", LOADS))
        self.anchors = set(map(str, page.xpath("//@id|//@name")))


@pytest.fixture(scope="module")
def pages(site):
    return {path: Page(path) for path in sorted(site.rglob("*.html"))}


def is_elsewhere(address):
    return bool(urllib.parse.urlsplit(address).netloc)


def test_no_page_loads_anything_from_elsewhere(pages):
    loaded = [(path.name, address) for path, page in pages.items() for address in page.loaded]
    assert len(loaded) > 100
    assert [found for found in loaded if is_elsewhere(found[1])] == []


def test_no_style_and_no_script_loads_anything_from_elsewhere(site):
    """A script may name an address, but it imports and fetches none."""
    styles, scripts = list(site.rglob("*.css")), list(site.rglob("*.js"))
    assert len(styles) >= 4 and len(scripts) >= 4
    loads = re.compile(
        r"""(?:@import|url\(|\bimport\(|\bfetch\(|\bimportScripts\(|\.src\s*=)\s*["']?(?:https?:)?//[^"')\s]+"""
    )
    found = {path.name: loads.findall(path.read_text(encoding="utf-8")) for path in (*styles, *scripts)}
    assert {name: addresses for name, addresses in found.items() if addresses} == {}


def test_links_and_anchors_inside_the_site_lead_somewhere(pages, site):
    followed, broken = 0, []
    for path, page in pages.items():
        for link in [*page.links, *page.loaded]:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            target = (path.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else path
            known = pages[target].anchors if target in pages else set()
            fragment = urllib.parse.unquote(parts.fragment)
            is_state = target.name == "live.html"  # which has its state there
            if not target.is_file() or (fragment and fragment not in known and not is_state):
                broken.append(f"{path.relative_to(site)}: {link}")
            followed += 1
    assert followed > 1000
    assert broken == []


def test_each_guide_downloads_as_a_notebook_with_its_code(pages, site):
    guides = sorted((SOURCES / "guides").glob("*.md"))
    assert len(guides) >= 16
    for guide in guides:
        source = guide.read_text(encoding="utf-8")
        if guide.stem in ("own_law", "guinea_fowl"):  # shell commands, or no code at all
            assert "{code-cell}" not in source
            continue
        page = site / "guides" / f"{guide.stem}.html"
        (link,) = {link for link in pages[page].links if link.endswith(f"/{guide.stem}.ipynb")}
        notebook = json.loads((page.parent / urllib.parse.unquote(link)).read_text(encoding="utf-8"))
        cells = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
        needed = len(re.findall(r"^% needs ", source, re.MULTILINE))
        assert len(cells) == source.count("```{code-cell}") + needed > 0, guide.name


def test_every_public_name_has_its_place(pages):
    anchors = set().union(*(page.anchors for page in pages.values()))
    top = [getattr(tdmf_slip, name) for name in tdmf_slip.__all__ if not name.startswith("_")]
    python = {f"{thing.__module__}.{thing.__name__}" for thing in top}
    variables = {
        re.sub(r"[^a-z0-9]+", "-", name.lower()).strip("-") for name in tdmf_slip.load_fmu().variables
    }
    headers = "".join(path.read_text() for path in (ROOT / "c_core/include/tdmf_slip").glob("*.h"))
    functions = {f"c.{name}" for name in re.findall(r"^(?!typedef)\w[\w *]*\b(tdmf_\w+)\(", headers, re.M)}
    types = {f"c.{name}" for name in re.findall(r"^\} (tdmf_\w+);", headers, re.M)}
    commands = {f"tdmf-slip-{name}" for name in COMMANDS}
    for wanted, least in ((python, 15), (variables, 80), (functions, 45), (types, 30), (commands, 8)):
        assert len(wanted) >= least
        assert wanted - anchors == set()


# ---- a public name that nothing tells of ----


def test_nothing_public_is_untold():
    """The site's own check of names, without a build."""
    import c_headers
    import python_reference

    python_reference.check(ROOT / "scripts" / "tdmf_slip")
    untold = {
        name: header.undocumented for name, header in c_headers.headers().items() if header.undocumented
    }
    assert untold == {} and all(header.comment for header in c_headers.headers().values())
    pages = "".join(path.read_text() for path in (SOURCES / "reference" / "c").glob("*.md"))
    assert [name for name in c_headers.headers() if f"{{c-header}} {name}" not in pages] == []


def test_a_python_name_without_a_docstring_is_refused(tmp_path):
    from python_reference import check
    from sphinx.errors import ExtensionError

    (tmp_path / "__init__.py").write_text('"""Told."""\n')
    module = tmp_path / "module.py"
    documented = '"""Told."""\n\n\nclass Thing:\n    """Told."""\n\n    size: float\n    """Told."""\n'
    module.write_text(documented)
    check(tmp_path)
    for untold, name in (
        ("\n\ndef function():\n    return 1\n", "function"),
        ("    weight: float\n", "Thing.weight"),
        ("\n    def method(self):\n        return 1\n", "Thing.method"),
    ):
        module.write_text(documented + untold)
        with pytest.raises(ExtensionError, match=rf"module: {re.escape(name)}"):
            check(tmp_path)


@pytest.mark.parametrize(
    ("declared", "untold"),
    [
        ("void tdmf_do(int count);", "tdmf_do"),
        ("/* Told. */\ntypedef struct {\n    int count;\n} tdmf_thing;", "tdmf_thing: count"),
        ("typedef enum { TDMF_ONE /* told */ } tdmf_number;", "tdmf_number"),
        (
            "/* Told. */\ntypedef enum {\n    TDMF_ONE, /* told */\n    TDMF_TWO\n} tdmf_n;",
            "tdmf_n: TDMF_TWO",
        ),
        ("#define TDMF_LIMIT 3", "TDMF_LIMIT"),
    ],
)
def test_a_c_name_without_a_comment_is_found(tmp_path, declared, untold):
    from c_headers import headers

    (tmp_path / "thing.h").write_text(f"/* A header. */\n\n/* Told. */\nint tdmf_told(void);\n\n{declared}\n")
    header = headers(tmp_path)["thing.h"]
    assert header.comment == "A header." and header.undocumented == [untold]
