"""The unit of a page whose variables are declared by a modelDescription.xml."""

from types import SimpleNamespace as Record
from xml.etree import ElementTree

from .errors import PageError
from .unit import LARGEST, TYPES, Guard, Unit

KINDS = {name: kind for kind, name in TYPES.items()}
SETTINGS = {"solver.relative_tolerance": "TOLERANCE", "solver.method": "METHOD"}
WORK = {f"solver.{name}": f"WORK_{name.upper()}" for name in ("steps", "evaluations", "layer_steps")}


class DeclaredUnit(Unit):
    """The unit of a page, with the variables of a modelDescription.xml in place of the page's own.

    `guards` gives the events, or the observed quantity, behind an indicator that is called otherwise.
    `terminates` is the setting that asks to terminate where a run has ended.
    """

    def __init__(self, page, source, guards, terminates):
        self.source, self.guard_events = ElementTree.parse(source).getroot(), guards
        self.settings = SETTINGS | {terminates: "TERMINATES"}
        super().__init__(page)

    def add_all(self):
        """Add the declared variables, each with the place of the page's own."""
        rates = [v[0].get("derivative") for v in self.source.find("ModelVariables")]
        order = {name: number for number, name in enumerate(filter(None, rates))}
        self.world.states.sort(key=lambda name: order[self.model.public(name)])
        super().add_all()
        self.own, self.rows = {row.name: row for row in self.rows}, []
        types = {t.get("name"): t[0].attrib for t in self.source.find("TypeDefinitions")}
        for element in self.source.find("ModelVariables"):
            self.rows.append(self.declared(element, types))
        rows = [row for row in self.rows if row.storage == "GUARD"]
        names = [row.name.removeprefix("guard.") for row in rows]
        behind = {name: self.guard_events.get(name, [name]) for name in names}
        for number, row in enumerate(rows):
            row.offset = number
        self.event_names |= {event: name for name, events in behind.items() for event in events}
        self.guards = {
            name: Guard([], self.guards[of[0]].into) if of[0] in self.page.observed else Guard(of, None)
            for name, of in behind.items()
        }

    def declared(self, element, types):
        """The row of a declared variable."""
        value, name = element[0], element.get("name")
        unit = types.get(value.get("declaredType"), {}).get("unit") or value.get("unit") or "1"
        causality, variability, initial = (element.get(k) for k in ("causality", "variability", "initial"))
        own = self.own.get(name)
        place = self.place_of(name, own)
        within = {
            word: float(value.get(k)) for k, word in (("min", "least"), ("max", "most")) if value.get(k)
        }
        kind = KINDS.get(value.tag, own.kind if own else int)
        if value.tag == "Enumeration":
            kind = own.kind if own else ("native", "cvode")
        start = {"true": 1.0, "false": 0.0}.get(value.get("start"), value.get("start"))
        row = {"name": name, "unit": unit, "causality": causality, "variability": variability}
        row |= {"initial": initial, "start": start, "kind": kind, "about": element.get("description")}
        row |= {"largest": own.largest if own else LARGEST, "derivative": None, "depends": set()}
        row |= {"within": within if kind is float else {}, "storage": place[0], "offset": place[1]}
        row |= {"is_set": initial == "exact" or causality == "input", "reinit": value.get("reinit") == "true"}
        return Record(**row)

    def place_of(self, name, own):
        """Storage and offset of a variable in the run of a page."""
        if name in self.settings:
            return "SETTING", f"SETTING_{self.settings[name]}"
        if name in WORK:
            return "WORK", WORK[name]
        if name.startswith("guard."):
            return "GUARD", 0
        if own is None:
            raise PageError(f"has no `{name}`, which its modelDescription.xml declares")
        return own.storage, own.offset
