"""``python -m jounce`` is the command ``jounce``."""

from jounce.cli import main

raise SystemExit(main())
