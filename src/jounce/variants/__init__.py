"""Many runs: designs of experiments, variants side by side, and metrics of each."""
