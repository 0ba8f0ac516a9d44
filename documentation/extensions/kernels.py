"""Kernels for the guides, forked from one Python that has imported what guides import.

Each guide runs in a kernel of its own. To start Python and import NumPy, SciPy, Matplotlib and this package
takes a second of processor time, some forty times. Whether a guide imports all that it uses is seen where its
notebook runs alone: `scripts/test --release`.

    kernels.py serve SOCKET                       import, then fork a kernel for each that asks, until killed
    kernels.py start SOCKET OPTION_OF_KERNEL...   ask for a kernel, and end when it does
"""

from __future__ import annotations

import atexit
import contextlib
import gc
import json
import os
import signal
import socket
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:  # a kernel's process starts without packages
    from sphinx.application import Sphinx

IMPORTED = (
    "ipykernel.kernelapp",
    "matplotlib.pyplot",
    "scipy.optimize",
    "scipy.stats",
    "tdmf_slip",
    "xarray",
)
BACKEND = "module://matplotlib_inline.backend_inline"
"""Matplotlib's backend in kernels, which it reads from the environment when it is imported."""


def serve(path: str) -> None:
    """Import what guides import, and answer each request by a fork."""
    os.environ["MPLBACKEND"] = BACKEND
    os.environ["JPY_PARENT_PID"] = "1"  # else a kernel looks whether the process that asked is its parent
    for name in IMPORTED:
        __import__(name)
    package = sys.modules["tdmf_slip"]
    for name in package.__all__:
        getattr(package, name)  # each is imported by its first use
    signal.signal(signal.SIGCHLD, reap)
    gc.collect()
    gc.freeze()  # so that no kernel's collector writes to, and thereby copies, what they share
    with socket.socket(socket.AF_UNIX) as server:
        server.bind(f"{path}.new")
        server.listen()
        os.rename(f"{path}.new", path)  # whoever sees the name can connect
        while True:
            connection, _ = server.accept()
            with connection:
                if os.fork() == 0:
                    server.close()
                    become_kernel(connection)


def reap(*_: object) -> None:
    """Wait for kernels that have ended, so that their processor time counts as the build's."""
    with contextlib.suppress(ChildProcessError):
        while os.waitpid(-1, os.WNOHANG)[0]:
            pass


def become_kernel(connection: socket.socket) -> None:
    """Be the process that was asked for: its streams, folder, environment and options."""
    import threading

    from ipykernel.kernelapp import launch_new_instance

    request, streams, _, _ = socket.recv_fds(connection, 1 << 20, 3)
    asked = json.loads(request)
    for number, stream in enumerate(streams):
        os.dup2(stream, number)
        os.close(stream)
    os.chdir(asked["folder"])
    os.environ.clear()
    os.environ.update(asked["environment"] | {"MPLBACKEND": BACKEND})
    signal.signal(signal.SIGCHLD, signal.SIG_DFL)

    def end_with_the_process_that_asked() -> None:
        connection.recv(1)
        os._exit(1)

    threading.Thread(target=end_with_the_process_that_asked, daemon=True).start()
    status = 1
    try:
        launch_new_instance(argv=asked["options"])
        status = 0
    finally:
        atexit._run_exitfuncs()  # such as deleting an unpacked unit; `_exit` skips them
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(status)


def start(path: str, options: list[str]) -> None:
    """Ask for a kernel that takes the place of this process, and end when it has ended."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # which Jupyter sends before it asks the kernel to end
    asked = {"folder": os.getcwd(), "environment": dict(os.environ), "options": options}
    with socket.socket(socket.AF_UNIX) as connection:
        connection.connect(path)
        socket.send_fds(connection, [json.dumps(asked).encode()], [0, 1, 2])
        connection.recv(1)


# ---- as an extension of Sphinx ----


def provide(app: Sphinx) -> None:
    """Start the server, and let Jupyter find its kernels before all others of their name."""
    if app.config.nb_execution_mode == "off":
        return
    folder = tempfile.TemporaryDirectory(prefix="kernels-")
    socket_path = Path(folder.name) / "socket"
    program = [sys.executable, __file__]
    server = subprocess.Popen([*program, "serve", str(socket_path)])
    owner = os.getpid()

    def end() -> None:
        if os.getpid() == owner:  # not in the processes that Sphinx forks
            server.kill()
            server.wait()
            folder.cleanup()

    atexit.register(end)
    while not socket_path.exists():
        if server.poll() is not None:
            raise RuntimeError("the Python of the guides' kernels has ended: see its message above")
        try:
            server.wait(0.05)
        except subprocess.TimeoutExpired:
            continue
    kernel = Path(folder.name) / "kernels" / "python3"
    kernel.mkdir(parents=True)
    specification = {
        "argv": [sys.executable, "-IS", __file__, "start", str(socket_path), "-f", "{connection_file}"],
        "display_name": "Python 3 (ipykernel)",
        "language": "python",
    }
    (kernel / "kernel.json").write_text(json.dumps(specification), encoding="utf-8")
    paths = [folder.name, *filter(None, [os.environ.get("JUPYTER_PATH")])]
    os.environ["JUPYTER_PATH"] = os.pathsep.join(paths)


def setup(app: Sphinx) -> dict[str, bool]:
    """Tell Sphinx to start the server before it reads the first guide."""
    app.connect("builder-inited", provide)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


if __name__ == "__main__":
    mode, where, *rest = sys.argv[1:]
    if mode == "serve":
        serve(where)
    else:
        start(where, rest)
