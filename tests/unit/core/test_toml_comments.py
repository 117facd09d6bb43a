"""Comments in TOML: they stand where a value is written, however its tables are."""

import tomlkit

from jounce.core.toml_comments import annotate


def test_values_of_dotted_keys_are_annotated_on_their_own_lines():
    document = tomlkit.parse(
        'strut.angle = "26 deg"  # as built\n'
        "# of the catalogue\n"
        "strut.spring.rate = 22700\n"
        'title = "between"\n'
        "strut.friction.force = 3\n"
        "tyre = {stiffness = 138000}\n"
        "[strut.damper]\n"
        "coefficient = 180\n"
    )
    annotate(document, ["strut", "spring", "rate"], "measured")
    annotate(document, ["strut", "friction", "force"], "fitted")
    annotate(document, ["strut", "damper", "coefficient"], "fitted, too")
    annotate(document, ["tyre", "stiffness"], "guessed")
    annotate(document, ["guide", "friction", "force"], "is nowhere")
    assert tomlkit.dumps(document).splitlines() == [
        'strut.angle = "26 deg"  # as built',
        "strut.spring.rate = 22700  # measured",
        'title = "between"',
        "strut.friction.force = 3  # fitted",
        "tyre = {stiffness = 138000}  # stiffness guessed",
        "[strut.damper]",
        "coefficient = 180  # fitted, too",
    ]
