# The names of the package; `lazy_loader` loads what is used.

from .evaluation import evaluate as evaluate
from .grading import GradedInspection as GradedInspection
from .grading import VehicleGrade as VehicleGrade
from .grading import grade as grade
from .grading import grade_vehicle as grade_vehicle
from .limits import Limits as Limits
from .limits import load_limits as load_limits
from .quarter_car import LinearQuarterCar as LinearQuarterCar
from .quarter_car import SteadyState as SteadyState
from .quarter_car import force_response as force_response
from .quarter_car import steady_state as steady_state
from .record import read_record as read_record
from .result import Inspection as Inspection
from .result import WheelCurves as WheelCurves
from .result import WheelResult as WheelResult
from .signals import PlateCalibration as PlateCalibration
from .signals import calibrate_plate as calibrate_plate
