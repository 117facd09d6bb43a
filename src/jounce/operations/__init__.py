"""Operations as data: parameters for commands and pages, and requests that run or become a command or Python.

``make faces`` extracts them from the functions into ``index.json``. A front end can then show help and forms without
importing the numerical code.
"""
