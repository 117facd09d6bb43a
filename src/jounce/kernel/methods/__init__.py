"""Integration methods: adaptive steps, explicit or implicit, and exact propagation of piecewise linear models."""
