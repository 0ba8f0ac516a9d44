"""Docstrings, which the documentation is rendered from, describe exactly the arguments."""

import importlib
import inspect
import pathlib
import re

import pytest
import tdmf_slip

ROOT = pathlib.Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "scripts/tdmf_slip"
SECTION = re.compile(r"^(\w+)\n-+\n(.*?)(?=^\w+\n-+\n|\Z)", re.MULTILINE | re.DOTALL)
ENTRY = re.compile(r"^(\*{0,2}\w+(?:, \w+)*) : \S", re.MULTILINE)
TOP = [name for name in tdmf_slip.__all__ if inspect.isfunction(getattr(tdmf_slip, name))]


def modules():
    for path in PACKAGE.rglob("*.py"):
        name = ".".join(path.relative_to(PACKAGE).with_suffix("").parts)
        if not name.endswith("__init__") and name != "__main__":
            yield importlib.import_module(f"tdmf_slip.{name}")


def is_own(function):
    """True if the package defines it, outside of pages. Matplotlib adds a method `set` to all artists."""
    return re.match(r"tdmf_slip(?!\.pages\.)", function.__module__)


def functions():
    """Public functions and methods of all modules, each once."""
    for module in modules():
        for name, thing in vars(module).items():
            if getattr(thing, "__module__", None) != module.__name__ or name.startswith("_"):
                continue
            if inspect.isfunction(thing):
                yield f"{module.__name__}.{name}", thing
            elif inspect.isclass(thing):
                for member, value in vars(thing).items():
                    function = value.__func__ if isinstance(value, classmethod) else value
                    if inspect.isfunction(function) and not member.startswith("_") and is_own(function):
                        yield f"{module.__name__}.{name}.{member}", function


def sections(function):
    return dict(SECTION.findall(inspect.getdoc(function) or ""))


def arguments(function):
    """Names of what is given, without the instance; `**values` where names are free."""
    given = inspect.signature(function).parameters.values()
    stars = {inspect.Parameter.VAR_KEYWORD: "**"}
    return [stars.get(one.kind, "") + one.name for one in given if one.name not in ("self", "cls")]


def documented(function):
    entries = ENTRY.findall(sections(function).get("Parameters", ""))
    return [name.strip() for entry in entries for name in entry.split(",")]


def test_arguments_that_are_told_are_those_that_there_are():
    compared = 0
    for name, function in functions():
        if "Parameters" in sections(function):
            assert documented(function) == arguments(function), name
            compared += 1
    assert compared > 40


@pytest.mark.parametrize("name", TOP)
def test_what_users_call_first_is_told_in_full(name):
    found = sections(getattr(tdmf_slip, name))
    required = {"Returns", "Raises", "Examples"} | (
        {"Parameters"} if arguments(getattr(tdmf_slip, name)) else set()
    )
    assert required <= set(found), name
    assert documented(getattr(tdmf_slip, name)) == arguments(getattr(tdmf_slip, name))


def test_comments_begin_with_their_subject():
    """The first word of a comment or docstring is a noun or a verb: a reader needs no sentence before it."""
    first_word = re.compile(r'(?:"""|(?:/\*+|//+|#:?) )(Of|What|That|By) ')
    suffixes, found = {".py", ".c", ".h"}, []
    for folder in ("benchmarks", "c_core", "documentation", "examples", "fmu_src", "scripts", "tests"):
        for path in sorted((ROOT / folder).rglob("*")):
            lines = path.read_text("utf-8").splitlines() if path.suffix in suffixes else []
            for number, (before, line) in enumerate(zip(["", *lines], lines, strict=False), 1):
                goes_on = before.lstrip().startswith(("#", "//")) and line.lstrip().startswith(("#", "//"))
                if first_word.search(line) and not goes_on:
                    found.append(f"{path.relative_to(ROOT)}:{number}: {line.strip()}")
    assert not found, "\n".join(["Comments that do not begin with a noun or a verb:", *found])
