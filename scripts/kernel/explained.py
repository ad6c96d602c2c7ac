"""The kernels as C that tells what it computes: parameters, variables, results, decisions and stores, and the titles
of paragraphs, each with its place in the text. What each tells is a row of a table (src/explain/told.h)."""
from pycparser import c_ast, c_generator

from . import tree as T
from .comments import comments
from .glsl import parameters
from .glsl_words import below, home_of, is_own
from .left import Left

# What items change for one another: offers(where, what), or changes(where).
ATOMIC = {"ts_min_u64", "ts_min_u32", "ts_or_u64", "ts_add_i64", "ts_next_i64", "ts_next_u32", "ts_mark_u8"}


class Writer(c_generator.CGenerator):
	"""A function NAME becomes told_NAME. What stands in one expression is computed from left to right, as compilers
	need not."""

	def __init__(self, tree):
		super().__init__()
		self.tree, self.plain = tree, c_generator.CGenerator()
		self.sites, self.types, self.n_names = [], {}, 0

	def function(self, function):
		self.returns, self.titled, self.left = function.type.of, {function.line}, Left(function)
		head = self.head(function)
		lines = [f"ts_told_call({self.site('CALL', function.node, function.name)});"]
		for node, kind in zip(parameters(function), function.type.with_):
			lines += self.parameter(function, node, kind)
		self.indent_level = 2
		body = "".join(map(self._generate_stmt, function.node.body.block_items or []))
		self.indent_level = 0
		return clean(f"{head}\n{{\n  " + "\n  ".join(lines) + f"\n{body}  ts_told_end();\n}}\n")

	def head(self, function):
		return clean(self.visit(function.node.decl).replace(function.name, "told_" + function.name, 1))

	def parameter(self, function, node, kind):
		"""The arguments of kernels are told once; what is not written yet, when it is."""
		if not is_own(kind):
			return [self.told("VALUE", node, node.name, kind, "&" + node.name)]
		length = self.tree.value(node.type.dim) if isinstance(node.type, c_ast.ArrayDecl) and node.type.dim else None
		of = kind.of if length is None else T.Type("array", "array", kind.of, length=length)
		is_known = kind.of.const and (not self.has_pointers(of) or function.name.endswith("_item"))
		return [self.told("VALUE", node, node.name, of, node.name)] if is_known else []

	def has_pointers(self, kind):
		if kind.kind == "struct":
			return any(map(self.has_pointers, self.tree.structs[kind.name].values()))
		return kind.kind == "pointer" or (kind.kind == "array" and self.has_pointers(kind.of))

	def site(self, how, node, text, kind=None, left=False):
		of = "NULL" if kind is None else f"&types[{self.type_number(kind)}]"
		text, line = clean(text.replace("ts_null", "NULL")), node.coord.line
		self.sites.append(f'{{TS_TOLD_{how}, "{home_of(node)}", {line}, {str(left).lower()}, "{text}", {of}}}')
		return f"&sites[{len(self.sites) - 1}]"

	def type_number(self, kind):
		name = self.type_name(kind)
		self.types.setdefault(name, (len(self.types), list(self.leaves(kind, ""))))
		return self.types[name][0]

	def type_name(self, kind):
		if kind.kind == "array":
			return f"{self.type_name(kind.of)}[{kind.length}]"
		return "void *" if kind.kind == "pointer" else kind.name

	def leaves(self, kind, path, offset="0"):
		"""Path, offset in C, scalar."""
		if kind.kind == "array":
			for i in range(kind.length):
				yield from self.leaves(kind.of, f"{path}[{i}]", f"{offset} + {i} * sizeof({self.type_name(kind.of)})")
		elif kind.kind == "struct":
			for name, member in self.tree.structs[kind.name].items():
				yield from self.leaves(member, f"{path}.{name}", f"{offset} + offsetof({kind.name}, {name})")
		else:
			yield path, offset.replace("0 + ", ""), kind.name

	def told(self, how, node, text, kind, at, left=False):
		return f"ts_told({self.site(how, node, text, kind, left)}, {at});"

	def stored(self, node, what, at):
		to, left = self.tree.type_of(what), self.left.leaves(node, what)
		return self.told("STORE" if to.shared else "VALUE", node, self.plain.visit(what), to, at, left)

	def name(self):
		self.n_names += 1
		return f"told{self.n_names}"

	def tells(self, node):
		return any(isinstance(each, (c_ast.Assignment, c_ast.TernaryOp)) or is_step(each) or self.is_telling_call(each)
		           for each in below(node))

	def is_telling_call(self, node):
		return isinstance(node, c_ast.FuncCall) and (node.name.name in self.tree.functions or node.name.name in ATOMIC)

	def in_order(self, nodes):
		"""The texts of expressions, and what is computed before them."""
		texts, tell, before = [self.visit(node) for node in nodes], [self.tells(node) for node in nodes], ""
		for i in range(len(nodes)):
			if tell[i] and sum(tell) > 1:
				name = self.name()
				before += f"__auto_type {name} = {texts[i]}; "
				texts[i] = name
		return texts, before

	def visit_ID(self, node):
		return "NULL" if node.name == "ts_null" else node.name

	def visit_FuncCall(self, node):
		name = node.name.name
		texts, before = self.in_order(node.args.exprs if node.args else [])
		if name in ATOMIC:
			return self.atomic(node, name, texts, before)
		call = f"{'told_' if name in self.tree.functions else ''}{name}({', '.join(texts)})"
		return f"({{ {before}{call}; }})" if before else call

	def atomic(self, node, name, texts, before):
		"""Tells what is offered and what stands there then."""
		where, at, offer = node.args.exprs[0], self.name(), ""
		to = self.tree.type_of(where).of
		text = self.plain.visit(c_ast.UnaryOp("*", where)) if not is_address(where) else self.plain.visit(where.expr)
		if len(texts) > 1:
			offered = self.name()
			offer = (f"{to.name} {offered} = {texts[1]}; "
			         f"{self.told('VALUE', node, f'{name} of {text}', to, '&' + offered)}")
			texts[1] = offered
		call, after = f"{name}({', '.join([at] + texts[1:])});", self.told("STORE", node, text, to, at)
		begin = f"{before}__auto_type {at} = {texts[0]}; {offer}"
		if self.tree.type_of(node).name == "void":
			return f"({{ {begin} {call} {after} }})"
		result = self.name()
		return f"({{ {begin} __auto_type {result} = {call} {after} {result}; }})"

	def visit_BinaryOp(self, node):
		if node.op in ("&&", "||") or not (self.tells(node.left) and self.tells(node.right)):
			return super().visit_BinaryOp(node)
		texts, before = self.in_order([node.left, node.right])
		return f"({{ {before}{texts[0]} {node.op} {texts[1]}; }})"

	def visit_TernaryOp(self, node):
		return f"({self.test(node.cond)} ? ({self.visit(node.iftrue)}) : ({self.visit(node.iffalse)}))"

	def test(self, cond):
		return f"ts_told_test({self.site('TEST', cond, self.plain.visit(cond))}, {self.visit(cond)})"

	def visit_Assignment(self, node):
		at = self.name()
		given = f"*{at} {node.op} {self.visit(node.rvalue)};"
		return (f"({{ __auto_type {at} = &{self.visit(node.lvalue)}; {given} "
		        f"{self.stored(node, node.lvalue, at)} *{at}; }})")

	def visit_UnaryOp(self, node):
		if not is_step(node):
			return super().visit_UnaryOp(node)
		at, old = self.name(), self.name()
		step = (f"__auto_type {at} = &{self.visit(node.expr)}; __auto_type {old} = *{at}; "
		        f"*{at} {node.op.strip('p')[0]}= 1;")
		result = f"(void)*{at}; {old}" if node.op.startswith("p") else f"(void){old}; *{at}"
		return f"({{ {step} {self.stored(node, node.expr, at)} {result}; }})"

	def visit_Return(self, node):
		if node.expr is None:
			return "{ ts_told_end(); return; }"
		return f"{{ {self.c_type(self.returns)} told = {self.visit(node.expr)}; " + \
			f"{self.told('RESULT', node, 'returns', self.returns, '&told')} ts_told_end(); return told; }}"

	def c_type(self, kind):
		if kind.kind != "pointer":
			return kind.name
		return ("const " if kind.of.const else "") + self.c_type(kind.of) + " *"

	def visit_If(self, node):
		text = f"if ({self.test(node.cond)})\n" + self.braced(node.iftrue)
		return text + (f"{self._make_indent()}else\n{self.braced(node.iffalse)}" if node.iffalse else "")

	def visit_While(self, node):
		return f"while ({self.test(node.cond)})\n" + self.braced(node.stmt)

	def visit_For(self, node):
		"""What its first part declares is told before it."""
		first = node.init.decls if isinstance(node.init, c_ast.DeclList) else [node.init] if node.init else []
		self.indent_level += 2
		begin = "".join(map(self._generate_stmt, first))
		head = f"{self._make_indent()}for (; {self.visit(node.cond)}; {self.visit(node.next)})\n"
		text = "{\n" + begin + head + self.braced(node.stmt)
		self.indent_level -= 2
		return text + self._make_indent() + "}\n"

	def braced(self, node):
		return self.visit(node if isinstance(node, c_ast.Compound) else c_ast.Compound([node], node.coord))

	def visit_ParamList(self, node):
		return ", ".join(self._generate_decl(each) if isinstance(each, c_ast.Decl) else self.visit(each)
		                 for each in node.params)

	def visit_Decl(self, node, no_type=False):
		"""What has no value yet is 0, so that what is told never depends on what was in memory."""
		bare = self._generate_decl(node)
		if isinstance(node.type, c_ast.FuncDecl):
			return bare
		if node.init is None:
			return f"{bare} = {'{0}' if self.kind(node).kind in ('struct', 'array') else '0'}"
		if isinstance(node.init, c_ast.InitList):
			texts, before = self.in_order(node.init.exprs)
			return f"{before}{bare} = {{{', '.join(texts)}}}"
		return f"{bare} = {self.visit(node.init)}"

	def kind(self, node):
		kind = self.tree.declaration(node.type)
		is_counted = kind.kind == "array" and kind.length is None
		return kind._replace(length=len(node.init.exprs)) if is_counted else kind

	def title(self, node):
		"""What the comment above a statement says, once."""
		if isinstance(node, c_ast.Compound) or not node.coord or node.coord.line in self.titled:
			return ""
		self.titled.add(node.coord.line)
		lines = comments(node.coord.file.split("@")[0]).above.get(node.coord.line)
		return f"{self._make_indent()}ts_told_title({self.site('TITLE', node, quoted(lines))});\n" if lines else ""

	def _generate_stmt(self, node, add_indent=False):
		"""Before a statement stands its title, and behind a declaration what tells it."""
		title = self.title(node)
		text = title + super()._generate_stmt(node, add_indent)
		if not isinstance(node, c_ast.Decl) or node.init is None or is_own(self.kind(node)):
			return text
		kind = self.kind(node)
		lines = [self.told("VALUE", node, node.name, kind, "&" + node.name, self.left.leaves(node, node))]
		if kind.kind == "pointer" and kind.of.kind == "struct" and kind.of.const and is_address(node.init):
			lines.append(self.told("VALUE", node, "*" + node.name, kind.of, node.name))
		return text + "".join(f"{self._make_indent()}{line}\n" for line in lines)


def quoted(lines):
	"""As a string of C has it."""
	return " ".join(lines).replace("\\", "\\\\").replace('"', '\\"')


def is_address(node):
	return isinstance(node, c_ast.UnaryOp) and node.op == "&"


def is_step(node):
	return isinstance(node, c_ast.UnaryOp) and node.op in ("++", "--", "p++", "p--")


def clean(text):
	"""Without what only the tree needs."""
	return text.replace("volatile ", "").replace("restrict ", "")
