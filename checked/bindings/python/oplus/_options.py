# SPDX-License-Identifier: MIT
"""How to compute: engines and progress."""

from contextlib import contextmanager


def engines():
    """Returns the names of the algorithms that `engine` may name, the default first: 'slide' alone, or also those of
    a build with CGAL, which are under the GPL and for comparison.

    >>> oplus.engines()[0]
    'slide'
    """
    try:
        from . import _engines
    except ImportError:
        return ["slide"]
    return _engines.names()


def found(engine):
    """Returns the engine of that name for C++, None for the default."""
    if engine in (None, "slide"):
        return None
    if engine not in engines():
        raise ValueError(f"engine {engine}; expected {' or '.join(engines())}")
    from . import _engines
    return _engines.engine(engine)


def _of_bar(bar):
    """Moves a bar of tqdm, or the like."""
    def show(done, total):
        bar.total = total
        bar.update(done - bar.n)
        if done == total:
            bar.refresh()
    return show


@contextmanager
def reported(progress):
    """What C++ calls with (done, total); at the end it is called with all of them, if it ever was."""
    if progress is None:
        yield None
        return
    call = progress if callable(progress) else _of_bar(progress)
    last = []

    def tell(done, total):
        last[:] = [total]
        call(done, total)

    yield tell
    if last:
        call(*last, *last)
