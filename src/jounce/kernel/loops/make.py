"""Compile all loops, as ``make loops`` does: ``python -m jounce.kernel.loops.make [--all-platforms]``."""

from __future__ import annotations

import argparse
import os
import sys
import time
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path

from llvmlite import binding as llvm

from jounce.core.sources import digest_of
from jounce.kernel.cache import read_sealed, write_sealed
from jounce.kernel.call import object_for
from jounce.kernel.loops import BUILT, LOOPS, PLATFORMS, SOURCES, key_of, this_platform


def make(name: str, platforms: list[str]) -> float:
    """Write the bitcode and objects of a loop; return the processor time (s), 0 if everything is up to date."""
    digest, started = digest_of(*SOURCES), time.process_time()
    file, key = BUILT / f"{name}.bc", key_of(name, digest)
    bitcode, made = read_sealed(file, key), False
    if bitcode is None:
        from jounce.kernel.loops.build import bitcode_of

        bitcode, made = bitcode_of(name), True
        _write(file, key, bitcode)
    for platform in platforms:
        file, key = BUILT / platform / f"{name}.o", key_of(name, digest, platform)
        if read_sealed(file, key) is None:
            llvm.initialize_all_targets()
            llvm.initialize_all_asmprinters()
            _write(file, key, object_for(bitcode, PLATFORMS[platform]))
            made = True
    return time.process_time() - started if made else 0.0


def _write(file: Path, key: str, content: bytes) -> None:
    if not write_sealed(file, key, content):
        raise SystemExit(
            f"{file} cannot be written, or the kernel was edited meanwhile: run it again"
        )


def main(arguments: list[str] | None = None) -> None:
    """Compile the loops that are missing or stale."""
    parser = argparse.ArgumentParser(prog="python -m jounce.kernel.loops.make", description=__doc__)
    parser.add_argument(
        "--all-platforms", action="store_true", help="objects for every platform, as in a wheel"
    )
    everywhere = parser.parse_args(arguments).all_platforms
    platforms = [name for name in PLATFORMS if everywhere or name == this_platform()]
    print(
        f"making the loops of jounce for {', '.join(platforms) or 'any machine'}: up to a minute",
        flush=True,
    )
    if BUILT.exists():  # loops that are no more
        for file in [*BUILT.glob("*.bc"), *BUILT.glob("*/*.o")]:
            if file.stem not in LOOPS and not file.name.startswith(
                "."
            ):  # another process may be writing one
                file.unlink()
    with ProcessPoolExecutor(os.cpu_count(), mp_context=get_context("spawn")) as pool:
        for name, spent in zip(LOOPS, pool.map(make, LOOPS, [platforms] * len(LOOPS)), strict=True):
            print(f"  {name}: {f'{spent:.1f} s' if spent else 'up to date'}", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
