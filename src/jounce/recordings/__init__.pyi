"""Public names of recordings, each loaded on first use."""

from .carried import recording as recording
from .files import read_columns as read_columns
from .files import read_recording as read_recording
from .files import to_pandas as to_pandas
from .files import write_recording as write_recording
from .files import write_rpc as write_rpc
from .laps import find_laps as find_laps
from .measuring import apply_sensors as apply_sensors
from .quality import check_channels as check_channels
from .quality import check_time as check_time
from .reader import Reader as Reader
from .readers import READERS as READERS
from .schema import channel_unit as channel_unit
from .schema import check_recording as check_recording
from .sensors import Sensor as Sensor
from .sensors import filter_signals as filter_signals
from .signals import band_limit as band_limit
from .signals import cfc_filter as cfc_filter
from .signals import derivative as derivative
from .signals import estimate_lag as estimate_lag
from .signals import resample as resample
from .signals import shift_signals as shift_signals
from .signals import shift_with_derivative as shift_with_derivative
