"""Bench campaigns: from a folder of measurements to an updated model with its evidence."""

from jounce.campaign.description import Campaign, load_campaign
from jounce.campaign.result import CampaignResult, StrategyResult, TrialResult
from jounce.campaign.run import run_campaign
from jounce.campaign.template import new_campaign

__all__ = [
    "Campaign",
    "CampaignResult",
    "StrategyResult",
    "TrialResult",
    "load_campaign",
    "new_campaign",
    "run_campaign",
]
