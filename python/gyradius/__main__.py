"""``python -m gyradius``."""

from .cli import main

main()
