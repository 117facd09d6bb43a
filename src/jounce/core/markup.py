"""Read XML of foreign files; document types are refused because they can declare entities that exhaust memory."""

from __future__ import annotations

import xml.etree.ElementTree as ET


class _WithoutDoctype(ET.TreeBuilder):
    """Tree builder that refuses a document type."""

    def doctype(self, name: str, pubid: str | None, system: str | None) -> None:  # noqa: ARG002
        raise ET.ParseError("a document type")


def parse_xml(text: bytes) -> ET.Element:
    """Return the root of a document; raise ``ParseError``, ``ValueError`` or ``LookupError`` if it is invalid."""
    return ET.fromstring(text, ET.XMLParser(target=_WithoutDoctype()))
