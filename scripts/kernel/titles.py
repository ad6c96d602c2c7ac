"""Titles of paragraphs: a long kernel function says what each of its paragraphs is for, in the imperative; and a number
that has a name is written by it."""
import re

from pycparser import c_ast

from . import tree as T
from .comments import comments

LONG = 12  # statements
VERBS = set("""Accumulate Add Allow Answer Apply Ask Assume Average Begin Bisect Blend Bound Build Carry Choose
Clamp Clear Clip Close Combine Compare Compute Convert Copy Count Cull Cut Decide Descend Describe Divide Draw
Drop Enlarge Evaluate Expose Fade Fall Fill Find Follow Gather Give Go Grow Improve Interpolate Intersect Invert
Judge Keep Lay Leave Let Limit List Load Look Lower Make Mark Measure Mirror Mix Move Multiply Name Narrow Offer
Order Overflow Place Point Prepare Project Put Read Reduce Reflect Render Replace Return Round Sample Saturate
Scale Search See Send Set Shade Shorten Show Size Skip Snap Solve Splat Split Spread Start Step Stop Store
Strike Subtract Sum Take Test Turn Update Use Visit Weaken Weigh Weight Widen Wrap Write""".split())
NUMBER = re.compile(r"(?<![\w.])\d+\.\d{7,}(?:e[-+]?\d+)?f\b")
NAMED = re.compile(r"^#define (TS_\w+) (\d+\.\d{7,}(?:e[-+]?\d+)?f)\b", re.M)


def statements(node):
	"""Of a body, blocks left out."""
	if isinstance(node, c_ast.Compound):
		return sum(map(statements, node.block_items or []))
	inner = [node.stmt] if isinstance(node, (c_ast.For, c_ast.While, c_ast.DoWhile, c_ast.Switch)) else []
	inner += [node.iftrue, node.iffalse] if isinstance(node, c_ast.If) else []
	inner += node.stmts or [] if isinstance(node, (c_ast.Case, c_ast.Default)) else []
	return 1 + sum(statements(each) for each in inner if each is not None)


class Lines(c_ast.NodeVisitor):
	"""last: the last line of a body, all of which stands in one file."""

	def __init__(self, body):
		self.last = 0
		self.generic_visit(body)

	def generic_visit(self, node):
		if node.coord:
			self.last = max(self.last, node.coord.line)
		super().generic_visit(node)


def faults(kernels):
	for function in kernels.functions.values():
		if function.path == T.place(T.LANGUAGE):
			continue
		above, body = comments(function.path).above, function.node.body
		titles = [(line, text) for line, text in above.items() if body.coord.line < line <= Lines(body).last]
		n = statements(body)
		written = f"{function.name}(" in source(function.path)
		if n >= LONG and not titles and written:
			yield function.path, function.line, f"{function.name}() has {n} statements, and no title in it"
		for line, text in titles:
			word = re.match(r"[\w-]*", text[0])[0]
			if word not in VERBS:
				yield function.path, line - len(text), f'"{word}" begins no title: an imperative is wanted'
	yield from numbers({T.place(node.coord.file) for node in kernels.file.ext if node.coord})


def source(path):
	with open(path, encoding="utf-8") as file:
		return file.read()


def is_round(digits):
	"""One of few bits, as 1/1024 and 129/128 are, means many things."""
	return float(digits.rstrip("f")).hex().split("p")[0].rstrip("0").rstrip(".").partition(".")[2][3:] == ""


def numbers(paths):
	"""Numbers of these files whose name stands in one of them."""
	texts = {path: source(path) for path in sorted(paths) if path.endswith(".h")}
	named = {digits: name for text in texts.values() for name, digits in NAMED.findall(text) if not is_round(digits)}
	for path, text in texts.items():
		text = re.sub(r"/\*.*?\*/", lambda match: re.sub(r"[^\n]", " ", match[0]), text, flags=re.S)
		for match in NUMBER.finditer(text):
			name, line = named.get(match[0]), text[text.rfind("\n", 0, match.start()) + 1 :].split("\n")[0]
			if name and f"#define {name} {match[0]}" not in line:
				yield path, text.count("\n", 0, match.start()) + 1, f"{match[0]} is {name}"
