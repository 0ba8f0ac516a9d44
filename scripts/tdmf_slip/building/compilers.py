"""C compilers that make libraries of pages: the system's, or Zig from the registry."""

import importlib.util
import os
import shlex
import shutil
import subprocess
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from ..builds import host
from ..checks import is_one_of, shown
from ..errors import InputError, RunError

SUFFIXES: Mapping[str, str] = {"linux": ".so", "darwin": ".dylib", "windows": ".dll"}
"""Endings of shared libraries, by system."""
TARGETS: Mapping[str, str] = {
    "x86_64-linux": "x86_64-linux-gnu.2.17",
    "aarch64-linux": "aarch64-linux-gnu.2.17",
    "x86_64-darwin": "x86_64-macos.11.0-none",
    "aarch64-darwin": "aarch64-macos.11.0-none",
    "x86_64-windows": "x86_64-windows-gnu",
}
"""Platforms by their names in FMI 3.0, as Zig names them."""
INSTALL_ZIG = "pip install 'ziglang==0.17.*' (the extra build)"
LONGEST_ERROR = 2000
"""Characters of a compiler's message that are repeated."""


@dataclass(frozen=True)
class Compiler:
    """A C compiler for a platform."""

    command: tuple[str, ...]
    """The command, with its flags for the platform."""
    platform: str
    """The platform, as `x86_64-linux`."""

    @property
    def suffix(self) -> str:
        """Ending of shared libraries."""
        return SUFFIXES[self.platform.rpartition("-")[2]]

    @property
    def lanes(self) -> dict[int, tuple[str, tuple[str, ...]]]:
        """Numbers of lanes, each with the macro that says that a build has them, and flags."""
        found: dict[int, tuple[str, tuple[str, ...]]] = {2: ("TDMF_HAS_TWO_LANES", ())}
        if self.platform.startswith("x86_64"):
            found[4] = "TDMF_HAS_AVX2", ("-mavx2",)
            wide = ("-mavx512f", "-mavx512dq", "-mavx512vl", "-mprefer-vector-width=512")
            found[8] = "TDMF_HAS_AVX512", wide
        return found

    def run(self, arguments: Sequence[str | Path]) -> None:
        """Run the compiler; a failure is an error with its message."""
        command = [*self.command, *map(str, arguments)]
        try:
            done = subprocess.run(command, capture_output=True, text=True, errors="replace")
        except OSError as problem:
            raise InputError(f"{self.command[0]}: cannot be run: {problem.strerror}; {_advice()}") from None
        if done.returncode:
            said = (done.stderr or done.stdout).strip()[:LONGEST_ERROR]
            raise RunError(f"the C compiler failed: {shlex.join(command)}\n{said}")


def compiler_for(platform: str | None) -> Compiler:
    """The compiler for a platform, by default this machine's."""
    if platform is not None and not is_one_of(platform, TARGETS):
        raise InputError(f"platform {shown(platform)} is not allowed; allowed: {', '.join(TARGETS)}")
    own = host()
    if platform in (None, own):
        given = os.environ.get("CC", "")
        if given:
            return Compiler(tuple(shlex.split(given)), own)
        names = () if sys.platform == "win32" else ("cc", "gcc", "clang")
        found = next(filter(None, map(shutil.which, names)), None)
        if found:
            return Compiler((found,), own)
    if importlib.util.find_spec("ziglang") is None:
        what = (
            "no C compiler was found (cc, gcc, clang)"
            if platform is None
            else f"for {platform} Zig is needed"
        )
        raise InputError(f"{what}; {_advice()}")
    wanted = platform or own
    if wanted not in TARGETS:
        raise InputError(f"Zig is not used for {wanted}; install a C compiler, or name it in the variable CC")
    return Compiler((sys.executable, "-m", "ziglang", "cc", "-target", TARGETS[wanted]), wanted)


def _advice() -> str:
    return f"install Zig, {INSTALL_ZIG}, or a C compiler such as gcc, or name one in the variable CC"
