"""All of the public headers is reachable from Python, with types."""
import inspect
import pathlib
import re
import typing

import touchstone

PACKAGE = pathlib.Path(touchstone.__file__).parent
# What Python has of its own instead.
INSTEAD = {"ts_params_copy": "dict"} | {f"ts_tree_{what}": "json"
                                        for what in ("at", "get", "integer", "kind_of", "n", "name", "real",
                                                                               "text")}


def test_each_function_of_the_headers_is_called():
	declared = set(re.findall(r"\b(ts_\w+)\(", (PACKAGE / "declarations.h").read_text()))
	called = set(re.findall(r"\blib\.(ts_\w+)\b", "".join(file.read_text() for file in PACKAGE.glob("*.py"))))
	assert len(declared) > 90 and called <= declared
	assert declared - called == set(INSTEAD)


def public():
	"""(name, function) of all that is called from outside."""
	for name in touchstone.__all__:
		thing = getattr(touchstone, name)
		for method, function in vars(thing).items() if inspect.isclass(thing) else [(None, thing)]:
			function = getattr(function, "fget", None) or getattr(function, "__wrapped__", function)
			if inspect.isfunction(function) and (method is None or not method.startswith("_") or method.endswith("__")):
				yield f"{name}.{method}" if method else name, function


def test_each_has_types():
	functions = dict(public())
	assert len(functions) > 80 and "Trace.about" in functions and "buffers" in functions
	for name, function in functions.items():
		hints = typing.get_type_hints(function)
		assert set(hints) == set(inspect.signature(function).parameters) - {"self"} | {"return"}, name
	assert (PACKAGE / "py.typed").exists()
