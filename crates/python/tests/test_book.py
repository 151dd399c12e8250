"""Runs the Python of the book and of the README, chapter by chapter, as a reader would who types it in."""

import re
import shutil
from pathlib import Path

import pytest

import demeter

ROOT = Path(__file__).parents[3]
BLOCK = re.compile(r"^```python\n(.*?)^```$", re.MULTILINE | re.DOTALL)
CHAPTERS = [
    path for path in [ROOT / "README.md", *sorted((ROOT / "book/src").glob("**/*.md"))] if BLOCK.search(path.read_text("utf-8"))
]


def test_the_chapters_are_found():
    assert {"README.md", "python.md"} <= {path.name for path in CHAPTERS}


@pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda path: path.stem)
def test_the_python_of_a_chapter_runs(chapter, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MPLBACKEND", "agg")
    shutil.copytree(ROOT / "examples", "examples")
    shutil.copytree(ROOT / "book/src/files", ".", dirs_exist_ok=True)
    Path("drum.toml").write_text(demeter.Scenario.template("drum").to_toml(), "utf-8")
    text = chapter.read_text("utf-8")
    names = {"__name__": "__main__"}
    for block in BLOCK.finditer(text):
        lines_before = text[: block.start(1)].count("\n")
        # so that a fault is told with its line of the chapter
        code = compile("\n" * lines_before + block.group(1), str(chapter), "exec")
        exec(code, names)
