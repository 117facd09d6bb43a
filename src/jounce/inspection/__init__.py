"""Shock-absorber inspection: tester records, the values of each wheel, and their uncertainty.

The public names are listed in ``__init__.pyi``; each is loaded on first use.
"""

import lazy_loader

from jounce.core.old_names import with_old_names

_load, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
__getattr__ = with_old_names(__name__, {"Corner": "LinearQuarterCar"}, _load)
