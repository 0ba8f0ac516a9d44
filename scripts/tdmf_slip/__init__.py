"""TDMF-SLIP: a spring-legged runner whose foot can stick, slip, lift off and land (Or and Moravia 2016).

    >>> import tdmf_slip
    >>> run = tdmf_slip.simulate({"ground.friction": 0.43}, strides=3)
    >>> run.attrs["stride.word"], run.fallen

`simulate` runs the FMI unit once, also over the uneven ground of a `Profile`, and `simulate_many` once for
each of many runners; `find_gait` finds the periodic gait of a `Runner` with its eigenvalues, or the one that
has a given speed or the like, `sweep` gaits over a range, `continue_branch` a branch of gaits through folds
with its bifurcations, `basin` what a gait attracts, `viability` what some choice of actions can save;
`dead_beat`, `lqr` and `place_poles` make a feedback that holds a gait; `fit` fits a runner to measured gaits;
`optimize` finds the best runner; `stride_map` makes strides of many runners at once; `prove`, `prove_border`
and `prove_attraction` prove by interval arithmetic; `validate` compares with what the paper publishes.
`fmu_path` is the unit itself, for any other importer.

Each sub-package imports only those before it: `terminal`, `numerics` and `files`, which know no runner;
`variables`, the table; `fmu`, which alone loads FMPy; `library`, `analysis`, `feedback`, `fitting`,
`optimization`, `proof`, `viable_sets`, `pictures`; `paper`; `cli`, the command line.

A module is loaded when a name of it is first used; `__init__.pyi` lists the names and their modules.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
