"""Operations as data: what faces ask for, and how a request is run, written as a command or as Python.

``index.json`` holds them as ``make faces`` read them from the functions, so that a face shows help and forms without
importing what computes.
"""
