"""Beginning a page of one's own: a folder with a page, parameters, a test and a README."""

import keyword
import os
import re
from pathlib import Path

from ..checks import is_one_of, path_of, shown
from ..errors import InputError, reason

TEMPLATES = Path(__file__).parent / "templates"
STARTS = ("runner", "scratch")
"""Beginnings of a page."""


def new(name: str | os.PathLike[str], *, start: str = "runner") -> Path:
    """Write a folder in which a page of one's own begins.

    Parameters
    ----------
    name : str or Path
        The folder, whose last part names the model: small letters, digits and _.
    start : {"runner", "scratch"}, default "runner"
        A page that overrides one law of the runner, or a bouncing ball.

    Returns
    -------
    Path
        The folder, with `page.py`, `parameters.toml`, a test and a README.

    Raises
    ------
    InputError
        The name cannot be a model's, or the folder is there already.

    Examples
    --------
    >>> import tdmf_slip
    >>> folder = tdmf_slip.new("my_runner")
    >>> sorted(path.name for path in folder.iterdir())
    ['README.md', 'page.py', 'parameters.toml', 'test_my_runner.py']
    """
    if not is_one_of(start, STARTS):
        raise InputError(f"start {shown(start)} is not allowed; allowed: {', '.join(STARTS)}")
    folder = path_of(name, "new", "the path of a folder")
    own = folder.name
    if not re.fullmatch(r"[a-z][a-z0-9_]{0,39}", own) or keyword.iskeyword(own):
        raise InputError(
            f"new {shown(own)} is not allowed; allowed: a lower-case letter, then up to 39 of a-z, 0-9 and _"
        )
    words = {"my_model": own, "MyModel": "".join(part.capitalize() for part in own.split("_"))}
    try:
        folder.mkdir(parents=True)
        for template in sorted((TEMPLATES / start).iterdir()):
            text = template.read_text(encoding="utf-8")
            target = template.name.removesuffix(".txt")
            for word, its in words.items():
                text, target = text.replace(word, its), target.replace(word, its)
            (folder / target).write_text(text, encoding="utf-8", newline="\n")
    except FileExistsError:
        raise InputError(f"new {shown(str(folder))}: exists already; allowed: a new folder") from None
    except OSError as problem:
        raise InputError(f"new {shown(str(folder))}: {reason(problem)}") from None
    return folder
