"""Print how large, dense and plain the code is: figures from syntax trees, no gate.

``make figures``, or ``python tests/house/figures.py [PACKAGE ...]`` for single packages of ``src/jounce``.
"""

import ast
import io
import re
import sys
import tokenize
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).parents[2]
SOURCE = ROOT / "src" / "jounce"
VIEWER = ROOT / "viewer" / "src"
WIDTH = 100
DIALECT = ("found", "one", "told", "kept")
# A function named by a participle: `moved`, `_found_at`; not verbs such as `feed` and `need_...`.
PARTICIPLE = re.compile(
    r"_*(?!(?:bed|feed|need|seed|speed|embed|exceed|proceed|shed)$)"
    r"(?:[a-z]{3,}ed$|(?:bent|bound|broken|built|caught|chosen|done|drawn|driven|felt|forgotten|found|given|gone|grown|held"
    r"|hidden|kept|known|laid|led|left|lent|lost|made|meant|met|moved|paid|ridden|risen|said|seen|sent|shown|spent|spoken"
    r"|stood|struck|sunk|taken|taught|thought|thrown|told|torn|understood|woken|worn|written)(?:_|$))"
)
BRANCHES = (
    ast.If,
    ast.IfExp,
    ast.For,
    ast.AsyncFor,
    ast.While,
    ast.match_case,
    ast.Assert,
    ast.comprehension,
)
SCOPES = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.Module)


def code_lines(text: str, tree: ast.Module) -> set[int]:
    """Return the numbers of the lines that hold code: no blank lines, comments or docstrings."""
    silent = {
        tokenize.COMMENT,
        tokenize.NL,
        tokenize.NEWLINE,
        tokenize.INDENT,
        tokenize.DEDENT,
        tokenize.ENDMARKER,
    }
    lines: set[int] = set()
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type not in silent:
            lines.update(range(token.start[0], token.end[0] + 1))
    for node in ast.walk(tree):
        if isinstance(node, SCOPES) and ast.get_docstring(node, clean=False) is not None:
            docstring = node.body[0]
            lines.difference_update(
                range(docstring.lineno, (docstring.end_lineno or docstring.lineno) + 1)
            )
    return lines


def count_comments(text: str) -> int:
    """Return the number of comments, full-line and trailing."""
    return sum(
        token.type == tokenize.COMMENT
        for token in tokenize.generate_tokens(io.StringIO(text).readline)
    )


def count_decisions(tree: ast.Module) -> int:
    """Return the number of branches, loops and assertions, and of operands of `and` and `or` after the first.

    A comprehension counts as a loop; its conditions do not count.
    """
    nodes = list(ast.walk(tree))
    operands = sum(len(node.values) - 1 for node in nodes if isinstance(node, ast.BoolOp))
    return operands + sum(isinstance(node, BRANCHES) for node in nodes)


def assigned_names(function: ast.AST) -> Iterator[str]:
    """Yield the names that a function takes as parameters or assigns, those of functions inside it excepted."""
    for node in ast.iter_child_nodes(function):
        if isinstance(node, ast.arg):
            yield node.arg
        elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            yield node.id
        if not isinstance(node, SCOPES):
            yield from assigned_names(node)


def measure(paths: list[Path]) -> dict[str, str]:
    """Return label and value of each figure over Python files."""
    total: Counter[str] = Counter()
    classes: Counter[str] = Counter()
    for path in paths:
        text = path.read_text("utf-8")
        tree = ast.parse(text)
        code = code_lines(text, tree)
        lines = text.splitlines()
        total["lines"] += len(lines)
        total["code"] += len(code)
        total["wide"] += sum(len(lines[number - 1]) > WIDTH for number in code)
        total["comments"] += count_comments(text)
        total["decisions"] += count_decisions(tree)
        classes.update(node.name for node in tree.body if isinstance(node, ast.ClassDef))
        for node in ast.walk(tree):
            if isinstance(node, ast.IfExp):
                total["conditional"] += 1
            elif isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
                total["functions"] += 1
                total["participles"] += PARTICIPLE.match(node.name) is not None
                total.update(word for word in set(assigned_names(node)) if word in DIALECT)
    code = max(total["code"], 1)
    return {
        "lines of Python": f"{total['lines']}",
        "code lines (no blank lines, comments, docstrings)": f"{total['code']}",
        "decisions per 100 code lines": f"{100 * total['decisions'] / code:.1f}",
        "conditional expressions per 1000 code lines": f"{1000 * total['conditional'] / code:.1f}",
        f"code lines over {WIDTH} columns, %": f"{100 * total['wide'] / code:.1f}",
        "comments per 100 code lines": f"{100 * total['comments'] / code:.1f}",
        "class names with two or more meanings": f"{sum(count > 1 for count in classes.values())}",
        "functions": f"{total['functions']}",
        "functions named by a participle": f"{total['participles']}",
        **{f"functions with a variable `{word}`": f"{total[word]}" for word in DIALECT},
    }


def main(packages: list[str]) -> None:
    """Print the figures of packages, all and TypeScript without any."""
    folders = [SOURCE / package for package in packages] or [SOURCE]
    figures = measure([path for folder in folders for path in sorted(folder.rglob("*.py"))])
    if not packages:
        scripts = [path for path in sorted(VIEWER.rglob("*.ts")) if not path.name.endswith(".d.ts")]
        figures["lines of TypeScript"] = (
            f"{sum(len(path.read_text('utf-8').splitlines()) for path in scripts)}"
        )
    for label, value in figures.items():
        print(f"{value:>8}  {label}")


if __name__ == "__main__":
    main(sys.argv[1:])
