"""Public names of the workbench, each loaded on first use."""

from .serving import serve as serve
