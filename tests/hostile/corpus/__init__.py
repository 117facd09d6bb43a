"""Bad inputs of every kind, made from good ones by a seed, and the judge that runs them in a child with limits."""
