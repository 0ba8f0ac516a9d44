"""Error with which a proof ends where it cannot decide."""


class UndecidedError(Exception):
    """A guard, a sign or an inclusion that the enclosures leave open; it says nothing about the gait."""

    def __init__(self, guard: str, time: float | None = None) -> None:
        """Open statement, and its time in the stride."""
        super().__init__(guard)
        self.guard, self.time = guard, time
