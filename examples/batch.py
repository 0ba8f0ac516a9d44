"""Runs of the unit over a table of parameters, side by side: how damping and friction set speed and cost.

    python examples/batch.py [--scheduler tcp://host:8786] [--output FILE.nc]

Each row of the table is one run of the FMI unit by FMPy. Without a scheduler the rows run in threads of this
process. With one they run on the workers of that Dask cluster, which need this package installed.
"""

import argparse
import contextlib
import itertools

import tdmf_slip

DAMPINGS = (0.1, 0.2, 0.3)
FRICTIONS = (0.2, 0.43, 0.6, 1.2)
STRIDES = 20


def table():
    """Every damping with every friction."""
    return [
        {"leg.damping": damping, "ground.friction": friction}
        for damping, friction in itertools.product(DAMPINGS, FRICTIONS)
    ]


def executor_of(scheduler):
    """Executor of a Dask cluster; without a scheduler, None for threads of this process."""
    if scheduler is None:
        return contextlib.nullcontext()
    from distributed import Client

    return Client(scheduler).get_executor()


def main():
    """Run the table and print what came of it."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--scheduler", metavar="ADDRESS", help="of a Dask cluster")
    parser.add_argument("--output", metavar="FILE.nc", help="write all results as NetCDF")
    options = parser.parse_args()
    with executor_of(options.scheduler) as executor:
        runs = tdmf_slip.simulate_many(table(), strides=STRIDES, executor=executor, progress=True)
    print(f"{'damping':>8} {'friction':>9}  {'word':8} {'speed':>7} {'cost of transport':>18}")
    columns = ("leg.damping", "ground.friction", "word", "speed", "cost_of_transport")
    for damping, friction, word, speed, cost in zip(*(runs[name].values for name in columns), strict=True):
        print(f"{damping:8.2f} {friction:9.2f}  {word or '(fell)':8} {speed:7.4f} {cost:18.4f}")
    if options.output:
        runs.to_netcdf(options.output)


if __name__ == "__main__":
    main()
