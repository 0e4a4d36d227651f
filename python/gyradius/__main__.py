"""The command as it is started: ``gyradius``, or ``python -m gyradius``."""

from __future__ import annotations

import os
import sys

try:
    from .interrupt import INTERRUPTED, deaf, leave, leave_at_once
except KeyboardInterrupt:
    sys.stderr.write("gyradius: interrupted\n")
    os._exit(130)


def main() -> None:
    """Run the command."""
    leave_at_once()
    # What takes time to load is loaded here, where Ctrl-C is heard.
    from .cli import run
    from .console import prepare_streams

    prepare_streams()
    try:
        run()
    except SystemExit as end:
        if end.code == INTERRUPTED:
            leave()
        raise
    except KeyboardInterrupt:
        leave()
    finally:
        deaf()


if __name__ == "__main__":
    main()
