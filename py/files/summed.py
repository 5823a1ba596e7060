"""XML files that end with the sum (SHA-256) of all before it, in a comment: damage is noticed before anybody reads them.

VTK takes much that is damaged for another content, and may end the whole process over it.
"""
from __future__ import annotations

import hashlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ..typealiases import PathLike


def seal(content: Any) -> bytes:
    """The last line, in bytes, of a file with the `content`, or with the sum that a hash object has."""
    total = content if hasattr(content, 'hexdigest') else hashlib.sha256(content)
    return f'\n<!-- SHA-256 {total.hexdigest()} -->\n'.encode()


def sealFile(path: PathLike) -> None:
    """Add that line to a file that is complete but for it."""
    with open(path, 'r+b') as file:
        total = hashlib.file_digest(file, 'sha256')
        file.seek(0, 2)
        file.write(seal(total))


def intact(path: PathLike) -> bool:
    """Whether the file is as it was sealed."""
    with open(path, 'rb') as file:
        content = memoryview(file.read())
    length = len(seal(b''))
    return bytes(content[-length:]) == seal(content[:-length])
