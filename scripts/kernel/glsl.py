"""The kernels as GLSL for Vulkan: buffer references in the place of pointers to what items share, values and `inout` in the
place of pointers to what is an item's own."""
import os
import re
import subprocess

from pycparser import c_ast

from . import tree as T
from .comments import comments
from .layout import Layout

NAMES = {"f32": "float", "i32": "int", "u32": "uint", "i64": "int64_t", "u64": "uint64_t", "u8": "uint8_t", "bool": "bool", "void": "void"}
SUFFIXES = {"u32": "u", "i64": "l", "u64": "ul"}
# Words of GLSL that the kernels use as names.
RESERVED = set("""active attribute buffer cast centroid class coherent common cube enum external far filter fixed flat half image
	in inout input interface invariant layout line lowp mat3 near noise out output partition patch point precise precision
	readonly resource sample sampler shared smooth subroutine superp template texture this uniform union using varying vec2
	vec3 vec4 writeonly""".split()) - {"near", "far", "image", "point", "line", "cube"}
PRECEDENCE = {op: level for level, ops in enumerate(reversed([["*", "/", "%"], ["+", "-"], ["<<", ">>"], ["<", ">", "<=", ">="],
	["==", "!="], ["&"], ["^"], ["|"], ["&&"], ["||"]])) for op in ops}
BITWISE, COMPARES = {"<<", ">>", "&", "|", "^"}, {"==", "!=", "<", ">", "<=", ">="}
UNARY, PRIMARY = 20, 30
COLUMNS = 120


def kernels():
	"""Each kernel with the struct of its arguments, in the order of backends/kernels.def."""
	done = subprocess.run(["scripts/assembled", "src/backends/kernels.def"], stdout=subprocess.PIPE, text=True, check=True)
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


class Writer:
	"""guarded: loops tell when a driver ends them early, by ts_turn, ts_open and ts_looped of compat.glsl."""

	def __init__(self, tree, guarded=False):
		self.tree, self.layout, self.guarded = tree, Layout(tree), guarded
		self.parameters = {name: self.parameters_of(f) for name, f in tree.functions.items()}
		self.lengths = Lengths(tree).found
		self.aliases, self.breaks = {}, []
		self.lines, self.depth, self.path, self.line = [], 0, None, None

	# Types

	def parameters_of(self, function):
		listed = function.node.decl.type.args
		return [p for p in (listed.params if listed else []) if p.name is not None]

	def type(self, kind):
		if kind.kind == "scalar":
			return NAMES[kind.name]
		if kind.kind == "struct":
			return kind.name
		if kind.kind == "array":
			return self.type(self.element(kind)) + self.dimensions(kind)
		if kind.kind == "pointer" and kind.of.shared:
			return self.reference(kind.of)
		return self.type(kind.of)

	def element(self, kind):
		return self.element(kind.of) if kind.kind == "array" else kind

	def dimensions(self, kind):
		return f"[{kind.length}]{self.dimensions(kind.of)}" if kind.kind == "array" else ""

	def reference(self, kind):
		return f"{kind.name}_ref"

	def declared(self, kind, name):
		return f"{self.type(self.element(kind))} {name_of(name)}{self.dimensions(kind)}"

	# Expressions: each gives its text and how tightly it binds.

	def value(self, node):
		"""As it is used: what is own and pointed to is the thing itself."""
		return self.expression(node)[0]

	def bound(self, node, tight, op=None):
		text, level = self.expression(node)
		return text if level >= tight and not is_mixed(node, op) else f"({text})"

	def as_type(self, node, to, tight=0, op=None):
		"""Converted as C converts it without being told."""
		of = self.tree.type_of(node)
		if to.kind == "scalar" and of.kind == "scalar" and to.name != of.name:
			return self.converted(node, of, to)
		if of.kind == "null":
			return f"{self.type(to)}(0ul)"
		return self.bound(node, tight, op)

	def converted(self, node, of, to):
		if isinstance(node, c_ast.Constant) and to.name in ("i32", "u32", "i64", "u64"):
			return literal(node.value, to.name)
		inner = self.value(node)
		if of.name == "i32" and to.name in ("i64", "u64"):
			return f"ts_i64({inner})" if to.name == "i64" else f"uint64_t(ts_i64({inner}))"
		return f"{NAMES[to.name]}({inner})"

	def expression(self, node):
		return getattr(self, "of_" + type(node).__name__)(node)

	def of_Constant(self, node):
		return literal(node.value, self.tree.type_of(node).name), PRIMARY

	def of_ID(self, node):
		if node.name in self.aliases:
			return self.aliases[node.name], PRIMARY
		kind = self.tree.type_of(node)
		if kind.kind == "array" and self.is_shared(kind):
			raise T.Refused(self.path, node.coord.line, "an array that items share")
		return name_of(node.name), PRIMARY

	def is_shared(self, kind):
		return self.element(kind).shared

	def of_FuncCall(self, node):
		name = node.name.name
		arguments = node.args.exprs if node.args else []
		kinds = self.tree.names[0][name].with_
		texts = [self.argument(argument, kind) for argument, kind in zip(arguments, kinds)]
		return f"{name}({', '.join(texts)})", PRIMARY

	def argument(self, node, kind):
		return self.as_type(node, kind)

	def of_StructRef(self, node):
		kind = self.tree.type_of(node)
		if kind.kind == "array" and self.is_shared(kind):
			return self.address(node, kind.of)
		return self.place(node), PRIMARY

	of_ArrayRef = of_StructRef

	def place(self, node):
		"""A thing, to be read or written."""
		if isinstance(node, c_ast.StructRef):
			holder = self.tree.type_of(node.name)
			if node.type == "->" and holder.of.shared:
				return f"{self.bound(node.name, PRIMARY)}.v.{member_of(node.field.name)}"
			inner = self.place(node.name) if node.type == "." else self.bound(node.name, PRIMARY)
			return f"{inner}.{member_of(node.field.name)}"
		if isinstance(node, c_ast.ArrayRef):
			return self.element_place(node)
		if isinstance(node, c_ast.UnaryOp) and node.op == "*":
			return self.pointed(node.expr)
		return self.bound(node, PRIMARY)

	def pointed(self, node):
		"""What a pointer is to."""
		if not self.tree.type_of(node).of.shared:
			return self.bound(node, PRIMARY)
		if isinstance(node, c_ast.UnaryOp) and node.op == "&":
			return self.place(node.expr)
		return f"{self.bound(node, PRIMARY)}.v"

	def element_place(self, node):
		of = self.tree.type_of(node.name)
		if of.kind == "pointer" and of.of.shared:
			text, level = self.element_address(node)
			return f"{text}.v" if level == PRIMARY else f"({text}).v"
		return f"{self.place(node.name)}[{self.value(node.subscript)}]"

	def element_address(self, node):
		"""Of an element behind a pointer, and how tightly it binds."""
		of = self.tree.type_of(node.name)
		at = self.value(node.subscript)
		if of.parted:
			return f"TS_PART({self.reference(of.of)}, {self.value(node.name)}, {at}, {self.layout.size(of.of)})", PRIMARY
		if self.tree.type_of(node.subscript).name not in ("i64", "u64"):
			return f"{self.bound(node.name, PRIMARY)}[{at}]", PRIMARY
		level = PRECEDENCE["+"]
		return f"{self.bound(node.name, level)} + {self.bound(node.subscript, level + 1)}", level

	def bytes(self, node):
		"""Where something that items share lies: a reference and an offset behind it."""
		if isinstance(node, c_ast.ArrayRef):
			of = self.tree.type_of(node.name)
			if of.kind == "pointer":
				return self.element_address(node)[0], []
			base, offset = self.bytes(node.name)
			return base, offset + [f"uint64_t({self.value(node.subscript)}) * {self.layout.size(of.of)}ul"]
		if isinstance(node, c_ast.StructRef):
			of = self.tree.type_of(node.name)
			holder = of.of if node.type == "->" else of
			base, offset = (self.value(node.name), []) if node.type == "->" else self.bytes(node.name)
			at = self.layout.offsets(holder._replace(shared=False, const=False))[node.field.name]
			return base, offset + ([f"{at}ul"] if at else [])
		if isinstance(node, c_ast.UnaryOp) and node.op == "*":
			return self.value(node.expr), []
		raise T.Refused(self.path, node.coord.line, "this has no address")

	def address(self, node, kind):
		if isinstance(node, c_ast.ArrayRef) and self.tree.type_of(node.name).kind == "pointer":
			return self.element_address(node)
		base, offset = self.bytes(node)
		return f"{self.reference(kind)}({' + '.join([f'uint64_t({base})', *offset])})", PRIMARY

	def of_UnaryOp(self, node):
		if node.op == "&":
			of = self.tree.type_of(node.expr)
			return self.address(node.expr, of) if of.shared else (self.place(node.expr), PRIMARY)
		if node.op == "*":
			return self.place(node), PRIMARY
		if self.tree.type_of(node).kind == "pointer":
			return f"{self.place(node.expr)} = {self.place(node.expr)} {node.op.strip('p')[0]} 1", -1
		if node.op in ("p++", "p--"):
			return self.place(node.expr) + node.op[1:], UNARY
		if node.op in ("++", "--"):
			return node.op + self.place(node.expr), UNARY
		of = self.tree.type_of(node.expr)
		inner = self.as_type(node.expr, T.I32, UNARY) if of.name == "u8" else self.bound(node.expr, UNARY + 1)
		return node.op + inner, UNARY

	def of_BinaryOp(self, node):
		left, right = self.tree.type_of(node.left), self.tree.type_of(node.right)
		level = PRECEDENCE[node.op]
		if {"pointer", "array", "null"} & {left.kind, right.kind}:
			return self.of_pointers(node, left, right, level)
		if node.op in ("&&", "||"):
			return f"{self.operand(node.left, node.op)} {node.op} {self.operand(node.right, node.op)}", level
		if node.op in ("<<", ">>"):
			to = T.scalar(T.wider(left.name, "i32"))
			return f"{self.as_type(node.left, to, level, node.op)} {node.op} {self.bound(node.right, level + 1, node.op)}", level
		to = T.scalar(T.wider(left.name, right.name)) if "f32" not in (left.name, right.name) else left
		if left.name == right.name == "bool":
			to = left
		return f"{self.as_type(node.left, to, level, node.op)} {node.op} {self.as_type(node.right, to, level + 1, node.op)}", level

	def operand(self, node, op):
		"""Of && and ||, which stand in parentheses in each other."""
		text, level = self.expression(node)
		return f"({text})" if level < PRECEDENCE["||"] or (level <= PRECEDENCE["&&"] and not is_same(node, op)) else text

	def of_pointers(self, node, left, right, level):
		if node.op in ("==", "!="):
			return f"{self.as_address(node.left)} {node.op} {self.as_address(node.right)}", level
		if not left.of.shared:
			raise T.Refused(self.path, node.coord.line, "a pointer to an item's own is moved")
		text = self.value(node.left) if level <= PRECEDENCE["+"] else self.bound(node.left, level)
		return f"{text} {node.op} {self.bound(node.right, level + 1)}", level

	def as_address(self, node):
		return "0ul" if self.tree.type_of(node).kind == "null" else f"uint64_t({self.value(node)})"

	def of_TernaryOp(self, node):
		kind = self.tree.type_of(node)
		yes, no = self.as_type(node.iftrue, kind, 1), self.as_type(node.iffalse, kind, 0)
		return f"{self.bound(node.cond, 1)} ? {yes} : {no}", 0

	def of_Cast(self, node):
		to, of = self.tree.type_of(node), self.tree.type_of(node.expr)
		if to.kind == "pointer":
			return f"{self.type(to)}(uint64_t({self.value(node.expr)}))", PRIMARY
		if to.name == "void":
			return self.expression(node.expr)
		if to.name == of.name:
			return self.expression(node.expr)
		return self.converted(node.expr, of, to), PRIMARY

	def of_Assignment(self, node):
		to = self.tree.type_of(node.lvalue)
		if node.op in ("<<=", ">>="):
			return f"{self.place(node.lvalue)} {node.op} {self.value(node.rvalue)}", -1
		return f"{self.place(node.lvalue)} {node.op} {self.given(node.rvalue, to)}", -1

	def of_ExprList(self, node):
		return ", ".join(self.value(each) for each in node.exprs), -2

	def given(self, node, to):
		if isinstance(node, c_ast.InitList):
			return self.constructed(node, to)
		return self.as_type(node, to)

	def constructed(self, node, to):
		if to.kind == "array":
			to = to if to.length is not None else to._replace(length=len(node.exprs))
			return f"{self.type(to)}({', '.join(self.given(each, to.of) for each in node.exprs)})"
		members = self.tree.structs[to.name].values()
		padding = ["0u"] if self.is_padded(to) else []
		return f"{to.name}({', '.join([self.given(each, kind) for kind, each in zip(members, node.exprs)] + padding)})"

	# Statements

	def put(self, text):
		self.lines.append("\t" * self.depth + text if text else "")

	def taken(self):
		lines, self.lines = self.lines, []
		return lines

	def statement(self, node):
		self.comment_above(node)
		at = len(self.lines)
		getattr(self, "put_" + type(node).__name__, self.put_expression)(node)
		if len(self.lines) == at + 1 and node.coord and node.coord.line != self.line:
			self.comment_behind(node)

	def comment_above(self, node):
		if not isinstance(node, c_ast.Compound) and node.coord and node.coord.line != self.line:
			self.documented(node)

	def comment_behind(self, node):
		lines = self.comments(node).behind.get(node.coord.line)
		if lines and "//" not in self.lines[-1]:
			self.lines[-1] += f" // {lines[0]}"

	def comments(self, node):
		return comments(node.coord.file.split("@")[0])

	def put_comment(self, lines):
		if len(lines) == 1:
			self.put(f"// {lines[0]}")
		else:
			for line in lines:
				self.put(f"// {line}".rstrip())

	def put_expression(self, node):
		self.put(self.value(node) + ";")

	def put_Compound(self, node):
		self.put("{")
		self.inner(node.block_items or [])
		self.put("}")

	def inner(self, nodes):
		self.depth += 1
		for node in nodes:
			self.statement(node)
		self.depth -= 1

	def put_Decl(self, node):
		self.put(self.declaration(node) + ";" if not self.is_alias(node) else "")
		if not self.lines[-1]:
			self.lines.pop()

	def is_alias(self, node):
		"""A pointer to an item's own: a name for the thing itself, as long as that is found without an index."""
		kind = self.tree.declaration(node.type)
		if not is_own(kind):
			return False
		if any(isinstance(each, c_ast.ArrayRef) for each in below(node.init)):
			return False
		self.aliases[node.name] = self.value(node.init)
		return True

	def declaration(self, node):
		kind = self.tree.declaration(node.type)
		if kind.kind == "array" and kind.length is None:
			kind = kind._replace(length=len(node.init.exprs))
		text = self.declared(kind, node.name)
		return text if node.init is None else f"{text} = {self.given(node.init, kind.of if is_own(kind) else kind)}"

	def put_DeclList(self, node):
		for each in node.decls:
			self.statement(each)

	def put_Return(self, node):
		self.put("return;" if node.expr is None else f"return {self.given(node.expr, self.returns)};")

	def put_If(self, node):
		self.put_headed(f"if ({self.value(node.cond)})", node.iftrue)
		if node.iffalse is None:
			return
		closes = self.lines[-1].strip() == "}"
		at = len(self.lines)
		if isinstance(node.iffalse, c_ast.If):
			self.put_If(node.iffalse)
		else:
			self.put_headed("", node.iffalse)
		first = self.lines[at].strip()
		if closes:
			self.lines[at - 1 : at + 1] = ["\t" * self.depth + f"}} else {first}".rstrip()]
		else:
			self.lines[at] = "\t" * self.depth + f"else {first}".rstrip()

	def put_headed(self, head, body):
		if isinstance(body, c_ast.Compound) or (self.guarded and isinstance(body, c_ast.Break)):
			self.put(f"{head} {{".lstrip())
			self.inner(body.block_items or [] if isinstance(body, c_ast.Compound) else [body])
			self.put("}")
			return
		at = len(self.lines)
		self.inner([body])
		if len(self.lines) == at + 1 and len(head) + len(self.lines[at].expandtabs(4)) < COLUMNS:
			self.lines[at] = "\t" * self.depth + f"{head} {self.lines[at].strip()}".lstrip()
		else:
			self.lines.insert(at, "\t" * self.depth + head)

	def put_While(self, node):
		if self.guarded:
			self.put_loop("", self.value(node.cond), "", node.stmt)
		else:
			self.put_headed(f"while ({self.value(node.cond)})", node.stmt)

	def put_For(self, node):
		first = "" if node.init is None else self.for_first(node.init)
		cond = "" if node.cond is None else self.value(node.cond)
		self.put_loop(first, cond, "" if node.next is None else self.value(node.next), node.stmt)

	def put_loop(self, first, cond, following, body):
		if self.guarded:
			cond = f"ts_turn({cond or 'true'})"
			following = ", ".join(filter(None, [following, "ts_open = true"]))
		self.breaks.append(True)
		head = "; ".join([first, cond, following]).replace("; ;", ";;")
		if self.guarded and not isinstance(body, c_ast.Compound):
			body = c_ast.Compound([body], body.coord)
		self.put_headed(f"for ({head})".replace("; )", ";)"), body)
		self.breaks.pop()
		if self.guarded:
			self.put("ts_looped();")

	def for_first(self, node):
		if not isinstance(node, c_ast.DeclList):
			return self.value(node)
		first, *others = [self.declaration(each) for each in node.decls]
		return ", ".join([first] + [text.split(" ", 1)[1] for text in others])

	def put_Switch(self, node):
		self.put(f"switch ({self.value(node.cond)}) {{")
		self.switch = self.tree.type_of(node.cond)
		self.breaks.append(False)
		for each in node.stmt.block_items:
			self.statement(each)
		self.breaks.pop()
		self.put("}")

	def put_Case(self, node):
		self.put(f"case {self.as_type(node.expr, self.switch)}:")
		self.inner(node.stmts)

	def put_Default(self, node):
		self.put("default:")
		self.inner(node.stmts)

	def put_Break(self, _):
		if self.guarded and self.breaks[-1]:
			self.put("ts_open = false;")
		self.put("break;")

	def put_Continue(self, _):
		self.put("continue;")

	def put_EmptyStatement(self, _):
		self.put(";")

	# What stands outside functions

	def function(self, function):
		self.path, self.line, self.returns, self.aliases = function.path, function.line, function.type.of, {}
		self.documented(function.node.decl)
		for lengths in self.lengths.get(function.name, [{}]):
			texts = [self.parameter(p, kind, lengths.get(p.name)) for p, kind in zip(self.parameters[function.name], function.type.with_)]
			self.put(f"{self.type(function.type.of)} {function.name}({', '.join(texts)})")
			self.statement(function.node.body)
			self.put("")

	def documented(self, node):
		lines = self.comments(node).above.get(node.coord.line)
		if lines:
			self.put_comment(lines)

	def parameter(self, node, kind, length):
		if not is_own(kind):
			return self.declared(kind, node.name)
		how = "" if kind.of.const else "inout "
		of = kind.of if length is None else T.Type("array", "array", kind.of, length=length)
		return how + self.declared(of, node.name)

	def is_padded(self, kind):
		return any(member.kind == "pointer" for member in self.tree.structs[kind.name].values()) and self.layout.is_padded(kind)

	def struct(self, node):
		self.documented(node)
		kind = T.Type("struct", node.name)
		self.put(f"struct {node.name} {{")
		self.depth += 1
		for member in node.type.type.decls:
			self.documented(member) if member.coord.line != node.coord.line else None
			self.put(self.declared(self.tree.structs[node.name][member.name], member_of(member.name)) + ";")
			self.comment_behind(member)
		if self.is_padded(kind):
			self.put("uint padding;")
		self.depth -= 1
		self.put("};")

	def refer(self, kind):
		"""A type of references."""
		align = self.layout.align(kind)
		self.put(f"layout(buffer_reference, scalar, buffer_reference_align = {align}) buffer {self.reference(kind)} {{ {self.type(kind)} v; }};")

	def enumeration(self, node):
		for each in node.values.enumerators:
			self.put(f"const int {each.name} = {self.tree.enumerators[each.name]};")

	def constant(self, node):
		self.documented(node)
		self.put(f"const {self.declaration(node)};")


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


class Lengths(c_ast.NodeVisitor):
	"""Pointers to an item's own that are arrays: the lengths that callers give, by function, as lists of {parameter: length}."""

	def __init__(self, tree):
		self.tree, self.found = tree, {}
		for function in tree.functions.values():
			self.function = function
			self.visit(function.node.body)

	def visit_FuncCall(self, node):
		self.generic_visit(node)
		function = self.tree.functions.get(node.name.name)
		if function is None or not node.args:
			return
		lengths = {}
		for parameter, kind, argument in zip(function.node.decl.type.args.params, function.type.with_, node.args.exprs):
			of = self.tree.type_of(argument)
			if is_own(kind) and of.kind == "array":
				lengths[parameter.name] = of.length
			elif is_own(kind) and isinstance(argument, c_ast.ID) and argument.name in self.own_arrays():
				lengths[parameter.name] = self.own_arrays()[argument.name]
		if lengths and lengths not in self.found.setdefault(function.name, []):
			self.found[function.name].append(lengths)

	def own_arrays(self):
		"""The caller's parameters that are declared as arrays."""
		listed = self.function.node.decl.type.args
		return {p.name: self.tree.value(p.type.dim) for p in (listed.params if listed else [])
		        if isinstance(p.type, c_ast.ArrayDecl) and p.type.dim is not None}
