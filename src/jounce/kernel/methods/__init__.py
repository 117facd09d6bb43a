"""Ways through a run: adaptive steps, explicit or implicit, and exact propagation of what is piecewise linear."""
