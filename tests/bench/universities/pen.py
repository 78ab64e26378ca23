"""Writes an ontology of universities in OWL 2 functional syntax, facts in the order in which they are made."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TextIO


class Pen:
    """Owns the count of the facts that it has written. Names are local names of the ontology's empty prefix."""

    def __init__(self, out: TextIO) -> None:
        self._out = out
        self.facts = 0

    def begin(self, iri: str, axioms: str) -> None:
        """The head of the document and the axioms about its terms, a line each, in functional syntax."""
        self._out.write(f"Prefix(:=<{iri}#>)\nPrefix(xsd:=<http://www.w3.org/2001/XMLSchema#>)\n")
        self._out.write(f"Prefix(owl:=<http://www.w3.org/2002/07/owl#>)\nOntology(<{iri}>\n{axioms.strip()}\n")

    def end(self) -> None:
        self._out.write(")\n")

    def individual(self, name: str, *classes: str) -> str:
        """Declares an individual of these classes, and returns its name."""
        self._out.write(f"Declaration(NamedIndividual(:{name}))\n")
        for one in classes:
            self._fact(f"ClassAssertion(:{one} :{name})")
        return name

    def link(self, subject: str, name: str, *objects: str) -> None:
        for one in objects:
            self._fact(f"ObjectPropertyAssertion(:{name} :{subject} :{one})")

    def no_link(self, subject: str, name: str, target: str) -> None:
        self._fact(f"NegativeObjectPropertyAssertion(:{name} :{subject} :{target})")

    def value(self, subject: str, name: str, text: str, datatype: str = "string") -> None:
        self._fact(f'DataPropertyAssertion(:{name} :{subject} "{text}"^^xsd:{datatype})')

    def different(self, names: Iterable[str]) -> None:
        self._fact(f"DifferentIndividuals({' '.join(':' + name for name in names)})")

    def same(self, one: str, other: str) -> None:
        self._fact(f"SameIndividual(:{one} :{other})")

    def _fact(self, text: str) -> None:
        self._out.write(text + "\n")
        self.facts += 1
