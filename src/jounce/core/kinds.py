"""Registries without a central list: rows added by modules, and families of descriptions registered by subclassing."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import reduce
from importlib import import_module
from operator import or_
from pkgutil import iter_modules
from threading import RLock
from typing import Annotated, Any, TypeVar

from pydantic import BaseModel, Field, TypeAdapter
from pydantic_core import CoreSchema, core_schema

Row = TypeVar("Row")
FILE_REF = "$file"
"""Placeholder for ``$ref`` to the schema of a different file until schemas are written: pydantic follows ``$ref``."""


class Rows(Mapping[str, Row]):
    """Rows of a registry by name, added by the modules of a package, which are all imported before the first access.

    Parameters
    ----------
    package : str
        Package whose modules add the rows.
    """

    def __init__(self, package: str) -> None:
        self.package = package
        self._rows: dict[str, Row] = {}
        self._complete, self._lock = False, RLock()

    def add(self, name: str, row: Row) -> None:
        """Add a row."""
        self._rows[name] = row

    def _all(self) -> dict[str, Row]:
        with self._lock:  # no other thread may read it while modules are missing
            if not self._complete:
                self._complete = True
                for module in iter_modules(import_module(self.package).__path__):
                    import_module(f"{self.package}.{module.name}")
                self._rows = dict(
                    sorted(self._rows.items(), key=self._order)
                )  # independent of the order of imports
        return self._rows

    def _order(self, item: tuple[str, Row]) -> Any:
        return item[0]

    def __getitem__(self, name: str) -> Row:
        return self._all()[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._all())

    def __len__(self) -> int:
        return len(self._all())


class Kinds(Rows[type[Any]]):
    """Classes of a family, by the word that selects them.

    The base class of the family has it as ``kinds``; each subclass whose field ``key`` has a default is registered
    under that default, so no list has to be maintained.

    Parameters
    ----------
    key : str
        Field whose value selects the class, e.g. ``"kind"``.
    package : str
        Package whose modules define the classes.
    schema : str
        File of the family's JSON schema, to which other schemas refer.
    """

    def __init__(self, key: str, *, package: str, schema: str) -> None:
        super().__init__(package)
        self.key, self.schema = key, schema
        self._adapter: tuple[int, TypeAdapter[Any]] | None = None

    def join(self, kind: type[BaseModel]) -> None:
        """Register a class, if it defines its own value of ``key``."""
        if self.key not in vars(kind).get("__annotations__", {}):
            return
        word = kind.model_fields[self.key].default
        known = self._rows.get(word)
        if known is not None and (known.__module__, known.__qualname__) != (
            kind.__module__,
            kind.__qualname__,
        ):
            raise TypeError(
                f"{kind.__name__}: the {self.key} {word!r} is already used by {known.__name__}"
            )
        self.add(word, kind)

    def adapter(self) -> TypeAdapter[Any]:
        """Validator of any member of the family, selected by ``key``."""
        if self._adapter is None or self._adapter[0] != len(
            self
        ):  # the user may have registered a class
            members: Any = reduce(or_, self._all().values())
            told_apart: Any = Annotated[members, Field(discriminator=self.key)]
            self._adapter = len(self), TypeAdapter(told_apart)
        return self._adapter[1]

    def core_schema(self, base: type[BaseModel]) -> CoreSchema:
        """Schema of a field of the base type: a member is kept unchanged, a table is read by its ``key``."""

        def read(value: object) -> object:
            return value if isinstance(value, base) else self.adapter().validate_python(value)

        return core_schema.no_info_plain_validator_function(read)
