"""Public names of campaigns, each loaded on first use."""

from .description import Campaign as Campaign
from .description import load_campaign as load_campaign
from .from_folder import FolderCampaign as FolderCampaign
from .from_folder import campaign_from_folder as campaign_from_folder
from .recogniser import RecognisedFile as RecognisedFile
from .recogniser import recognise as recognise
from .result import CampaignResult as CampaignResult
from .result import StrategyResult as StrategyResult
from .result import TrialResult as TrialResult
from .run import run_campaign as run_campaign
from .template import new_campaign as new_campaign
from .truth import BenchTruth as BenchTruth
from .truth import load_truth as load_truth
