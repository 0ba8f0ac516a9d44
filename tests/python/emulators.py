"""Programs of other platforms, run here: those of Windows under wine, those of Arm Linux under qemu."""

import os
import pathlib
import shutil

from conftest import ROOT

WINE = shutil.which("wine64", path=f"{os.environ['PATH']}:/usr/lib/wine")
WINE_FOLDER = ROOT / "build/platforms/wine"
"""What wine keeps of Windows, some 700 MB: made once, because that takes longer than any test."""
QEMU = shutil.which("qemu-aarch64")
ARM_LIBRARIES = pathlib.Path("/usr/aarch64-linux-gnu")


def windows():
    """The command before a program of Windows, and its environment; None where there is no wine."""
    if WINE is None:
        return None
    return [WINE], os.environ | {"WINEPREFIX": str(WINE_FOLDER), "WINEDEBUG": "-all"}


def arm_linux():
    """The command before a program of Arm Linux, and its environment; None where there is no qemu."""
    if QEMU is None or not ARM_LIBRARIES.is_dir():
        return None
    return [QEMU, "-L", str(ARM_LIBRARIES)], dict(os.environ)
