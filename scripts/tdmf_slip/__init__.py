"""TDMF-SLIP: a spring-legged runner whose foot can stick, slip, lift off and land (Or and Moravia 2016).

    >>> import tdmf_slip
    >>> run = tdmf_slip.simulate({"ground.friction": 0.43}, strides=3)
    >>> run.stride["word"], run.fallen

`simulate` runs the FMI unit once, `periodic_gait` runs it until its strides repeat, `validate` compares the
five gaits that the paper publishes; `fmu_path` is the unit itself, for any other importer. What is loaded is
what is used: the names and their modules are in `__init__.pyi`.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
