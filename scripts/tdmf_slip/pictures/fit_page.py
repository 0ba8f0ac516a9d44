"""The report of a fit as a page of HTML that needs nothing else: tables, sentences, and the picture."""

import base64
import html
from collections.abc import Iterable, Sequence
from pathlib import Path

from ..files.whole import write_whole
from ..fitting.result import CONFIDENCE, PARAMETER_HEADER, RESIDUAL_HEADER, Fit
from . import style
from .fit_diagram import figure_of

FORMATS = (".html",)
PAGE = """<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>TDMF-SLIP: fit</title>
<style>
  body {{ font: 16px sans-serif; max-width: 60rem; margin: 1rem auto; padding: 0 1rem; color: #22303c; }}
  img {{ width: 100%; }}
  table {{ border-collapse: collapse; }}
  th, td {{ text-align: left; padding: 0.15rem 1rem 0.15rem 0; border-bottom: 1px solid #c9d1d8; }}
</style>
<h1>A runner fitted to {where}</h1>
<h2>Parameters, with intervals of {confidence:.0f} % confidence</h2>
{parameters}
<p>The data's errors are taken as known standard errors; the intervals are of the normal distribution.</p>
<h2>What the fit says</h2>
<ul>
{sentences}
</ul>
<h2>Data and fit</h2>
<img alt="Each quantity as measured and as fitted, and the residuals" src="data:image/png;base64,{picture}">
<h2>Residuals</h2>
{residuals}
</html>
"""


def write(path: Path, fit: Fit) -> None:
    """Write the report of a fit, whole or not at all."""
    page = PAGE.format(
        where=html.escape(fit.measurements.where),
        confidence=100.0 * CONFIDENCE,
        parameters=_table(PARAMETER_HEADER, fit.parameter_rows()),
        sentences="\n".join(f"<li>{html.escape(sentence)}</li>" for sentence in fit.sentences()),
        picture=_picture(fit),
        residuals=_table(RESIDUAL_HEADER, fit.residual_rows()),
    )
    write_whole(path, lambda beside: beside.write_text(page, encoding="utf-8", errors="backslashreplace"))


def _picture(fit: Fit) -> str:
    """As PNG in base 64."""
    return base64.b64encode(style.png_of(figure_of(fit))).decode()


def _table(header: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    def cells(tag: str, row: Sequence[str]) -> str:
        return "<tr>" + "".join(f"<{tag}>{html.escape(cell)}</{tag}>" for cell in row) + "</tr>"

    return "\n".join(["<table>", cells("th", header), *(cells("td", row) for row in rows), "</table>"])
