# SPDX-License-Identifier: MIT
"""What invalid input raises."""


class InvalidInput(ValueError):
    """Invalid input. The message is one line: what is wrong and what was expected.

    Its parts: `place`, what it is about ('region', 'text', a file, 'pair 3, q'); `line` and `column` in text, else
    None; `wrong`; `expected`; and `index`, which of many in a batch or in arrays, else None.

    >>> try: oplus.Region('POLYGON ((0 0, 1 0, x 1))')
    ... except oplus.InvalidInput as error: error.place, error.line, error.column
    ('text', 1, 21)
    """

    place = line = column = wrong = expected = index = None

    def __init__(self, message, **parts):
        super().__init__(message)
        self.__dict__.update(parts)
