"""The command `tdmf-slip`, also `python -m tdmf_slip`."""

import os
import sys

from .cli import interrupts


def main() -> int:
    """Run the command line; the exit status. An interrupt waits until modules are loaded."""
    interrupts.end_in_order()
    # The matrices have a handful of rows: threads of BLAS beside the engine's own cost a start and gain
    # nothing.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    # FMPy's CVODE prints, on stdout too, what its status says anyway. SUNDIALS reads this at its first use.
    for log in ("SUNLOGGER_WARNING_FILENAME", "SUNLOGGER_ERROR_FILENAME"):
        os.environ.setdefault(log, os.devnull)
    try:
        with interrupts.deferred():
            from .cli import main as command
    except KeyboardInterrupt:
        print("tdmf-slip: interrupted", file=sys.stderr)
        return 130
    status = command.main()
    interrupts.ignored()  # all is done, but for Python's own end
    return status


if __name__ == "__main__":
    sys.exit(main())
