"""Controlled suspensions: actuators, sensors, and control laws as symbols or Python functions."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
