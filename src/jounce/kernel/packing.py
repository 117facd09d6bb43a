"""Vectorisation of equal parts: operations that several parts of a model share use one lane per part.

The corners of a car are equal expressions of different symbols. Every node of an expression graph gets a *shape*
(its operation and the shapes of its operands; for symbols the name without the part's) and the parts it belongs to.
Nodes of one shape, one per part, form a vector; values that parts share are broadcast, and results that combine
several parts are scalars again.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, NamedTuple, Protocol

import casadi as ca
import numpy as np

_OPCODES = {getattr(ca, name): name for name in dir(ca) if name.startswith("OP_")}
SHARED = -1
"""Mask of nodes that belong to no specific part: all bits set."""


@dataclass(frozen=True)
class Parts:
    """The equal parts of a model.

    ``prefixes`` are, for each part, the prefix of its names, then the prefixes of the assemblies that it
    belongs to; ``groups`` are the parts that are vectorised together (each part is in one group).
    """

    prefixes: tuple[tuple[str, ...], ...]
    groups: tuple[tuple[int, ...], ...]

    def label(self, name: str) -> tuple[str, int]:
        """Return a name without its part's prefix, and the mask of parts it belongs to."""
        for place in range(len(self.prefixes[0]) if self.prefixes else 0):
            mask, rest = 0, name
            for i, prefixes in enumerate(self.prefixes):
                if name.startswith(f"{prefixes[place]}."):
                    mask, rest = mask | 1 << i, name[len(prefixes[place]) :]
            if mask:
                return f"{place}{rest}", mask
        return name, SHARED

    @cached_property
    def assemblies(self) -> frozenset[int]:
        """Return the masks of the parts of each assembly."""
        masks: dict[str, int] = {}
        for i, prefixes in enumerate(self.prefixes):
            for prefix in prefixes[1:]:
                masks[prefix] = masks.get(prefix, 0) | 1 << i
        return frozenset(masks.values())


class Node(NamedTuple):
    """An operation or a leaf: its operands, and the constant or (argument, element) of a leaf."""

    operation: str
    operands: tuple[int, ...] = ()
    leaf: Any = None


@dataclass(frozen=True)
class Packed:
    """A function of (x, u, p, m) whose equal parts are vectorised.

    ``labels`` give, for each argument, name and parts of every element; ``table`` gives the offset in ``p`` of elements
    that are stored side by side in that order.
    """

    function: ca.Function
    parts: Parts
    labels: tuple[tuple[tuple[str, int], ...], ...]
    table: dict[tuple[int, ...], int] = field(default_factory=dict)

    @property
    def form(self) -> str:
        """All dependencies of the code except the function, for the cache key."""
        return f"{self.parts} {self.labels} {self.table}"

    @cached_property
    def graph(self) -> Graph:
        """Nodes of the function."""
        return Graph(self.function, self.parts, self.labels)


class Graph:
    """Nodes of a function with their shapes and parts; ``results`` are those of its output, by element."""

    def __init__(
        self, function: ca.Function, parts: Parts, labels: Sequence[Sequence[tuple[str, int]]]
    ) -> None:
        self.parts, self.nodes, self.results = parts, list[Node](), dict[int, int]()
        work: dict[int, int] = {}
        for k in range(function.n_instructions()):
            operation = _OPCODES[function.instruction_id(k)]
            inputs, outputs = function.instruction_input(k), function.instruction_output(k)
            if operation == "OP_OUTPUT":
                self.results[outputs[1]] = work[inputs[0]]
                continue
            leaf: Any = None
            if operation == "OP_CONST":
                leaf, inputs = function.instruction_constant(k), []
            elif operation == "OP_INPUT":
                leaf, inputs = (inputs[0], inputs[1]), []
            self.nodes.append(Node(operation, tuple(work[i] for i in inputs), leaf))
            work[outputs[0]] = len(self.nodes) - 1
        self._groups = [sum(1 << part for part in group) for group in parts.groups]
        self.shapes, self.masks = [-1] * len(self.nodes), [SHARED] * len(self.nodes)
        self._known: dict[Any, int] = {}
        self._mixed = set[int]()
        self._numbers, self._sums = (
            set[int](),
            set[int](),
        )  # nodes treated as scalars, and sums over parts
        for i, node in enumerate(self.nodes):
            if node.operation == "OP_CONST":
                self._call(i, ("constant", node.leaf), SHARED)
            elif node.operation == "OP_INPUT":
                name, mask = labels[node.leaf[0]][node.leaf[1]]
                self._call(i, ("leaf", node.leaf[0], name), mask)
            else:
                self._call(i, *self._combine(i, node))
        self._gather()
        # A node that one part has and the others lack (a leading corner's sign, the last term of a sum over corners)
        # cannot be a lane. Treating it as a scalar changes the shapes of all nodes that depend on it, which are
        # computed again.
        while scalars := self._unmatched_nodes():
            self._numbers |= scalars
            self._update_shapes(scalars)
            self._gather()

    def _call(self, i: int, shape: tuple[Any, ...], mask: int) -> bool:
        """Set shape and parts of a node; return whether they changed."""
        number = self._known.setdefault(shape, len(self._known))
        if shape[0] == "mixed":
            self._mixed.add(number)
        if (number, mask) == (self.shapes[i], self.masks[i]):
            return False
        self.shapes[i], self.masks[i] = number, mask
        return True

    def _update_shapes(self, numbers: set[int]) -> None:
        """Compute the shapes of new scalars, and of all nodes that depend on them."""
        changed = set[int]()
        for i in range(min(numbers), len(self.nodes)):
            node = self.nodes[i]
            if i in numbers or not changed.isdisjoint(node.operands):
                was_sum = i in self._sums
                self._sums.discard(i)
                if self._call(i, *self._combine(i, node)) or was_sum != (i in self._sums):
                    changed.add(i)

    def _gather(self) -> None:
        """Find the nodes of each shape by part, and the groups whose parts all have it."""
        shapes, masks, count = (
            np.array(self.shapes, int),
            np.array(self.masks, int),
            len(self._known),
        )
        own = np.flatnonzero(masks != SHARED)
        present = np.zeros(count, dtype=int)
        np.bitwise_or.at(present, shapes[own], masks[own])
        members = np.full((count, len(self.parts.prefixes)), -1)
        for part in range(len(self.parts.prefixes)):
            last_first = own[masks[own] >> part & 1 == 1][::-1]
            members[shapes[last_first], part] = last_first
        complete = np.zeros(count, dtype=int)
        for group in self._groups:
            complete += np.where(present & group == group, group, 0)
        self.members: list[list[int]] = members.tolist()
        self._complete: list[int] = complete.tolist()
        self._incomplete = own[complete[shapes[own]] & masks[own] == 0]

    def _combine(self, i: int, node: Node) -> tuple[tuple[Any, ...], int]:
        """Return shape and parts of an operation."""
        mask, every = SHARED, 0
        for operand in node.operands:
            own = self.masks[operand]
            mask &= own
            if own != SHARED:
                every |= own
        shape = (node.operation, *[self.shapes[operand] for operand in node.operands])
        if every == 0:
            return shape, SHARED
        is_sum = node.operation in ("OP_ADD", "OP_SUB")
        if i in self._numbers or (is_sum and not self._sums.isdisjoint(node.operands)):
            self._sums.add(i)
            return ("number", i), SHARED
        if mask != 0:
            return shape, mask
        if is_sum:
            self._sums.add(i)
        if every in self.parts.assemblies:  # all parts of one assembly: one value for all of them
            return ("mixed", *shape), every
        return ("number", i), SHARED

    def _unmatched_nodes(self) -> set[int]:
        """Return nodes of one part that the others lack, the first on each path (as at the end of sums over parts)."""
        unmatched, touched = set[int](), set[int]()
        incomplete = {i for i in self._incomplete.tolist() if self.nodes[i].operands}
        for i in range(min(incomplete), len(self.nodes)) if incomplete else ():
            if not touched.isdisjoint(self.nodes[i].operands):
                touched.add(i)
            elif i in incomplete:
                touched.add(i)
                unmatched.add(i)
        return unmatched

    def group_of(self, node: int) -> tuple[int, ...] | None:
        """Return the parts whose vector has a node as a lane; None for a scalar."""
        if self.masks[node] == SHARED:
            return None
        own = self._complete[self.shapes[node]] & self.masks[node]
        return next(
            (group for group in self.parts.groups if any(own >> i & 1 for i in group)), None
        )

    def is_mixed(self, node: int) -> bool:
        """Return whether a node combines several parts of an assembly."""
        return self.shapes[node] in self._mixed

    def lanes(self, shape: int, group: tuple[int, ...]) -> tuple[int, ...]:
        """Return the nodes of one shape for a group of parts."""
        return tuple(self.members[shape][i] for i in group)

    def tables(self, argument: int) -> list[tuple[int, ...]]:
        """Return the elements of an argument that are lanes of one vector."""
        leaves = dict.fromkeys(
            (shape, group)
            for i, node in enumerate(self.nodes)
            if node.operation == "OP_INPUT" and node.leaf[0] == argument
            for shape, group in [(self.shapes[i], self.group_of(i))]
            if group is not None
        )
        return [
            tuple(self.nodes[i].leaf[1] for i in self.lanes(shape, group))
            for shape, group in leaves
        ]


class Writer(Protocol):
    """Emits operations for a processor or a compiler; values are objects of that target."""

    def constant(self, value: float) -> Any:
        """Emit a constant."""

    def load(self, argument: int, element: int) -> Any:
        """Emit the load of an element of an argument."""

    def load_wide(self, offset: int, count: int) -> Any:
        """Emit the load of adjacent parameters as a vector."""

    def scalar(self, operation: str, values: list[Any]) -> Any:
        """Emit an operation on scalars."""

    def wide(self, operation: str, values: list[Any]) -> Any | None:
        """Emit an operation on vectors; return None if it exists for scalars only."""

    def lane(self, vector: Any, lane: int) -> Any:
        """Emit the extraction of a lane."""

    def gather(self, values: list[Any]) -> Any:
        """Emit a vector of scalars."""


class Emission:
    """Emits the nodes of a graph on demand, each vector and each scalar once."""

    def __init__(self, packed: Packed, writer: Writer) -> None:
        self._graph, self._table, self._writer = packed.graph, packed.table, writer
        self._emitted: dict[tuple[Any, ...], Any] = {}

    def number(self, node: int) -> Any:
        """Return the value of a node, emitted if it is not yet."""
        return self._get(("number", node))

    def _get(self, wanted: tuple[Any, ...]) -> Any:
        # No recursion: graphs of whole vehicles exceed Python's recursion limit.
        stack = [wanted]
        while stack:
            item = stack[-1]
            if item in self._emitted:
                stack.pop()
                continue
            missing = [part for part in self._needs(item) if part not in self._emitted]
            if missing:
                stack += missing
                continue
            self._emitted[item] = self._make(item)
            stack.pop()
        return self._emitted[wanted]

    def _needs(self, item: tuple[Any, ...]) -> Iterable[tuple[Any, ...]]:
        graph = self._graph
        if item[0] == "number":
            node = item[1]
            group = self._vector_of(node)
            return [group] if group else [("number", i) for i in graph.nodes[node].operands]
        if item[0] == "spread":
            return [("number", item[1])]
        first = graph.members[item[1]][item[2][0]]
        if graph.is_mixed(first):
            return [("number", i) for i in graph.lanes(item[1], item[2])]
        return self._operands(first, item[2])

    def _vector_of(self, node: int) -> tuple[Any, ...] | None:
        """Return the vector that has the node as a lane."""
        graph = self._graph
        if graph.nodes[node].operation == "OP_INPUT" or graph.is_mixed(node):
            return None
        group = graph.group_of(node)
        return ("vector", graph.shapes[node], group) if group is not None else None

    def _operands(self, first: int, group: tuple[int, ...]) -> list[tuple[Any, ...]]:
        """Return the operands of the vector whose first lane is the node ``first``."""
        graph = self._graph
        return [
            ("spread", i, len(group))
            if graph.masks[i] == SHARED
            else ("vector", graph.shapes[i], group)
            for i in graph.nodes[first].operands
        ]

    def _make(self, item: tuple[Any, ...]) -> Any:
        graph, writer = self._graph, self._writer
        if item[0] == "spread":
            return writer.gather([self._emitted["number", item[1]]] * item[2])
        if item[0] == "vector":
            return self._vector(item[1], item[2])
        node = graph.nodes[item[1]]
        vector = self._vector_of(item[1])
        if vector:
            lane = next(k for k, i in enumerate(vector[2]) if graph.masks[item[1]] >> i & 1)
            return writer.lane(self._emitted[vector], lane)
        if node.operation == "OP_CONST":
            return writer.constant(node.leaf)
        if node.operation == "OP_INPUT":
            return writer.load(*node.leaf)
        return writer.scalar(node.operation, [self._emitted["number", i] for i in node.operands])

    def _vector(self, shape: int, group: tuple[int, ...]) -> Any:
        graph, writer = self._graph, self._writer
        node = graph.members[shape][group[0]]
        first = graph.nodes[node]
        if graph.is_mixed(node):
            return writer.gather([self._emitted["number", i] for i in graph.lanes(shape, group)])
        if first.operation == "OP_INPUT":
            leaves = [graph.nodes[i].leaf for i in graph.lanes(shape, group)]
            offset = self._table.get(tuple(element for _, element in leaves))
            if leaves[0][0] == 2 and offset is not None:
                return writer.load_wide(offset, len(group))
            return writer.gather([writer.load(*leaf) for leaf in leaves])
        operands = [self._emitted[item] for item in self._operands(node, group)]
        vector = writer.wide(first.operation, operands)
        if vector is not None:
            return vector
        each = [[writer.lane(value, k) for value in operands] for k in range(len(group))]
        return writer.gather([writer.scalar(first.operation, values) for values in each])
