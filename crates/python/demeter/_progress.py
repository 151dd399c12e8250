"""The bar of ``run(progress=True)``."""

import sys
from typing import Any, Dict

_WIDTH = 24


class Bar:
    """One line on standard error that is written anew; in notebooks, too."""

    def __init__(self) -> None:
        self._length = 0

    def __call__(self, told: Dict[str, Any]) -> None:
        share = min(told["step"] / max(told["steps"], 1), 1.0)
        full = int(share * _WIDTH)
        line = (
            f"{'#' * full}{'.' * (_WIDTH - full)} {100 * share:3.0f} %  {told['stage']} "
            f"({told['stage_number']}/{told['stages']})  {told['time']:.4g} s  "
            f"{told['grains'] * told['steps_per_second']:.2g} grain-steps/s  {_wait(told['seconds_left'])} left"
        )
        sys.stderr.write("\r" + line.ljust(self._length))
        sys.stderr.flush()
        self._length = len(line)

    def close(self) -> None:
        """Ends the line."""
        if self._length:
            sys.stderr.write("\n")
            sys.stderr.flush()
            self._length = 0


def _wait(seconds: float) -> str:
    if seconds < 100:
        return f"{seconds:.0f} s"
    if seconds < 6000:
        return f"{seconds / 60:.0f} min"
    return f"{seconds / 3600:.1f} h"
