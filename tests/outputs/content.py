"""Contents of a file: texts that are equal or not, and columns of numbers."""

from dataclasses import dataclass, field


@dataclass
class Column:
    """Numbers of one kind: `key` is the last part of its name, by which masks know it."""

    key: str
    numbers: list[float] = field(default_factory=list)


@dataclass
class Content:
    """`texts` in the order of the file; columns by their full names, in which a key stands last."""

    texts: list[str] = field(default_factory=list)
    columns: dict[str, Column] = field(default_factory=dict)

    def column(self, name: str, key: str | None = None) -> list[float]:
        """The numbers of the column of this name, to which more may be added."""
        return self.columns.setdefault(name, Column(name if key is None else key)).numbers
