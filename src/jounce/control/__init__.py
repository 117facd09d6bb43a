"""Controlled suspensions: actuators, sensors, laws as symbols or Python functions; models and runs are elsewhere."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
