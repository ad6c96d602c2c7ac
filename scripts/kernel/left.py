"""What the paragraphs of a function leave: variables that other paragraphs read, and what stands behind pointers that
the function was given. A paragraph goes from its title to the next. It leaves no counter of a loop."""
import bisect
from collections import ChainMap

from pycparser import c_ast

from . import tree as T
from .comments import comments
from .titles import Lines


class Left:
	def __init__(self, function):
		body, above = function.node.body, comments(function.path).above
		self.begins = sorted(line for line in above if body.coord.line < line <= Lines(body).last)
		# By id: of a name its declaration, of a declaration the paragraphs that read it; parameters; counters.
		self.home, self.read_in, self.given, self.counts = {}, {}, set(), set()
		scope = ChainMap()
		arguments = function.node.decl.type.args
		for node in arguments.params if arguments else []:
			if isinstance(node, c_ast.Decl):
				self.declare(node, scope)
				self.given.add(id(node))
		self.walk(body, scope)

	def paragraph(self, node):
		"""0: before the first title."""
		return bisect.bisect_right(self.begins, node.coord.line)

	def declare(self, node, scope):
		scope[node.name] = self.home[id(node)] = node

	def walk(self, node, scope):
		if isinstance(node, (c_ast.Compound, c_ast.For)):
			scope = scope.new_child()
		if isinstance(node, c_ast.For) and isinstance(node.init, c_ast.DeclList):
			self.counts.update(map(id, node.init.decls))
		if isinstance(node, c_ast.ID):
			self.read(node, scope)
		elif isinstance(node, c_ast.StructRef):
			self.walk(node.name, scope)
		elif isinstance(node, c_ast.Assignment) and node.op == "=" and isinstance(node.lvalue, c_ast.ID):
			self.home[id(node.lvalue)] = scope.get(node.lvalue.name)
			self.walk(node.rvalue, scope)
		else:
			for child in T.children(node):
				self.walk(child, scope)
		if isinstance(node, c_ast.Decl):
			self.declare(node, scope)

	def read(self, node, scope):
		home = self.home[id(node)] = scope.get(node.name)
		self.read_in.setdefault(id(home), set()).add(self.paragraph(node))

	def leaves(self, node, what):
		"""Whether the paragraph of the node leaves the value that it gives to `what`."""
		name = root(what)
		home = self.home.get(id(name))
		if id(home) in self.given and name is not what:
			return not isinstance(home.type, c_ast.TypeDecl)
		at = self.paragraph(node)
		if home is None or at == 0 or id(home) in self.counts:
			return False
		return bool(self.read_in.get(id(home), set()) - {at})


def root(node):
	"""The name that a place begins with, or the declaration."""
	while isinstance(node, (c_ast.StructRef, c_ast.ArrayRef, c_ast.UnaryOp)):
		node = node.expr if isinstance(node, c_ast.UnaryOp) else node.name
	return node
