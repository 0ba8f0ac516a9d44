"""Text on a stream whose encoding has not all characters, as that of a redirect on Windows."""

import codecs
import sys
import unicodedata
from collections.abc import Mapping

HANDLER = "tdmf_slip.equivalents"
"""Name of the error handler, as `reconfigure` takes it."""
EQUIVALENTS: Mapping[str, str] = {
    "·": ".",
    "°": " deg",
    "±": "+-",
    "×": "x",
    "−": "-",
    "≈": "~",
    "≤": "<=",
    "≥": ">=",
    "√": "sqrt",
    "λ": "lambda",
    "μ": "mu",
    "µ": "mu",
    "θ": "theta",
}
"""ASCII texts of characters that do not decompose into an ASCII letter and an accent."""
UNKNOWN = "?"
UNDECODED = range(0xDC80, 0xDD00)
"""Characters that Python makes of bytes of a file's name which are no text."""


def prints_anything() -> None:
    """Let standard output and error replace characters that they cannot encode; names of files are kept."""
    codecs.register_error(HANDLER, _replaced)
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors=HANDLER)


def _replaced(problem: UnicodeError) -> tuple[str | bytes, int]:
    """Replacement of the first character that cannot be encoded, and where to go on."""
    if not isinstance(problem, UnicodeEncodeError):
        raise problem
    character, following = problem.object[problem.start], problem.start + 1
    if ord(character) in UNDECODED:
        return bytes([ord(character) - 0xDC00]), following
    plain = unicodedata.normalize("NFKD", character).encode("ascii", "ignore").decode("ascii")
    return EQUIVALENTS.get(character) or plain or UNKNOWN, following
