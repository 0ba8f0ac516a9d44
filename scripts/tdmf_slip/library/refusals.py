"""Refusals of the C library as Python errors, and its texts as Python strings."""

from typing import Any

from ..errors import InputError
from .binding import c, ffi


def text_of(characters: object) -> str:
    """A text of the library, a `char *`."""
    text: bytes = ffi.string(characters)
    return text.decode()


def check_accepted(refusal: Any, where: str = "") -> None:
    """Raise an `InputError` if the library refused a value; `where` begins its message."""
    if refusal.variable != ffi.NULL:
        text = ffi.new("char[256]")
        c.tdmf_refusal_text(ffi.new("tdmf_refusal *", refusal), text, len(text))
        raise InputError(f"{where}{text_of(text)}")
