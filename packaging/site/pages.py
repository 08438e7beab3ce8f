# SPDX-License-Identifier: GPL-3.0-or-later
"""Pages as MkDocs reads them: a block's language alone stands behind its fence, without the words that the tests read there."""

from __future__ import annotations

import re
from typing import Any


def on_page_markdown(markdown: str, **_: Any) -> str:
    return re.sub(r"^(\s*```\w+) .*$", r"\1", markdown, flags=re.M)
