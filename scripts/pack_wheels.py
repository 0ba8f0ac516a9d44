"""Pack a wheel for every platform, of what CMake has built for it.

    pack_wheels.py PURE DIST TAG=FOLDER...

PURE is a wheel of the package's Python files alone; each FOLDER is what `cmake --install` has put there for
one platform, and goes beside them. Into DIST: one wheel for each TAG, such as win_amd64. All entries carry
the time of SOURCE_DATE_EPOCH.
"""

import argparse
import pathlib
import re
import zipfile

from merge_fmus import entry_time
from wheel.wheelfile import WheelFile

ANY = "-py3-none-any.whl"


def python_files(pure):
    """Entries of a wheel, without its own list of them: {name: data}."""
    with zipfile.ZipFile(pure) as wheel:
        names = [name for name in wheel.namelist() if not name.endswith("/")]
        return {name: wheel.read(name) for name in names if not name.endswith(".dist-info/RECORD")}


def for_platform(text, tag):
    """The WHEEL file of a pure wheel, as that of a platform's."""
    text, tags = re.subn(r"^Tag: py3-none-any$", f"Tag: py3-none-{tag}", text, flags=re.MULTILINE)
    text, kinds = re.subn(r"^Root-Is-Purelib: true$", "Root-Is-Purelib: false", text, flags=re.MULTILINE)
    if (tags, kinds) != (1, 1):
        raise SystemExit(f"WHEEL has not the lines of a wheel for any platform:\n{text}")
    return text


def pack(pure, dist, tag, folder):
    """Write the wheel of one platform."""
    if not pure.name.endswith(ANY):
        raise SystemExit(f"{pure.name} is no wheel for any platform: its name does not end in {ANY}")
    entries = python_files(pure)
    built = {path.relative_to(folder).as_posix(): path for path in folder.rglob("*") if path.is_file()}
    entries |= {name: path.read_bytes() for name, path in built.items()}
    (about,) = (name for name in entries if name.endswith(".dist-info/WHEEL"))
    entries[about] = for_platform(entries[about].decode(), tag).encode()
    with WheelFile(dist / pure.name.replace(ANY, f"-py3-none-{tag}.whl"), "w") as wheel:
        for name, data in sorted(entries.items()):
            entry = zipfile.ZipInfo(name, entry_time())
            entry.external_attr = (
                0o100755 if "/native/" in name and not name.endswith(".h") else 0o100644
            ) << 16
            entry.create_system = 3  # Unix, whatever this one is
            wheel.writestr(entry, data, zipfile.ZIP_DEFLATED)


def main():
    """Run the command."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("pure", type=pathlib.Path)
    parser.add_argument("dist", type=pathlib.Path)
    parser.add_argument("platforms", nargs="+", metavar="TAG=FOLDER")
    arguments = parser.parse_args()
    for platform in arguments.platforms:
        tag, _, folder = platform.partition("=")
        pack(arguments.pure, arguments.dist, tag, pathlib.Path(folder))


if __name__ == "__main__":
    main()
