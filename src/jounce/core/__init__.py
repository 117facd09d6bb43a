"""Foundations: units, errors, findings, descriptions, serialisation."""
