"""The report of a bench campaign."""

from __future__ import annotations

from jounce.report.campaign.write import campaign_page, write_campaign

__all__ = ["campaign_page", "write_campaign"]
