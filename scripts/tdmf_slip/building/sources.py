"""Pages in files: reading the one class that a file declares as its page."""

import traceback
from pathlib import Path
from types import ModuleType
from typing import Any

from ..checks import path_of, shown
from ..errors import InputError, reason

PAGE = "page.py"
"""The file of the page in a folder."""


def page_file(given: object) -> Path:
    """The file of a page: the given one, or `page.py` in a folder."""
    path = path_of(given, "page", "a folder with page.py, or a file in Python")
    path = path / PAGE if path.is_dir() else path
    if not path.is_file():
        raise InputError(
            f"page {shown(str(path))} does not exist; allowed: a folder with {PAGE}, or a Python file"
        )
    return path


def page_in(path: Path) -> Any:
    """The class in a file that is its page: the one model that no other class of the file is made from."""
    from ..hybrid.errors import PageError
    from ..hybrid.model import Model

    module = _run(path, PageError)
    own = [
        value
        for value in vars(module).values()
        if isinstance(value, type) and issubclass(value, Model) and value.__module__ == module.__name__
    ]
    last = [one for one in own if not any(one is not other and issubclass(other, one) for other in own)]
    if len(last) != 1:
        names = ", ".join(one.__name__ for one in last) or "none"
        raise InputError(
            f"{path}: declares as models: {names}; allowed: one subclass of Model, or of the runner"
        )
    return last[0]


def _run(path: Path, page_error: type[Exception]) -> ModuleType:
    """Run the file of a page as a module of its own."""
    module = ModuleType(f"tdmf_slip_page_{path.stem}")
    module.__file__ = str(path)
    try:
        exec(compile(path.read_bytes(), path, "exec"), vars(module))
    except page_error as problem:
        raise InputError(str(problem)) from None
    except SyntaxError as problem:
        raise InputError(f"{problem.filename}:{problem.lineno}: {problem.msg}") from None
    except OSError as problem:
        raise InputError(f"{path}: {reason(problem)}") from None
    except Exception as problem:
        lines = [
            frame.lineno
            for frame in traceback.extract_tb(problem.__traceback__)
            if frame.filename == str(path)
        ]
        where = f"{path}:{lines[-1]}" if lines else str(path)
        raise InputError(f"{where}: {type(problem).__name__}: {problem}") from None
    return module
