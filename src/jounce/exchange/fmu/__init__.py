"""Functional Mock-up Units: a rig as a component of another simulation.

``graphs`` lists the functions of a model, ``code`` writes them as C, ``variables`` lists what an importer sees,
``description`` writes that list as FMI 2.0 and 3.0 ask, ``build`` compiles, ``export`` puts the archive together.
``c/`` has the common code of all FMUs: ``core.c`` is the instance with its events, equilibrium and steps, ``fmi2.c``
and ``fmi3.c`` are thin faces over it.
"""

from jounce.exchange.fmu.export import FmuExport, export_fmu

__all__ = ["FmuExport", "export_fmu"]
