"""Model updating with exact sensitivities."""

from jounce.identify.update.free import check_free
from jounce.identify.update.problem import FitTrial
from jounce.identify.update.update import UpdatedParameter, UpdateResult, update_model

__all__ = ["FitTrial", "UpdateResult", "UpdatedParameter", "check_free", "update_model"]
