"""Runtime hook of a frozen application: in child processes of jounce it acts as a Python interpreter.

jounce starts ``sys.executable`` with code (``-P -c``) or with a file (``-I``). In a frozen application this is the
application itself, which would otherwise start a second time.
"""

import runpy
import sys

if sys.argv[1:3] == ["-P", "-c"]:
    code = sys.argv[3]
    sys.argv[:] = ["-c", *sys.argv[4:]]
    exec(code, {"__name__": "__main__"})  # noqa: S102 - code passed by jounce itself
    sys.exit()
if sys.argv[1:2] == ["-I"]:
    sys.argv[:] = [word for word in sys.argv[1:] if word not in ("-I", "-S")]
    runpy.run_path(sys.argv[0], run_name="__main__")
    sys.exit()
