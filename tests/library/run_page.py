"""Runs all Python code of a page in order. Lines whose comment is what they print must print that. Usage: run_page.py PAGE"""
import contextlib
import io
import re
import sys

page = open(sys.argv[1]).read()
blocks = re.findall(r"```python\n(.*?)```", page, re.S)
assert len(blocks) > 5, "the page has lost its code"
said = io.StringIO()
names = {}
with contextlib.redirect_stdout(said):
    for block in blocks:
        exec(compile(block, sys.argv[1], "exec"), names)
printed = said.getvalue().splitlines()
promised = [text.strip() for text in re.findall(r"print\(.*?\)\s+# ([(\['pu].*)", "\n".join(blocks))]
promised = [text for text in promised if text.startswith(("(", "[", "positions:", "usage"))]
assert len(promised) >= 5, promised
for text in promised:
    assert text in printed, f"the page promises {text!r}, and printed is {printed}"
print(f"ran {len(blocks)} blocks, {len(promised)} results as promised")
