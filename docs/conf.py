"""Configuration of the documentation; public names and tables of registries are generated."""

from __future__ import annotations

import ast
import hashlib
import shutil
import sys
from pathlib import Path
from typing import ClassVar

from docutils import nodes
from docutils.utils.math.latex2mathml import tex2mathml
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective
from sphinx.writers.html5 import HTML5Translator

import jounce

project = "jounce"
author = "jounce contributors"
copyright = "2026, jounce contributors"
version = release = jounce.__version__

extensions = ["myst_nb", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "sphinxcontrib.bibtex"]
exclude_patterns = ["_build", "_generated"]
myst_enable_extensions = ["colon_fence", "deflist", "dollarmath", "substitution"]
myst_heading_anchors = 3
nb_execution_mode = (
    "cache"  # tutorials are notebooks: they are run where their cells or jounce have changed
)
nb_execution_in_temp = True
nb_execution_raise_on_error = True
nb_execution_timeout = 300  # s, of a cell
nb_merge_streams = True
nb_output_stderr = "remove"  # what compiles, says so there
html_theme = "furo"
html_title = f"jounce {release}"
html_show_sphinx = False
html_math_renderer = (
    "mathml"  # browsers typeset it themselves, without scripts and without a network
)
html_static_path = ["_static"]
html_css_files = ["site.css", "notebooks.css"]
html_search_scorer = str(Path(__file__).parent / "_static" / "search_scorer.js")
bibtex_bibfiles = ["../references.bib"]
bibtex_default_style = "unsrt"
autodoc_typehints = "none"  # the sections say type, unit and shape
autodoc_default_options = {
    "members": True,
    "inherited-members": False,
    "exclude-members": "model_config",
}
add_module_names = False
napoleon_google_docstring = False
napoleon_use_ivar = True
suppress_warnings = ["bibtex.missing_field", "ref.python"]  # attributes of one name in two classes


def what_runs(source: str) -> bytes:
    """Return a module without comments and docstrings of functions, which do not affect the output of lessons."""
    tree = ast.parse(source)
    for node in ast.walk(
        tree
    ):  # docstrings of classes stay: a notebook shows what they say of a value
        if isinstance(
            node, ast.Module | ast.FunctionDef | ast.AsyncFunctionDef
        ) and ast.get_docstring(node):
            del node.body[0]
    return ast.dump(tree).encode()


def cache_of_notebooks(folder: Path) -> str:
    """Return the cache of notebook outputs for the current sources of jounce, and remove older caches."""
    digest = hashlib.sha256()
    sources = Path(jounce.__file__).parent
    for file in sorted(sources.rglob("*")):
        if file.suffix in {".py", ".toml", ".csv"}:
            content = (
                what_runs(file.read_text(encoding="utf-8"))
                if file.suffix == ".py"
                else file.read_bytes()
            )
            digest.update(str(file.relative_to(sources)).encode() + b"\0" + content)
    cache = folder / digest.hexdigest()[:12]
    for other in folder.glob("*"):
        if other != cache:
            shutil.rmtree(other)
    return str(cache)


nb_execution_cache_path = cache_of_notebooks(Path(__file__).parent / "_build" / "notebooks")
sys.path.insert(0, str(Path(__file__).parent))
import make_faces  # noqa: E402

make_faces.write_tables()
import make_reference  # noqa: E402

make_reference.write()
import identification_variants  # noqa: E402

identification_variants.write_table(make_faces.TABLES)
import make_records  # noqa: E402

make_records.write(make_faces.TABLES)
import make_prototype  # noqa: E402

make_prototype.write(make_faces.TABLES)
myst_substitutions = make_prototype.numbers()
import make_evidence  # noqa: E402

make_evidence.write()
import drawings  # noqa: E402

drawings.write()
import make_gallery  # noqa: E402

make_gallery.write()


class Drawn(SphinxDirective):
    """``{drawn} NAME``: a picture in the reader's scheme, of ``drawn.py`` or kept; ``alt`` says what it shows."""

    required_arguments = 1
    has_content = True
    option_spec: ClassVar = {"alt": str}

    def run(self) -> list[nodes.Node]:
        if not self.options.get("alt", "").strip():
            raise self.error("a picture needs `:alt:`, for those who do not see it")
        frame = nodes.container(classes=["drawn-frame"])
        found: list[nodes.Node] = [frame]
        for scheme in ("light", "dark"):
            kept = f"figures/{self.arguments[0]}-{scheme}.png"
            is_kept = (Path(__file__).parent / kept).exists()
            uri = f"/{kept}" if is_kept else f"/_generated/figures/{self.arguments[0]}-{scheme}.svg"
            image = nodes.image(uri=uri, alt=self.options["alt"])
            image["classes"] += [f"only-{scheme}", "drawn"]
            frame += image
        if self.content:
            caption = nodes.container(classes=["drawn-caption"])
            self.state.nested_parse(self.content, self.content_offset, caption)
            found.append(caption)
        return found


def inline_formula(self: HTML5Translator, node: nodes.math) -> None:
    self.body.append(tex2mathml(node.astext()))
    raise nodes.SkipNode


def formula(self: HTML5Translator, node: nodes.math_block) -> None:
    self.body.append(f'<div class="formula">{tex2mathml(node.astext(), as_block=True)}</div>')
    raise nodes.SkipNode


def pictures_when_they_are_near(
    _: Sphinx, __: str, ___: str, context: dict[str, object], ____: object
) -> None:
    """Load pictures lazily, and only those of the reader's colour scheme."""
    if "body" in context:
        context["body"] = str(context["body"]).replace("<img ", '<img loading="lazy" ')


def setup(app: Sphinx) -> None:
    """Register the directive and the formulas with Sphinx."""
    app.add_directive("drawn", Drawn)
    app.connect("html-page-context", pictures_when_they_are_near)
    app.add_html_math_renderer("mathml", (inline_formula, None), (formula, None))
