"""A user's function as a law from apex to settings, which are checked at each stride."""

from collections.abc import Callable, Mapping, Sequence
from typing import TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import InputError
from ..library.population import numbers
from ..library.recorded_strides import GROUND, Request
from ..library.rough_ground import RoughGround
from ..library.settings import check_acts, checked_values, setting_number
from ..variables.table import by_full_name

Law: TypeAlias = Callable[[NDArray[np.float64]], Mapping[str, ArrayLike]]
"""From apices, shape (runners, n), to settings by name, shape (runners,) or one for all."""


class FunctionLaw:
    """A user's function, whose settings are checked; `stride_begins` is called before each stride."""

    def __init__(self, law: Law, request: Request, stride_begins: Callable[[], object]) -> None:
        self.law, self.request, self.stride_begins = law, request, stride_begins
        self.names: tuple[str, ...] | None = None

    def __call__(
        self, stride: int, apices: NDArray[np.float64], under_way: NDArray[np.bool_]
    ) -> dict[str, NDArray[np.float64]]:
        """What is set at the apices of a stride, as `recorded_strides` asks for it."""
        self.stride_begins()
        what = f"law: stride {stride}: what it gives"
        given = by_full_name(self.law(apices), what, "numbers or arrays by name")
        if self.names is None:
            self._check_names(tuple(given))
        names = self.names or ()
        if set(given) != set(names):
            raise InputError(
                f"law: stride {stride}: {', '.join(given)}; allowed: {', '.join(names)}, as at first"
            )
        return {name: self._values(name, given[name], stride, under_way) for name in names}

    def _check_names(self, names: tuple[str, ...]) -> None:
        request = self.request
        for name in names:
            setting_number(name, "law")
            check_acts(
                name, request.population.runner, (*names, *request.given, *request.population.varied), "law"
            )
        check_set(names, tuple(request.given), request.ground, "law")
        self.names = names

    def _values(
        self, name: str, given: ArrayLike, stride: int, under_way: NDArray[np.bool_]
    ) -> NDArray[np.float64]:
        values = numbers(f"law: stride {stride}: {name}", given, 1)
        if values.shape not in ((), (1,), under_way.shape):
            raise InputError(
                f"law: stride {stride}: {name} of shape {values.shape}; allowed: {under_way.shape}, "
                "or one for all"
            )
        of_all = np.broadcast_to(values, under_way.shape)
        usual = self.request.population.runner[name]
        first = {"runner": 0}
        return checked_values(name, np.where(under_way, of_all, usual), f"law: stride {stride}", first)


def check_set(names: Sequence[str], by_others: Sequence[str], ground: RoughGround, what: str) -> None:
    """Refuse settings that are set by others, too."""
    for name in names:
        if name in by_others:
            raise InputError(f"{what}: {name} is in the inputs, too; allowed: in one of them")
        if name == GROUND and ground.roughness:
            raise InputError(f"{what}: {name} on rough ground, whose steps set it; allowed: on level ground")
