"""YAML files that a user writes: read safely, numbers such as 5e-3 as numbers, no key twice."""
from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

import yaml

if TYPE_CHECKING:
    from ..typealiases import PathLike


def read(name: str, path: PathLike) -> Any:
    """The content of the YAML file `path`.

    :param name: what the file is to the user, for messages
    :raises ValueError: the file cannot be read, or is no YAML
    """
    try:
        with open(path, encoding='utf-8') as file:
            return yaml.load(file, _Loader)
    except (OSError, UnicodeDecodeError) as error:
        raise ValueError(f'{name} = {str(path)!r}: cannot be read ({getattr(error, "strerror", None) or error})') from None
    except (yaml.YAMLError, ValueError, RecursionError) as error:
        raise ValueError(f'{name} = {str(path)!r}: {" ".join(str(error).split())}') from None


class _Loader(yaml.SafeLoader):
    """YAML's safe loader that knows 5e-3 as a number, and refuses a key that comes twice in a mapping instead of taking the last."""

    def construct_mapping(self, node: yaml.MappingNode, deep: bool = False) -> dict[Any, Any]:
        keys = [key.value for key, _ in node.value if key.tag != 'tag:yaml.org,2002:merge' and isinstance(key.value, str)]
        for key in keys:
            if keys.count(key) > 1:
                raise yaml.YAMLError(f'{key} is given twice, line {node.start_mark.line + 1}')
        return super().construct_mapping(node, deep)


# Whole numbers with an exponent, such as 1e9, are texts by YAML 1.1; here they are numbers.
_Loader.add_implicit_resolver(  # type: ignore[no-untyped-call]
    'tag:yaml.org,2002:float', re.compile(r'[-+]?[0-9]+[eE][-+]?[0-9]+'), list('-+0123456789'))
