"""Damage that files may come to: what is drawn of it, and how it is done to a file."""
import os
import shutil

from hypothesis import strategies as st

position = st.floats(0, 1, exclude_max=True)
damage = st.one_of(
    st.tuples(st.just('cut'), position), st.tuples(st.just('bit'), position, st.integers(0, 7)),
    st.tuples(st.just('bytes'), position, st.binary(min_size=1, max_size=40)), st.tuples(st.just('whole'), st.binary(max_size=40)),
    st.tuples(st.just('zeros'), position), st.tuples(st.just('append'), st.binary(min_size=1, max_size=20)), st.tuples(st.just('twice')),
    st.tuples(st.just('digit'), position, st.sampled_from(b'0123456789.-e"[]{},')), st.tuples(st.just('other'), st.integers(0, 9)),
    st.tuples(st.just('huge'), st.sampled_from((b'[', b'{"a":', b'9', b'1,', b'\0'))))


def damaged(content, kind, *how):
    """`content` (bytes) with one kind of damage."""
    at = int(how[0] * len(content)) if how and isinstance(how[0], float) else 0
    if kind == 'cut':
        return content[:at]
    if kind == 'bit':
        return content[:at] + bytes([content[at] ^ 1 << how[1]]) + content[at + 1:] if content else b''
    if kind in ('bytes', 'digit'):
        new = how[1] if kind == 'bytes' else bytes([how[1]])
        return content[:at] + new + content[at + len(new):]
    if kind == 'zeros':
        return content[:at] + bytes(len(content) - at)
    return {'whole': lambda: how[0], 'append': lambda: content + how[0], 'twice': lambda: 2 * content, 'huge': lambda: 20000 * how[0]}[kind]()


def copyWith(folder, target, name, how):
    """Copy the `folder` to `target` with the file `name` damaged. Returns whether it is another content than before."""
    shutil.rmtree(target, ignore_errors=True)
    shutil.copytree(folder, target)
    path = os.path.join(target, name)
    with open(path, 'rb') as stream:
        content = stream.read()
    if how[0] == 'other':
        others = sorted(entry.path for entry in os.scandir(os.path.dirname(os.path.join(folder, name))) if entry.is_file())
        shutil.copy(others[how[1] % len(others)], path)
    else:
        with open(path, 'wb') as stream:
            stream.write(damaged(content, *how))
    with open(path, 'rb') as stream:
        return stream.read() != content
