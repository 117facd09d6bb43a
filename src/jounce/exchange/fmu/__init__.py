"""Functional Mock-up Units: a rig as a component of another simulation.

``graphs`` collects the functions of a model, ``code`` converts them to C, ``variables`` lists the variables for
importers, ``description`` writes that list in the format of FMI 2.0 or 3.0, ``build`` compiles, and ``export``
assembles the archive. ``c/`` has the code common to all FMUs: ``core.c`` implements an instance with its events,
equilibrium and steps; ``fmi2.c`` and ``fmi3.c`` are thin interfaces to it.
"""

from jounce.exchange.fmu.export import FmuExport, export_fmu

__all__ = ["FmuExport", "export_fmu"]
