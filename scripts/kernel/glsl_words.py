"""How the kernels' words are written in GLSL, and how tightly its operators bind."""
import os
import re
import subprocess

from pycparser import c_ast

from . import tree as T

NAMES = {"f32": "float", "i32": "int", "u32": "uint", "i64": "int64_t", "u64": "uint64_t", "u8": "uint8_t",
         "bool": "bool", "void": "void"}
SUFFIXES = {"u32": "u", "i64": "l", "u64": "ul"}
# Words of GLSL that kernels have as names, or well might.
RESERVED = set("""active attribute buffer cast centroid class coherent common enum external filter fixed flat half in
	inout input interface invariant layout lowp mat3 noise out output partition patch precise precision readonly
	resource sample sampler shared smooth subroutine superp template texture this uniform union using varying vec2 vec3
	vec4 writeonly""".split())
LEVELS = [["||"], ["&&"], ["|"], ["^"], ["&"], ["==", "!="], ["<", ">", "<=", ">="], ["<<", ">>"], ["+", "-"],
          ["*", "/", "%"]]
PRECEDENCE = {op: level for level, ops in enumerate(LEVELS) for op in ops}
BITWISE, COMPARES = {"<<", ">>", "&", "|", "^"}, {"==", "!=", "<", ">", "<=", ">="}
UNARY, PRIMARY = 20, 30


def kernels():
	"""Each kernel with the struct of its arguments, in the order of backends/kernels.def."""
	command = ["scripts/assembled", "src/backends/kernels.def"]
	done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True)
	return re.findall(r"^KERNEL\((\w+), (\w+)\)", done.stdout, re.M)


def name_of(word):
	return word + "_" if word in RESERVED else word


def member_of(word):
	return word + "_" if word == "length" else name_of(word)


def is_own(kind):
	return kind.kind == "pointer" and not kind.of.shared


def home_of(node):
	"""The header that a node stands in, below src/kernels."""
	path = T.place(node.coord.file.split("@")[-1])
	return os.path.relpath(path, "src/kernels")


def is_mixed(node, op):
	"""What readers have to think about, parentheses or not."""
	if not isinstance(node, c_ast.BinaryOp) or node.op == op:
		return False
	return op in BITWISE or (op in COMPARES and node.op in BITWISE)


def is_same(node, op):
	return isinstance(node, c_ast.BinaryOp) and node.op == op


def below(node):
	yield node
	for child in T.children(node):
		yield from below(child)


def literal(text, kind):
	return text if kind == "f32" else text.rstrip("uUlL") + SUFFIXES.get(kind, "")
