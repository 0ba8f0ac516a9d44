"""How many runs of the unit ended."""

from dataclasses import dataclass

from ..labelled import LabelledArrays


@dataclass(frozen=True, eq=False, repr=False)
class Runs(LabelledArrays):
    """Runs of the unit: `runs["speed"]` is an array with the last stride's speed of each run."""

    def __repr__(self) -> str:
        """In a line: how many, how many fell, and how many have no result."""
        fell, failed = int(self["fallen"].sum()), sum(map(bool, self["problem"]))
        return f"<Runs of {len(self['fallen']):,} runners: {fell:,} fell, {failed:,} without a result>"
