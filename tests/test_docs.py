# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The docs say what the program does: tables, pictures, links and the jobs behind the pictures."""

import re
from pathlib import Path
from textwrap import dedent

import pytest

from sweep_addon.batch import job
from sweep_addon.core.declared.description import markdown
from sweep_addon.core.declared.parameters import spelled
from sweep_addon.core.rings.ends import Open
from sweep_addon.core.shapes.kinds import SHAPES

CHECKOUT = Path(__file__).resolve().parents[1]
PAGES = [*CHECKOUT.glob("*.md"), *CHECKOUT.glob("docs/*.md")]
EXAMPLE = re.compile(r"^```python\n(.*?)^```\n\n?((?: {4}[^\n]*\n)*)", re.DOTALL | re.MULTILINE)
EXAMPLES = [  # those of CONTRIBUTING.md are parts of files, and have a test of their own
    pytest.param(*example, id=f"{page.stem}-{i}")
    for page in PAGES
    if page.stem != "CONTRIBUTING"
    for i, example in enumerate(EXAMPLE.findall(page.read_text()))
]
BLOCK = re.compile(r"^```toml\n(.*?)^```\n", re.DOTALL | re.MULTILINE)
BLOCKS = [  # what is only a part of a job begins with ```toml part
    pytest.param(text, id=f"{page.stem}-{i}")
    for page in PAGES
    for i, text in enumerate(BLOCK.findall(page.read_text()))
]
JOBS = [*CHECKOUT.glob("docs/*.toml"), *CHECKOUT.glob("docs/pictures/*.toml")]

pytestmark = pytest.mark.skipif(not PAGES, reason="the installed zip has no docs")


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_links_and_pictures_of_a_page_exist(page):
    targets = re.findall(r"\]\(([^)#\s]+)", page.read_text())
    missing = [target for target in targets if "://" not in target and not (page.parent / target).exists()]
    assert not missing


def anchors(page):
    """What a link may name after its #: the headings of a page, as GitHub writes them."""
    headings = re.findall(r"^#+ (.+)", page.read_text(), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_links_to_a_section_name_its_heading(page):
    links = re.findall(r"\]\(([^)#\s:]*)#([^)\s]+)\)", page.read_text())
    missing = [(to, section) for to, section in links if section not in anchors(page.parent / to if to else page)]
    assert not missing


def test_readme_leads_to_every_page():
    names = set(re.findall(r"\]\((docs/\w+\.md)\)", (CHECKOUT / "README.md").read_text()))
    assert names == {str(page.relative_to(CHECKOUT)) for page in CHECKOUT.glob("docs/*.md")}


@pytest.mark.parametrize(("code", "below"), EXAMPLES)
def test_example_of_a_page_runs_by_itself_and_prints_what_stands_below(code, below, tmp_path, monkeypatch, capsys):
    (tmp_path / "docs").symlink_to(CHECKOUT / "docs")  # examples read from there, and may write beside it
    monkeypatch.chdir(tmp_path)
    exec(code, {})
    printed = capsys.readouterr().out
    assert not (printed and below) or printed == dedent(below)


@pytest.mark.parametrize("text", BLOCKS)
def test_job_on_a_page_is_read(text):
    job.parse(text, CHECKOUT / "docs")


def test_jobs_are_found_on_pages():
    assert {"jobs-0", "solid-0"} <= {block.id for block in BLOCKS}


@pytest.mark.parametrize("shape", SHAPES, ids=spelled)
def test_table_of_parameters_is_the_declaration(shape):
    """Its text is what ``sweep describe generalized-cylinder --markdown`` prints, or that of another shape."""
    page = (CHECKOUT / "docs" / f"{spelled(shape, '_')}.md").read_text()
    table = page.partition("<!-- parameters -->\n")[2].partition("<!-- end of parameters -->")[0]
    assert table.strip() == markdown(shape)


@pytest.mark.thorough
@pytest.mark.parametrize("path", JOBS, ids=lambda path: path.stem)
def test_job_behind_a_picture_makes_a_mesh_that_is_closed_unless_an_end_is_open(path):
    shape = job.read(path).shape
    mesh = shape.mesh()
    ends, contour = (getattr(shape, name, None) for name in ("start", "end")), getattr(shape, "contour", None)
    is_open = any(isinstance(end, Open) for end in ends) or getattr(shape, "is_plane", False)
    is_open |= contour is not None and not contour.section().closed
    is_open |= "{" in getattr(shape, "system", "")  # polygons of a plant
    assert bool(len(mesh.boundary_edges())) == is_open
    assert not len(mesh.non_manifold_edges())
