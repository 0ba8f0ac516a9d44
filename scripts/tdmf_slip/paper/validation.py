"""The paper's gaits and statements beside computed ones, for both readings of its swing law."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass

from ..checks import checked_flag, checked_whole
from ..fmu.fmu import Fmu, load_fmu
from ..library.runner import Runner
from ..record import origin_of
from ..terminal.progress import progress_bar
from ..terminal.text import table
from ..variables.parameters import read_parameters
from . import guinea_fowl, human_running, published
from . import reference_gaits as reference
from .claims import PAPER, READINGS, WORDS, Claim, Group, of_group
from .evidence import Evidence
from .reference_gaits import Drift
from .settling import DEFAULT_TOLERANCE, SettledRun, settle_fmu
from .statements.own_claims import LAST_SEED, Recomputed, own_claims, text_of

SHOWN = ("period", "speed", "cost_of_transport")
"""Quantities in the table of the gaits."""


@dataclass(frozen=True, eq=False, repr=False)
class Validation:
    """The five gaits in both readings, the published statements about them, and their reference."""

    gaits: Mapping[str, Sequence[SettledRun]]
    """Gaits of the unit at the five frictions, by reading."""
    claims: Sequence[Claim]
    """The paper's statements beside what is computed; none where only the gaits were asked for."""
    drifts: Sequence[Drift]
    """Every value beside its reference."""
    others: Sequence[Claim] = ()
    """Statements of other papers, on guinea fowl and on human running."""
    own: Sequence[Recomputed] = ()
    """This project's own claims; none where they were not computed."""

    @property
    def passed(self) -> bool:
        """True if all computed values are near enough to their references, and our own claims hold."""
        return all(drift.passed for drift in self.drifts) and all(claim.holds for claim in self.own)

    @property
    def counts(self) -> dict[str, int]:
        """Number of the paper's statements, by the name of their group."""
        return {group.name.lower(): len(of_group(self.claims, group)) for group in Group}

    def __repr__(self) -> str:
        """Number of statements, in all and in each group, in one line."""
        return f"<Validation of {len(self.claims)} statements: {self._counted()}>"

    def as_json(self) -> dict[str, object]:
        """Everything as a plain object."""
        return {
            **origin_of(),
            "passed": self.passed,
            "counts": self.counts,
            "gaits": [
                {"reading": reading, "published_word": WORDS[gait.friction], **gait.as_json()}
                for reading, gaits in self.gaits.items()
                for gait in gaits
            ],
            "claims": [claim.as_json() for claim in self.claims],
            "other_papers": [claim.as_json() for claim in self.others],
            "drifts": [{**asdict(drift), "passed": drift.passed} for drift in self.drifts],
            "own_claims": [claim.as_json() for claim in self.own],
        }

    def as_text(self, program: str = "tdmf-slip") -> str:
        """The gaits, the statements of the paper, of others and of ours, and the verdict on the reference.

        Parameters
        ----------
        program : str, default "tdmf-slip"
            Name of the command in the commands that are printed.

        Returns
        -------
        str
            Tables.
        """
        groups = [_table(group.value, of_group(self.claims, group)) for group in Group]
        counted = f"{len(self.claims)} statements of {PAPER}: {self._counted()}." if self.claims else ""
        said = [*groups, counted, _table("Other papers", self.others), text_of(self.own, program)]
        return "\n\n".join([self._gait_table(), *filter(None, said), self._drift_summary()])

    def _gait_table(self) -> str:
        header = ["friction", "paper"]
        for reading in self.gaits:
            header += [reading, "period", "speed", "cost"]
        rows = []
        for row in zip(*self.gaits.values(), strict=True):
            cells = [f"{row[0].friction:g}", WORDS[row[0].friction]]
            for gait in row:
                period, speed, cost = (gait.stride[name] for name in SHOWN)
                cells += [gait.word, f"{period:.4f}", f"{speed:.5f}", f"{cost:.5f}"]
            same = all(gait.word == WORDS[gait.friction] for gait in row)
            rows.append([*cells, "same words" if same else "OTHER"])
        notes = [
            "Gait words of the paper and of both readings of (12): free swing (hip.swing_clamp = false,",
            "the default) and clamp (true). Periods in sqrt(m/k), speeds in l0 sqrt(k/m); the paper gives",
            "no such numbers.",
        ]
        return "\n".join([table([*header, "verdict"], rows), *notes])

    def _counted(self) -> str:
        """Number of statements in each group, in words."""
        names = {
            Group.AGREES: "agree",
            Group.CORRECTION: "depend on the correction of a misprint",
            Group.BEYOND: "were beyond what the paper could compute",
            Group.DIFFERS: "differ",
        }
        counts = self.counts
        return ", ".join(f"{counts[group.name.lower()]} {name}" for group, name in names.items())

    def _drift_summary(self) -> str:
        missed = [drift for drift in self.drifts if not drift.passed]
        if not missed:
            quantities, apexes = reference.QUANTITY_TOLERANCE, reference.APEX_TOLERANCE
            of_gaits = [drift for drift in self.drifts if math.isfinite(drift.friction)]
            largest = {
                allowed: max((of.deviation for of in of_gaits if of.allowed == allowed), default=0.0)
                for allowed in (quantities, apexes)
            }
            return (
                f"Reference: all {len(self.drifts)} recorded values are met.\nLargest relative deviation "
                f"of a gait {largest[quantities]:.1e} (allowed {quantities:g}), "
                f"of an apex {largest[apexes]:.1e} (allowed {apexes:g})."
            )
        header = ["friction mu", "reading", "what", "computed", "reference", "deviation", "allowed"]
        rows = []
        for one in missed:
            friction = f"{one.friction:g}" if math.isfinite(one.friction) else ""
            values = f"{one.computed}", f"{one.reference}", f"{one.deviation:.1e}", f"{one.allowed:g}"
            rows.append([friction, one.reading, one.what, *values])
        count = f"{len(missed)} of {len(self.drifts)}"
        return f"Reference: {count} recorded values are NOT met:\n{table(header, rows)}"


def _table(heading: str, claims: Sequence[Claim]) -> str:
    """Statements under a heading, each with its section of the paper or its source; nothing without any."""
    if not claims:
        return ""
    header = ["section" if claims[0].where else "source", "statement", "published", *READINGS, "verdict"]
    rows = [[c.where or c.source, c.what, c.published, *_findings(c), c.verdict] for c in claims]
    return f"{heading}\n{table(header, rows)}"


def _findings(claim: Claim) -> list[str]:
    """Finding of each reading, or "same" if it equals that of the default."""
    first, *rest = (claim.computed[reading].text for reading in READINGS)
    return [first, *("same" if text == first else text for text in rest)]


def validate(
    *,
    tolerance: float = DEFAULT_TOLERANCE,
    only_gaits: bool = False,
    own: bool = False,
    seed: int = 1,
    progress: bool = False,
    fmu: Fmu | None = None,
) -> Validation:
    """Run the unit by FMPy's CVODE on the five gaits in both readings, and compare them with the paper.

    Parameters
    ----------
    tolerance : float, default 1e-10
        Relative tolerance of CVODE. At 1e-9 the gait at friction 0.2 misses the reference by 1.4e-6.
    only_gaits : bool, default False
        Leave out the statements of the paper and this project's own claims.
    own : bool, default False
        Also compute this project's own claims in every regime, which takes some minutes.
    seed : int, default 1
        Seed of the random numbers in this project's own claims.
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
    fmu, own, seed = load_fmu(fmu), checked_flag("own", own), checked_whole("seed", seed, 0, LAST_SEED)
    evidence = {
        reading: Evidence(Runner({**read_parameters("paper"), "hip.swing_clamp": value}), progress)
        for reading, value in READINGS.items()
    }
    gaits: dict[str, list[SettledRun]] = {reading: [] for reading in READINGS}
    with progress_bar("gaits", len(WORDS) * len(READINGS), "gaits", progress) as bar:
        for reading, known in evidence.items():
            for gait in known.five:  # from elsewhere the unit would settle in more strides
                gaits[reading].append(settle_fmu(gait.start_values, tolerance=tolerance, fmu=fmu))
                bar.update()
    references = {(known.swing_clamp, known.friction): known for known in reference.gaits()}
    drifts = [
        drift
        for reading, runs in gaits.items()
        for run in runs
        for drift in reference.drifts(run, references[READINGS[reading], run.friction])
    ]
    if only_gaits:
        return Validation(gaits=gaits, claims=(), drifts=drifts)
    for reading, of_reading in evidence.items():
        drifts += reference.sweep_drifts(reading, of_reading)
    return Validation(
        gaits=gaits,
        claims=published.claims(evidence),
        drifts=[*drifts, *reference.classic_drifts()],
        others=[*guinea_fowl.claims(guinea_fowl.fall_map()), *human_running.claims()],
        own=own_claims(seed=seed, progress=progress) if own else (),
    )
