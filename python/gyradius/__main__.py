"""The command as it is started: ``gyradius``, or ``python -m gyradius``."""

from __future__ import annotations

import os
import sys
from contextlib import suppress

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
    from .console import prepare_streams, silence_standard_output

    prepare_streams()
    try:
        run()
    except SystemExit as end:
        if end.code == INTERRUPTED:
            leave()
        raise
    except KeyboardInterrupt:
        leave()
    except OSError as error:
        # Help and the version are written before any command handles its errors.
        silence_standard_output()
        with suppress(OSError):
            sys.stderr.write(f"gyradius: standard output: {error.strerror or error}\n")
        sys.exit(2)
    finally:
        deaf()


if __name__ == "__main__":
    main()
