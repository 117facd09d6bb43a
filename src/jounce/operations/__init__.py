"""Operations as data: parameters for commands and pages, and requests that run or become a command or Python.

``index.json`` holds them as ``make faces`` read them from the functions, so that a face shows help and forms without
importing what computes.
"""
