"""The kernels' text as a tree whose expressions have types: what checks and translates kernels begins with it."""
import gc
import operator
import os
import re
import subprocess
from collections import namedtuple

from pycparser import c_ast, c_parser

gc.disable()  # a tree leaves no garbage: looking for it takes a quarter of the time
HERE = os.path.dirname(__file__)
LANGUAGE = os.path.join(HERE, "language.h")
ALL = "src/backends/kernels.h"
SHARED, PARTED = "volatile", "restrict"  # how language.h marks what items share, and what may be in parts

# kind: scalar, struct, pointer, null, array, function or list (of an initializer); of: what a pointer or an array is
# to, what a function returns; with: a function's parameters; shared: by items; const: is not written; parted: a pointer
# to what may be in parts; length: of an array, None if its initializer tells.
Type = namedtuple("Type", "kind name of with_ shared const parted length",
                  defaults=(None, None, (), False, False, False, None))
Function = namedtuple("Function", "name node type path line")

KNOWN = {"+": operator.add, "-": operator.sub, "*": operator.mul, "<<": operator.lshift}
INTEGERS = {"i32", "u32", "i64", "u64", "u8"}
SCALARS = INTEGERS | {"f32", "bool", "void"}
BOOL, I32 = Type("scalar", "bool"), Type("scalar", "i32")


class Refused(Exception):
	"""Text that is not of the language: path, line, reason."""


def place(path):
	"""A path as it is printed."""
	path = path.split("@")[0]
	below = os.path.relpath(path)
	return path if below.startswith("..") else below


def scalar(name):
	return Type("scalar", name)


def marked(kind, shared, const):
	"""Of an array, each element."""
	if kind.kind == "array":
		return kind._replace(of=marked(kind.of, shared, const))
	return kind._replace(shared=kind.shared or shared, const=kind.const or const)


def decayed(kind):
	"""As a parameter."""
	return Type("pointer", "pointer", kind.of) if kind.kind == "array" else kind


def is_constant(kind):
	return is_constant(kind.of) if kind.kind == "array" else kind.const


def children(node):
	return [child for _, child in node.children()]


def is_literal(node):
	return isinstance(node, c_ast.Constant) or (isinstance(node, c_ast.UnaryOp) and node.op == "-"
	                                            and is_literal(node.expr))


def preprocessed(paths):
	text = "".join(f'#include "{os.path.abspath(path)}"\n' for path in paths)
	flags = ["-E", "-nostdinc", "-undef", "-std=c11", "-Iinclude", "-iquote", "src", "-include", LANGUAGE, "-x", "c",
	         "-"]
	done = subprocess.run(["gcc", *flags], input=text, capture_output=True, text=True, errors="replace", check=False)
	if done.returncode != 0:
		path, line, _, reason = (done.stderr.split("\n")[0] + ":::").split(":", 3)
		raise Refused(place(path), int(line) if line.isdigit() else 0, reason.strip(" :"))
	return with_homes(done.stdout)


def with_homes(text):
	"""Names a .def file together with the header that it is read into: "records.def@records.h"."""
	lines, within = text.split("\n"), []
	for number, line in enumerate(lines):
		marker = re.match(r'# (\d+) "(.*)"( [12])?', line)
		if not marker:
			continue
		if marker[3] == " 2":
			within.pop()
		if marker[3] == " 1":
			within.append(marker[2])
		within[-1:] = [marker[2]]
		if marker[2].endswith(".def"):
			home = next(path for path in reversed(within) if not path.endswith(".def"))
			lines[number] = f'# {marker[1]} "{marker[2]}@{home}"'
	return "\n".join(lines)


class Tree:
	"""functions and constants: by name, in the order of the text; structs: members by name; type_of(expression)."""

	def __init__(self, paths=(ALL,)):
		self.functions, self.constants, self.structs, self.declared = {}, {}, {}, {}
		self.enumerators = {}
		self.names, self.types, self.near = [{}], {}, None
		try:
			self.file = c_parser.CParser().parse(preprocessed(paths), "kernels")
		except c_parser.ParseError as error:
			path, line, _, reason = (str(error) + ":::").split(":", 3)
			raise Refused(place(path), int(line or 0), f"this is not in the language:{reason.rstrip(':')}") from error
		for node in self.file.ext:
			self.add(node)

	def type_of(self, expression):
		return self.types[id(expression)]

	def add(self, node):
		if isinstance(node, c_ast.Typedef):
			self.declared[node.name] = self.declaration(node.type, node.name)
		elif isinstance(node, c_ast.FuncDef):
			self.add_function(node)
		elif isinstance(node, c_ast.Decl):
			self.add_constant(node)
		else:
			self.refuse(node, f"no {type(node).__name__} is in the language")

	def add_constant(self, node):
		kind = self.declaration(node.type)
		if node.name is None:
			return
		self.names[0][node.name] = kind
		if kind.kind == "function" and node.coord.file != LANGUAGE:
			self.refuse(node, f"{node.name}() is declared without its body")
		if kind.kind != "function" and not is_constant(kind):
			self.refuse(node, f"{node.name} is outside functions and not constant")
		if node.init is not None:
			self.expression(node.init)
			self.constants[node.name] = node

	def add_function(self, node):
		kind = self.declaration(node.decl.type)
		self.names[0][node.decl.name] = kind
		parameters = node.decl.type.args.params if node.decl.type.args else []
		self.names.append({p.name: self.declaration(p.type) for p in parameters})
		self.statement(node.body)
		self.names.pop()
		path = place(node.coord.file)
		self.functions[node.decl.name] = Function(node.decl.name, node, kind, path, node.coord.line)

	def refuse(self, node, reason):
		at = node.coord or self.near
		raise Refused(place(at.file), at.line, reason)

	def declaration(self, node, name=None):
		if isinstance(node, c_ast.TypeDecl):
			return marked(self.named(node, name), SHARED in node.quals, "const" in node.quals)
		if isinstance(node, c_ast.PtrDecl):
			if SHARED in node.quals:
				self.refuse(node, "TS_GLOBAL stands before what a pointer is to")
			to = self.declaration(node.type)
			if to.kind == "function" or to.name == "void":
				self.refuse(node, f"no pointer is to {'a function' if to.kind == 'function' else 'void'}")
			return Type("pointer", "pointer", to, parted=PARTED in node.quals)
		if isinstance(node, c_ast.ArrayDecl):
			return Type("array", "array", self.declaration(node.type), length=self.length(node))
		if isinstance(node, c_ast.FuncDecl):
			parameters = node.args.params if node.args else []
			if any(isinstance(p, c_ast.ID) for p in parameters):
				self.refuse(node, "parameters are declared in their list")
			kinds = tuple(decayed(self.held(p)) for p in parameters)
			return Type("function", "function", self.declaration(node.type),
			            tuple(kind for kind in kinds if kind.name != "void"))
		if isinstance(node, (c_ast.Typename, c_ast.Decl)):
			return self.declaration(node.type)
		if isinstance(node, c_ast.Enum):
			return self.enumeration(node)
		return self.refuse(node, "no such declaration is in the language")

	def held(self, node):
		"""The type of a variable, parameter or member, which are an item's own."""
		kind = self.declaration(node.type)
		if kind.kind != "array" and kind.shared:
			self.refuse(node, "TS_GLOBAL stands before what a pointer is to")
		return kind

	def length(self, node):
		length = self.value(node.dim) if node.dim is not None else None
		if node.dim is not None and length is None:
			self.refuse(node, "an array's length is known before the kernel runs")
		return length

	def value(self, node):
		"""Of an integer that is known before the kernel runs; None: it is not."""
		if isinstance(node, c_ast.ID):
			return self.enumerators.get(node.name)
		if isinstance(node, c_ast.BinaryOp) and node.op in KNOWN:
			left, right = self.value(node.left), self.value(node.right)
			return None if left is None or right is None else KNOWN[node.op](left, right)
		is_integer = isinstance(node, c_ast.Constant) and node.type not in ("float", "double", "char", "string")
		return int(node.value.rstrip("uUlL"), 0) if is_integer else None

	def enumeration(self, node):
		following = 0
		for each in node.values.enumerators if node.values else []:
			self.names[0][each.name] = I32
			value = self.value(each.value) if each.value is not None else following
			if value is None:
				self.refuse(node, f"the value of {each.name} is known before the kernel runs")
			self.enumerators[each.name] = value
			following = value + 1
		return I32

	def named(self, node, name):
		of = node.type
		if isinstance(of, c_ast.Enum):
			return self.enumeration(of)
		if isinstance(of, c_ast.Struct) and of.decls:
			self.structs[name] = {member.name: self.held(member) for member in of.decls}
			return Type("struct", name)
		word = " ".join(of.names) if isinstance(of, c_ast.IdentifierType) else None
		if name in SCALARS or word in SCALARS:
			return scalar(name if name in SCALARS else word)
		if word in self.declared:
			return self.declared[word]
		known = "f32, i32, u32, i64, u64, u8, bool and structs are"
		return self.refuse(of if of.coord else node, f"`{word or 'union'}` is no type of the kernels: {known}")

	def statement(self, node):
		self.near = node.coord or self.near
		if isinstance(node, (c_ast.Compound, c_ast.For)):
			self.names.append({})
			self.statements(children(node))
			self.names.pop()
		elif isinstance(node, c_ast.Decl):
			self.names[-1][node.name] = self.held(node)
			if node.storage:
				self.refuse(node, f"no variable of a function is {node.storage[0]}")
			if node.init is not None:
				self.expression(node.init)
		elif isinstance(node, (c_ast.Goto, c_ast.Label, c_ast.DoWhile)):
			self.refuse(node, "no goto and no do is in the language")
		elif isinstance(node, STATEMENTS):
			self.statements(children(node))
		else:
			self.expression(node)

	def statements(self, nodes):
		for node in nodes:
			self.statement(node)

	def expression(self, node):
		kind = type(node).__name__
		if not hasattr(self, "of_" + kind):
			self.refuse(node, f"no {kind} is in the language")
		self.types[id(node)] = getattr(self, "of_" + kind)(node)
		return self.types[id(node)]

	def of_Constant(self, node):
		if node.type in ("float", "double"):
			return scalar("f32")
		if node.type in ("char", "string"):
			self.refuse(node, f"no {node.type} is in the language")
		suffix = node.value.lower()
		return scalar(("u" if "u" in suffix else "i") + ("64" if "l" in suffix else "32"))

	def of_ID(self, node):
		if node.name == "ts_null":
			return Type("null", "null")
		for names in reversed(self.names):
			if node.name in names:
				return names[node.name]
		return self.refuse(node, f"`{node.name}` is not declared in the kernels")

	def of_FuncCall(self, node):
		if not isinstance(node.name, c_ast.ID):
			self.refuse(node, "functions are called by their names")
		name = node.name.name
		found = self.names[0].get(name)
		if found is None or found.kind != "function":
			self.refuse(node, f"{name}() is not in the contract: use ts_* of num.h and vec.h")
		arguments = node.args.exprs if node.args else []
		if len(arguments) != len(found.with_):
			self.refuse(node, f"{name}() takes {len(found.with_)} arguments")
		for argument in arguments:
			self.expression(argument)
		return found.of

	def of_StructRef(self, node):
		of = self.expression(node.name)
		holder = of.of if node.type == "->" else of
		member = self.structs.get(holder.name, {}).get(node.field.name)
		if member is None:
			self.refuse(node, f"{holder.name} has no member {node.field.name}")
		return self.held_by(holder, member)

	@staticmethod
	def held_by(holder, member):
		"""What is in a shared or constant struct is that too."""
		if member.kind == "pointer":
			return member
		if member.kind == "array":
			return member._replace(of=Tree.held_by(holder, member.of))
		return member._replace(shared=holder.shared or member.shared, const=holder.const or member.const)

	def of_ArrayRef(self, node):
		self.expression(node.subscript)
		return self.element(node, self.expression(node.name))

	def element(self, node, of):
		if of.kind not in ("pointer", "array"):
			self.refuse(node, "this is no pointer and no array")
		return of.of

	def of_UnaryOp(self, node):
		if node.op == "sizeof":
			self.refuse(node, "no sizeof is in the language")
		of = self.expression(node.expr)
		if node.op == "*":
			return self.element(node, of)
		if node.op == "&":
			return Type("pointer", "pointer", of)
		return BOOL if node.op == "!" else of._replace(shared=False, const=False)

	def of_BinaryOp(self, node):
		left, right = self.expression(node.left), self.expression(node.right)
		if node.op in ("&&", "||", "==", "!=", "<", ">", "<=", ">="):
			return BOOL
		if left.kind in ("pointer", "array") and right.name in INTEGERS:
			return Type("pointer", "pointer", left.of)
		if left.kind != "scalar" or right.kind != "scalar":
			self.refuse(node, f"{left.kind} {node.op} {right.kind} is not in the language")
		if node.op in ("<<", ">>"):
			return left
		return scalar(wider(left.name, right.name))

	def of_TernaryOp(self, node):
		self.expression(node.cond)
		yes, no = self.expression(node.iftrue), self.expression(node.iffalse)
		if yes.kind != no.kind and "null" not in (yes.kind, no.kind):
			self.refuse(node, f"one of {yes.kind} and {no.kind}")
		return scalar(wider(yes.name, no.name)) if yes.kind == no.kind == "scalar" else yes

	def of_Cast(self, node):
		self.expression(node.expr)
		return self.declaration(node.to_type)

	def of_Assignment(self, node):
		self.expression(node.rvalue)
		return self.expression(node.lvalue)

	def of_ExprList(self, node):
		return [self.expression(each) for each in node.exprs][-1]

	def of_InitList(self, node):
		for each in node.exprs:
			self.expression(each)
		return Type("list", "list")


STATEMENTS = (c_ast.DeclList, c_ast.If, c_ast.While, c_ast.Return, c_ast.Switch, c_ast.Case, c_ast.Default, c_ast.Break,
              c_ast.Continue, c_ast.EmptyStatement)
RANKS = ["bool", "u8", "i32", "u32", "i64", "u64", "f32"]


def wider(a, b):
	"""The usual arithmetic conversions; what is narrower than i32 becomes i32."""
	return RANKS[max(2, RANKS.index(a), RANKS.index(b))] if (a, b) != ("bool", "bool") else "bool"
