"""Bench campaigns: from a folder of measurements to an updated model with its evidence."""

from jounce.campaign.description import Campaign, load_campaign
from jounce.campaign.result import CampaignResult, StrategyResult, TrialResult
from jounce.campaign.run import run_campaign
from jounce.campaign.template import new_campaign
from jounce.campaign.truth import BenchTruth, load_truth

__all__ = [
    "BenchTruth",
    "Campaign",
    "CampaignResult",
    "StrategyResult",
    "TrialResult",
    "load_campaign",
    "load_truth",
    "new_campaign",
    "run_campaign",
]
