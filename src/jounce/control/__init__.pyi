# The names of the package; `lazy_loader` loads what is used.

from .actuators import ActiveActuator as ActiveActuator
from .actuators import MagnetorheologicalDamper as MagnetorheologicalDamper
from .actuators import SemiActiveDamper as SemiActiveDamper
from .controller import CONTROLS as CONTROLS
from .controller import Controller as Controller
from .controller import PythonControl as PythonControl
from .controller import as_controller as as_controller
from .controller import controller as controller
from .design import CornerModel as CornerModel
from .fmu.component import FmuComponent as FmuComponent
from .fmu.component import FmuVariable as FmuVariable
from .fmu.component import read_fmu as read_fmu

# isort: split
# Written by `make faces`: members of the registries.
from .fmu.controller import FmuControl as FmuControl
from .laws import ADD as ADD
from .laws import LQG as LQG
from .laws import LQR as LQR
from .laws import PID as PID
from .laws import SHADD as SHADD
from .laws import Groundhook as Groundhook
from .laws import HInfinity as HInfinity
from .laws import Hybrid as Hybrid
from .laws import Passive as Passive
from .laws import Skyhook as Skyhook
from .laws import TwoStateGroundhook as TwoStateGroundhook
from .laws import TwoStateSkyhook as TwoStateSkyhook
from .preview import PreviewMPC as PreviewMPC
