"""What triangulate() returns."""

from html import escape

from ._image import image_tag


class Result:
    """A triangulation and what is known of it.

    tin: the hodt.Tin. Its vertices are the points in their order, without dropped duplicates and
        those of no triangle (outside an outline, say), and after them the vertices that lines added.
    report: a dictionary with the names of the command's JSON. Each is an attribute, too:
        result.order, result.value["bound"], result.local_minima["result"]["interior"].
    """

    def __init__(self, tin, report):
        self.tin = tin
        self.report = report

    def __getattr__(self, name):
        if name.startswith("_") or name == "report":
            raise AttributeError(name)
        try:
            return self.report[name]
        except KeyError:
            raise AttributeError(f"a Result has no {name!r}; it has tin, report and what that has: "
                                 + ", ".join(self.report)) from None

    def __dir__(self):
        return [*super().__dir__(), *self.report]

    def __repr__(self):
        return f"<hodt.Result: {'; '.join(f'{name} {text}' for name, text in self._rows())}>"

    def _rows(self):
        rows = [("triangles", f"{self.triangles}, of order {self.order} at most")]
        first = [{"objective": self.objective, "value": self.value}] if self.value is not None else []
        for each in first + self.then:
            value = each["value"]
            reached = " (optimal)" if value["optimal"] else ""
            rows.append((each["objective"], f"{value['delaunay']:.10g} → {value['result']:.10g}, "
                         f"bound {value['bound']:.10g}{reached}"))
        for name in ("local_minima", "local_maxima", "pits"):
            if (counts := self.report[name]) is not None:
                before, after = (sum(counts[of].values()) for of in ("delaunay", "result"))
                rows.append((name.replace("_", " "), f"{before} → {after}"))
        if self.duplicates:
            rows.append(("duplicates", f"{self.duplicates} dropped"))
        return rows

    def _repr_html_(self):
        rows = "".join(f"<tr><th style='text-align:left'>{escape(name)}</th>"
                       f"<td style='text-align:left'>{escape(text)}</td></tr>"
                       for name, text in self._rows())
        return (f"<div style='display:flex;gap:1em;align-items:flex-start'>{image_tag(self.tin)}"
                f"<table>{rows}</table></div>")
