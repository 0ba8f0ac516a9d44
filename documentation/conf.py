"""Sphinx configuration of the site, which ./scripts/site builds."""

import os
import sys
from pathlib import Path

import tdmf_slip

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE / "extensions"))
os.environ["PATH"] = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"  # the guides' tdmf-slip

project = "TDMF-SLIP"
author = "The TDMF-SLIP authors"
copyright = "2026, the TDMF-SLIP authors"
release = version = tdmf_slip.__version__

# ---- where it is published: nowhere yet; these are the lines that a release changes ----
INSTALL = "pip install ."  # in the folder of the sources
REPOSITORY = ""  # address of the sources
SITE = ""  # address of this site
VERSIONS = ""  # the list of its versions, from here: "../versions.json" where each has a folder

extensions = [
    "myst_nb",
    "sphinx.ext.autodoc",
    "sphinx.ext.graphviz",
    "sphinx.ext.napoleon",
    "sphinx.ext.viewcode",
    "c_reference",
    "citation",
    "command_reference",
    "content_security_policy",
    "gallery",
    "glossary_page",
    "kernels",
    "mathml",
    "navigation",
    "notebooks",
    "page_description",
    "python_reference",
    "variable_reference",
    "versions",
]
exclude_patterns = ["data", "extensions", "live", "templates"]
templates_path = ["templates"]
viewcode_follow_imported_members = False
default_role = "literal"
suppress_warnings = ["ref.python"]  # of two attributes with one name

myst_enable_extensions = ["dollarmath", "deflist", "colon_fence", "attrs_inline", "substitution"]
myst_substitutions = {
    "install": f"`{INSTALL}`" if REPOSITORY else f"`{INSTALL}` in the folder of the sources",
    "repository": f"[the repository]({REPOSITORY})"
    if REPOSITORY
    else "the repository that this site is built from",
}
myst_heading_anchors = 3
myst_update_mathjax = False
nb_execution_mode = "force"
nb_execution_in_temp = True  # as whoever downloads a guide
nb_execution_raise_on_error = True
nb_execution_timeout = 1200
nb_execution_show_tb = True
nb_merge_streams = True

napoleon_google_docstring = False
napoleon_use_rtype = False
autodoc_member_order = "bysource"
autodoc_use_type_comments = False  # there are none; looking for them takes a tenth of the build
python_maximum_signature_line_length = 88
c_maximum_signature_line_length = 88
graphviz_output_format = "svg"

html_theme = "furo"
html_title = "TDMF-SLIP"
html_baseurl = SITE
html_static_path = ["static"]
html_css_files = ["site.css"]
html_search_scorer = str(HERE / "static" / "search_scorer.js")
versions_file = VERSIONS
html_sidebars = {
    "**": [
        "sidebar/brand.html",
        "versions.html",
        "sidebar/search.html",
        "live_link.html",
        "sidebar/scroll-start.html",
        "sidebar/navigation.html",
        "sidebar/scroll-end.html",
    ]
}
html_logo = html_favicon = "static/logo.svg"
html_math_renderer = "mathml"
html_copy_source = False
html_show_sphinx = False
html_theme_options = {
    **(
        {"source_repository": REPOSITORY, "source_branch": "main", "source_directory": "documentation/"}
        if REPOSITORY
        else {}
    ),
    "light_css_variables": {"color-brand-primary": "#1f5fa8", "color-brand-content": "#1f5fa8"},
    "dark_css_variables": {"color-brand-primary": "#7fb2ea", "color-brand-content": "#7fb2ea"},
}
