# The names of the package; `lazy_loader` loads what is used.

from .derivatives import Gradient as Gradient
from .derivatives import gradient as gradient
from .derivatives import sensitivities as sensitivities
from .free_run import simulate_mechanism as simulate_mechanism
from .linear_model import LinearModel as LinearModel
from .linear_model import Mode as Mode
from .linear_model import equilibrium as equilibrium
from .linear_model import linearise as linearise
from .linear_model import modes as modes
from .run import simulate as simulate
from .settings import RunSettings as RunSettings
