"""Layout of a build: its folder, the file of its table, and the platforms of its libraries."""

import sys

FOLDER = "build"
"""The folder of what is built, in the folder of a page."""
TABLE = "model.json"
"""The file of the model's table, which names its libraries."""


def host() -> str:
    """The name of this machine's platform in FMI 3.0, as `x86_64-linux`."""
    import platform  # slow to load

    machine = platform.machine().lower()
    system = {"win32": "windows"}.get(sys.platform, sys.platform)
    return f"{ {'amd64': 'x86_64', 'arm64': 'aarch64'}.get(machine, machine) }-{system}"
