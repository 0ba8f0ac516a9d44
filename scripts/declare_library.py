"""Declare the C library for the Python package, from its public headers, so that no declaration is repeated.

    declare_library.py HEADERS OUTPUT

HEADERS is the folder of the public headers. OUTPUT, a Python file, has the declarations as cffi keeps them
when it has parsed them, which takes too long for each start.
"""

import argparse
import pathlib
import re

from cffi import FFI

ROOTS = ("tdmf_slip.h", "ensemble.h")
"""Headers that bring in all others."""
MODULE = "tdmf_slip.library.declarations"

DOCSTRING = "The library's public headers, as cffi reads them; made when the package is built."


def declarations(headers):
    """The public headers in the order of their inclusion, without what is for a preprocessor."""
    seen, texts = [], []

    def read(name):
        if name in seen:
            return
        seen.append(name)
        text = (headers / name).read_text(encoding="utf-8")
        for included in re.findall(r'^#include "tdmf_slip/(.*)"', text, re.MULTILINE):
            read(included)
        text = re.sub(r"#ifdef __cplusplus.*?#endif", "", text, flags=re.DOTALL)
        text = re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)
        texts.append(re.sub(r"^#.*$|^TDMF_API ", "", text, flags=re.MULTILINE))

    for name in ROOTS:
        read(name)
    return "\n".join(texts)


def main():
    """Run the command."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("headers", type=pathlib.Path)
    parser.add_argument("output", type=pathlib.Path)
    arguments = parser.parse_args()
    ffi = FFI()
    ffi.set_source(MODULE, None)
    ffi.cdef(declarations(arguments.headers))
    ffi.emit_python_code(str(arguments.output))
    made = arguments.output.read_text(encoding="utf-8")
    arguments.output.write_text(f'"""{DOCSTRING}"""\n\n{made}', encoding="utf-8")


if __name__ == "__main__":
    main()
