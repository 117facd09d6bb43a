"""Public names of campaigns, each loaded on first use."""

from .arrivals import FilePreviews as FilePreviews
from .arrivals import preview_files as preview_files
from .description import Campaign as Campaign
from .description import load_campaign as load_campaign
from .from_folder import FolderCampaign as FolderCampaign
from .from_folder import campaign_from_folder as campaign_from_folder
from .recogniser import RecognisedFile as RecognisedFile
from .recogniser import recognise as recognise
from .result import CampaignResult as CampaignResult
from .run import run_campaign as run_campaign
from .strategy_result import StrategyResult as StrategyResult
from .template import new_campaign as new_campaign
from .trial_result import TrialResult as TrialResult
from .truth import BenchTruth as BenchTruth
from .truth import load_truth as load_truth
