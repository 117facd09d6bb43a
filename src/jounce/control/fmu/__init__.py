"""FMUs of other tools as controllers and force elements.

``component`` reads the description of an FMU and unpacks it, ``caller`` calls its C functions in this process or in a
child process, and ``controller`` connects it to the corners of a car.
"""

from jounce.control.fmu.component import FmuComponent, FmuVariable, read_fmu
from jounce.control.fmu.controller import FmuControl

__all__ = ["FmuComponent", "FmuControl", "FmuVariable", "read_fmu"]
