"Show what a check has found: on a terminal, as JSON for a program, and as a page to send and print."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.check.judge import Row
from UAV.check.suite import Findings

def row_text(row: Row) -> str:
    "Two lines: the verdict on a sentence, and what was seen"
def summary(found: Findings) -> str:
    "One line"
def as_object(found: Findings) -> dict:
    "For JSON"
def source_html(source: str) -> str:
    "The source with links"
page_style: str
def row_html(row: Row) -> str:
    "A row of the table"
def table_html(title: str, rows: list) -> str:
    "A table with a heading; nothing when it has no rows"
def page(found: Findings) -> str:
    "The report as a page: one file, for a screen and for paper"

__all__ = ['page_style', 'row_text', 'summary', 'as_object', 'source_html', 'row_html', 'table_html', 'page']
