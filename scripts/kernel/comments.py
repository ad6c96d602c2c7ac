"""The comments of a file, by the lines that they stand at: what is printed of the kernels keeps them."""
import functools
import re

COMMENT = re.compile(r"/\*.*?\*/", re.S)


def plain(comment):
	"""Without the stars."""
	return [re.sub(r"^\s*\* ?", "", line).rstrip() for line in comment[2:-2].strip().split("\n")]


class Comments:
	"""above[line]: the comment that stands alone on the lines before it; behind[line]: the one at its end."""

	def __init__(self, path):
		with open(path, encoding="utf-8") as file:
			text = file.read()
		self.above, self.behind = {}, {}
		for match in COMMENT.finditer(text):
			first, last = text.count("\n", 0, match.start()) + 1, text.count("\n", 0, match.end()) + 1
			alone = text[text.rfind("\n", 0, match.start()) + 1 : match.start()].strip() == ""
			if alone:
				self.above[last + 1] = plain(match[0])
			elif first == last:
				self.behind[first] = plain(match[0])


comments = functools.lru_cache(maxsize=None)(Comments)
