"""Whole jobs: they return results, the faces write them."""
