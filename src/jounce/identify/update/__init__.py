"""Model updating with exact sensitivities."""

from jounce.identify.update.problem import FitTrial
from jounce.identify.update.update import UpdatedParameter, UpdateResult, update_model

__all__ = ["FitTrial", "UpdateResult", "UpdatedParameter", "update_model"]
