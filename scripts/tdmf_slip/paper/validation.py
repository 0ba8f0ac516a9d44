"""The five published gaits, by the unit, compared: with the paper, and with the reference."""

import math
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from typing import TYPE_CHECKING

from ..checks import checked_flag, checked_whole
from ..contents import ByContents
from ..drawable import Drawable
from ..fmu.fmu import FRICTION, Fmu, load_fmu
from ..fmu.parameters import read_parameters
from ..library.runner import Runner
from ..record import origin_of
from ..terminal.progress import progress_bar
from ..terminal.text import table
from . import guinea_fowl
from . import reference_gaits as reference
from .claims import WORDS, Claim, claims, gather, recorded
from .own_claims import OwnClaims, own_claims
from .reference_gaits import Drift
from .settling import DEFAULT_TOLERANCE, SettledRun, settle_fmu

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True, eq=False, repr=False)
class Validation(ByContents, Drawable):
    """The five gaits, what the paper says of them, and how far they are from the reference."""

    gaits: Sequence[SettledRun]
    """Of the unit, at the five frictions."""
    claims: Sequence[Claim]
    """The paper's statements beside what is computed; none where only the gaits were asked for."""
    drifts: Sequence[Drift]
    """Every value beside its reference."""
    own: OwnClaims = field(default_factory=lambda: OwnClaims(0, ()))
    """This project's own claims; none where they were not computed."""

    @property
    def passed(self) -> bool:
        """No computed value is farther from its recorded reference than allowed, nor a claim of our own."""
        return all(drift.passed for drift in self.drifts) and self.own.passed

    @property
    def differing(self) -> list[Claim]:
        """The statements that what is computed does not bear out."""
        return [claim for claim in self.claims if not claim.agrees]

    def plot(self) -> "Figure":
        """Every recorded value, over its deviation from the reference."""
        from ..pictures.plot import released  # Matplotlib is slow to load
        from . import drift_diagram

        return released(drift_diagram.figure_of(self.drifts))

    def __repr__(self) -> str:
        """In a line: how many statements, and how many of them differ."""
        return f"<Validation of {len(self.claims)} statements: {len(self.differing)} differ>"

    def as_json(self) -> dict[str, object]:
        """Everything as a plain object."""
        return {
            **origin_of(),
            "passed": self.passed,
            "differing": len(self.differing),
            "gaits": [{"published_word": WORDS[g.friction], **g.as_json()} for g in self.gaits],
            "claims": [{**asdict(claim), "verdict": claim.verdict} for claim in self.claims],
            "drifts": [{**asdict(drift), "passed": drift.passed} for drift in self.drifts],
            "own_claims": self.own.as_json(),
        }

    def as_text(self, program: str = "tdmf-slip") -> str:
        """The gaits, the paper's claims, the project's own, and the verdict on the reference.

        Parameters
        ----------
        program : str, default "tdmf-slip"
            How the command is called in the commands that are printed.

        Returns
        -------
        str
            Tables.
        """
        said = [self._claim_table()] if self.claims else []
        own = [self.own.as_text(program)] if self.own.claims else []
        return "\n\n".join([self._gait_table(), *said, *own, self._drift_summary()])

    def _gait_table(self) -> str:
        header = [
            "friction mu",
            "published word",
            "computed word",
            "period",
            "speed",
            "cost of transport",
            "verdict",
        ]
        rows = [
            [
                f"{gait.friction:g}",
                WORDS[gait.friction],
                gait.word,
                f"{gait.period:.5f}",
                f"{gait.speed:.6f}",
                f"{gait.cost_of_transport:.6f}",
                "same word" if gait.word == WORDS[gait.friction] else "OTHER WORD",
            ]
            for gait in self.gaits
        ]
        units = "Periods in sqrt(m/k), speeds in l0 sqrt(k/m). The paper gives no numbers for single gaits."
        return f"{table(header, rows)}\n{units}"

    def _claim_table(self) -> str:
        header = ["claim", "published", "computed", "verdict"]
        rows = [[c.what, c.published, c.computed, c.verdict] for c in self.claims]
        return f"{table(header, rows)}\n{self._differing()}"

    def _differing(self) -> str:
        """How many statements differ, of all and by who says them."""
        parts = []
        for source in dict.fromkeys(claim.source for claim in self.claims):
            of_it = [claim for claim in self.claims if claim.source == source]
            differ = sum(not claim.agrees for claim in of_it)
            parts.append(f"{differ} of the {len(of_it)} of {source}")
        return f"{len(self.differing)} of {len(self.claims)} statements differ: {', '.join(parts)}."

    def _drift_summary(self) -> str:
        missed = [drift for drift in self.drifts if not drift.passed]
        if not missed:
            of_gaits = [drift for drift in self.drifts if math.isfinite(drift.friction)]
            largest = {d.allowed: 0.0 for d in of_gaits}
            for drift in of_gaits:
                largest[drift.allowed] = max(largest[drift.allowed], drift.deviation)
            quantities, apexes = reference.QUANTITY_TOLERANCE, reference.APEX_TOLERANCE
            return (
                f"Reference: all {len(self.drifts)} recorded values are met.\nLargest relative deviation "
                f"of a gait {largest[quantities]:.1e} (allowed {quantities:g}), "
                f"of an apex {largest[apexes]:.1e} (allowed {apexes:g})."
            )
        header = ["friction mu", "what", "computed", "reference", "deviation", "allowed"]
        rows = [
            [
                f"{d.friction:g}" if math.isfinite(d.friction) else "",
                d.what,
                f"{d.computed}",
                f"{d.reference}",
                f"{d.deviation:.1e}",
                f"{d.allowed:g}",
            ]
            for d in missed
        ]
        count = f"{len(missed)} of {len(self.drifts)}"
        return f"Reference: {count} recorded values are NOT met:\n{table(header, rows)}"


def validate(
    *,
    tolerance: float = DEFAULT_TOLERANCE,
    only_gaits: bool = False,
    own: bool = False,
    seed: int = 1,
    progress: bool = False,
    fmu: Fmu | None = None,
) -> Validation:
    """Run the five published gaits through FMPy's CVODE, and compare them.

    Parameters
    ----------
    tolerance : float, default 1e-10
        Of CVODE. At 1e-9 the gait at friction 0.2 misses the reference, by 1.4e-6.
    only_gaits : bool, default False
        Leave out what the paper and this project state.
    own : bool, default False
        Also compute this project's own claims in every regime, up to an hour on two cores.
    seed : int, default 1
        Of what is drawn for that.
    progress : bool, default False
        Bars on stderr, where that is a terminal.
    fmu : Fmu, optional
        The unit to run; by default that of `fmu_path`.

    Returns
    -------
    Validation
        Passed where no value is farther from its reference than allowed.

    Raises
    ------
    RunError
        A gait was not found.

    Examples
    --------
    >>> import tdmf_slip
    >>> validation = tdmf_slip.validate()
    >>> print(validation.passed)
    True
    """
    fmu, own, seed = load_fmu(fmu), checked_flag("own", own), checked_whole("seed", seed, 0, 2**63 - 1)
    parameters = {**read_parameters("paper"), "hip.swing_clamp": True}
    gaits = []
    with progress_bar("gaits", len(WORDS), "gaits", progress) as bar:
        for friction in WORDS:
            gaits.append(settle_fmu({**parameters, FRICTION: friction}, tolerance=tolerance, fmu=fmu))
            bar.update()
    references = {known.friction: known for known in reference.gaits() if known.swing_clamp}
    drifts = [d for gait in gaits for d in reference.drifts(gait, references[gait.friction], fmu)]
    if only_gaits:
        return Validation(gaits=gaits, claims=(), drifts=drifts)
    evidence = gather(Runner.of(parameters, fmu), progress)
    drifts += [
        Drift(float("nan"), what, now, then, abs(now - then), allowed)
        for what, now, then, allowed in recorded(evidence)
    ]
    said = [*claims(evidence), *guinea_fowl.claims(guinea_fowl.fall_map())]
    of_our_own = own_claims(seed=seed, progress=progress) if own else OwnClaims(seed, ())
    return Validation(gaits=gaits, claims=said, drifts=drifts, own=of_our_own)
