"""Plain data out of the core's JSON: keys that a record does not know are ignored."""

from __future__ import annotations

from dataclasses import fields
from typing import Any, TypeVar

Record = TypeVar("Record")


def record(kind: type[Record], item: dict[str, Any]) -> Record:
    """One record of a dataclass; lists become tuples."""
    known = [field.name for field in fields(kind)]  # type: ignore[arg-type]
    return kind(**{name: frozen(item[name]) for name in known if name in item})


def records(kind: type[Record], items: list[dict[str, Any]]) -> tuple[Record, ...]:
    """Records in their order."""
    return tuple(record(kind, item) for item in items)


def frozen(value: Any) -> Any:
    """Lists as tuples, however deep."""
    return tuple(frozen(item) for item in value) if isinstance(value, list | tuple) else value
