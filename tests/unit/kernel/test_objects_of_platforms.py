"""Objects for platforms that none of us has run: of the right processor, and whatever they call by name exists there.

Loading them here would end the process (LLVM allows no foreign object), so they are read byte by byte.
"""

from __future__ import annotations

import struct

import pytest
from llvmlite import binding as llvm

from jounce.core.sources import digest_of
from jounce.kernel import cache, call, loops
from jounce.kernel.loops import BUILT, LOOPS, PLATFORMS, key_of

EVERYWHERE = {
    "cos",
    "exp2",
    "memset",
    "pow",
    "sin",
}  # C99, in glibc, musl, libSystem and the universal C run-time
ALSO = {
    "linux": {"sincos"},
    "darwin": {"__bzero", "__sincos_stret", "bzero", "memset_pattern16"},
    "windows": set[str](),  # no __chkstk either: no frame is that large
}
PROCESSORS = {
    "x86_64": (62, 0x01000007),
    "amd64": (62, 0x01000007),
    "aarch64": (183, 0),
    "arm64": (183, 0x0100000C),
}
"""Numbers in ELF (e_machine) and Mach-O (cputype)."""


def text_at(content: bytes, place: int) -> str:
    return content[place : content.index(b"\0", place)].decode()


def read_elf(content: bytes) -> tuple[int, set[str]]:
    """Processor, and names that are called but not defined."""
    start = struct.unpack_from("<Q", content, 40)[0]
    size, count = struct.unpack_from("<HH", content, 58)
    sections = [struct.unpack_from("<IIQQQQII", content, start + size * k) for k in range(count)]
    missing = set()
    for _, kind, _, _, offset, length, link, _ in sections:
        for k in range(length // 24 if kind == 2 else 0):  # the table of symbols
            name, _, _, section = struct.unpack_from("<IBBH", content, offset + 24 * k)
            if name and section == 0:
                missing.add(text_at(content, sections[link][4] + name))
    return struct.unpack_from("<H", content, 18)[0], missing


def read_mach(content: bytes) -> tuple[int, set[str]]:
    """The same of a Mach-O object, without the underscore that names of C have there."""
    processor, _, _, commands = struct.unpack_from("<iiII", content, 4)
    place, missing = 32, set()
    for _ in range(commands):
        command, length = struct.unpack_from("<II", content, place)
        if command == 2:  # the table of symbols
            symbols, count, names, _ = struct.unpack_from("<IIII", content, place + 8)
            for k in range(count):
                name, kind = struct.unpack_from("<IB", content, symbols + 16 * k)
                if kind & 0x0F == 1:  # external, of no section
                    missing.add(text_at(content, names + name).removeprefix("_"))
        place += length
    return processor, missing


def problems(content: bytes, platform: str) -> set[str]:
    """What an object has that its platform has not."""
    system, _, processor = platform.partition("-")
    is_mach = system == "darwin"
    if not content.startswith(b"\xcf\xfa\xed\xfe" if is_mach else b"\x7fELF"):
        return {"another format"}
    found, missing = (read_mach if is_mach else read_elf)(content)
    if not missing:
        return {"no symbols"}
    wrong = missing - EVERYWHERE - ALSO[system] - set(call.PYTHON)
    return wrong | ({"another processor"} if found != PROCESSORS[processor][is_mach] else set())


@pytest.fixture(scope="module")
def targets() -> None:
    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()


@pytest.mark.skipif(not BUILT.exists(), reason="make loops")
@pytest.mark.parametrize(
    "name",
    [
        name if name in ("evaluate", "hysteresis") else pytest.param(name, marks=pytest.mark.slow)
        for name in LOOPS
    ],
)
def test_a_platform_has_what_its_objects_call(name: str, targets) -> None:
    bitcode = cache.read_sealed(BUILT / f"{name}.bc", key_of(name, digest_of(*loops.SOURCES)))
    assert bitcode is not None
    made = {
        platform: cache.split(call.object_for(bitcode, PLATFORMS[platform]))[1]
        for platform in PLATFORMS
    }
    assert not {
        platform: found
        for platform, content in made.items()
        if (found := problems(content, platform))
    }


def test_what_a_platform_lacks_is_found(targets) -> None:
    text = (
        "declare void @of_nowhere()\ndefine void @entry() {\n call void @of_nowhere()\n ret void\n}"
    )
    made = {}
    for platform, told in PLATFORMS.items():
        machine = llvm.Target.from_triple(told.triple).create_target_machine(
            cpu=told.processor, jit=True
        )
        module = llvm.parse_assembly(text)
        module.triple = told.triple
        made[platform] = bytes(machine.emit_object(module))
        assert problems(made[platform], platform) == {"of_nowhere"}
    assert problems(made["linux-aarch64"], "linux-x86_64") == {"of_nowhere", "another processor"}
    assert problems(made["darwin-arm64"], "darwin-x86_64") == {"of_nowhere", "another processor"}
    assert problems(made["linux-x86_64"], "darwin-x86_64") == {"another format"}
