"""What becomes of a file, and whether that is right. A judge has the outcome that the table says, and fault(loader,
document): None, or what is other than it says."""
import collections
import os
import tempfile

import scenes
import touchstone

HELD, REFUSED, NOTED, NO_CONSEQUENCE = "held", "refused", "noted", "no consequence"
MUST, SHOULD, MAY = "MUST", "SHOULD", "MAY"
CLOSE = 2e-3
BASE = scenes.base()

Judge = collections.namedtuple("Judge", "outcome fault")
Seen = collections.namedtuple("Seen", "error notes picture surfels")
Row = collections.namedtuple("Row", "section level requirement name document judge remark")


class Chapter(list):
	"""Rows of the table, under a title."""

	def __init__(self, title):
		super().__init__()
		self.title = title

	def row(self, section, level, requirement, name, document, judge, remark=""):
		self.append(Row(section, level, requirement, name, document, judge, remark))


class Loader:
	"""Opens documents as files of a scratch folder, and draws them."""

	def __init__(self):
		self.folder = tempfile.TemporaryDirectory()
		self.context = touchstone.Context(threads=1)
		self.seen = {}

	def look(self, document, size=16, frame=0, points=False):
		asked = (document.file(), tuple(sorted(document.beside)), size, frame, points)
		if asked not in self.seen:
			self.seen[asked] = self.opened(document, size, frame, points)
		return self.seen[asked]

	def opened(self, document, size, frame, points):
		path = os.path.join(self.folder.name, f"scene{document.suffix}")
		for name, content in {**document.beside, path: document.file()}.items():
			with open(os.path.join(self.folder.name, name), "wb") as file:
				file.write(content)
		params = {"width": size, "height": size, "frame": frame, **({} if points else {"reflectors.count": 0})}
		try:
			scene = self.context.open_scene(path, params)
			trace = self.context.run(scene, *(("surfels", "deferred") if points else ("reflections", "mvr")), params)
			return Seen(None, scene.info()["notes"], trace["image.radiance"].copy(),
			            trace["scene.surfel"].copy() if points else None)
		except touchstone.Error as error:
			return Seen(str(error), [], None, None)
		finally:
			for name in document.beside:
				os.remove(os.path.join(self.folder.name, name))


# ---- what is other ----

def of_notes(notes, words):
	"""Each of the words is in a note, and each note has one of them."""
	for word in words:
		if not any(word in note for note in notes):
			return f"no note has {word}; notes: {' | '.join(notes) or 'none'}"
	other = [note for note in notes if not any(word in note for word in words)]
	return f"a note besides: {other[0]}" if other else None


def of_pixel(found, right, where):
	if all(abs(float(a) - b) <= CLOSE * max(1, abs(b)) for a, b in zip(found, right)):
		return None
	return f"{where} is {' '.join(f'{value:.4f}' for value in found)}; {right} is right"


def drawn(check, outcome, *words, **look):
	"""A judge of a file that is drawn, by check(loader, seen)."""
	def fault(loader, document):
		seen = loader.look(document, **look)
		if seen.error:
			return f"refused: {seen.error}"
		return check(loader, seen) or of_notes(seen.notes, words)
	return Judge(outcome, fault)


def like(other, outcome, *words, size=16, frame=0):
	def check(loader, seen):
		right = loader.look(other, size)
		if right.error:
			return f"its equivalent is refused: {right.error}"
		apart = float(abs(seen.picture - right.picture).max())
		return None if apart <= CLOSE else f"{apart:.3g} from its equivalent"
	return drawn(check, outcome, *words, size=size, frame=frame)


# ---- judges ----

def same(other, *words, frame=0):
	"""It looks like the other document, which says the same in a plainer way; with words it is noted, too. frame: at
	this frame it looks like the other at the first."""
	return like(other, NOTED if words else HELD, *words, frame=frame)


def ignored(other=BASE):
	"""It looks like the other document, not a word is said, and none is needed: nothing of it is read, or there is no
	other way to read it."""
	return like(other, NO_CONSEQUENCE)


def pixels(right, *words, size=16):
	"""Pixels of its picture, (x, y), have these colours; with words it is noted, too."""
	def check(_loader, seen):
		found = (of_pixel(seen.picture[y][x], colour, f"pixel {x}, {y}") for (x, y), colour in right.items())
		return next(filter(None, found), None)
	return drawn(check, NOTED if words else HELD, *words, size=size)


def more_than(other, right):
	"""Its middle has so much more light than the other's."""
	def check(loader, seen):
		return of_pixel(seen.picture[8][8] - loader.look(other).picture[8][8], right, "what is more of the middle")
	return drawn(check, HELD)


def middle_as(other):
	"""The middle of its picture, of an odd size, is that of the other's."""
	def check(loader, seen):
		right = [float(value) for value in loader.look(other, 17).picture[8][8]]
		return of_pixel(seen.picture[8][8], right, "the middle")
	return drawn(check, HELD, size=17)


def inside_alone():
	"""Its middle is lit, and its corners are dark."""
	def check(_loader, seen):
		lit, dark = seen.picture[8][8][0], seen.picture[2][2][0]
		return None if lit > 0.1 and dark == 0 else f"the middle is {lit:.4f}, a corner {dark:.4f}"
	return drawn(check, HELD)


def point_colour(right, *words):
	"""The first of its points has this colour."""
	def check(_loader, seen):
		return of_pixel(seen.surfels[0]["colour"], right, "the first point")
	return drawn(check, NOTED if words else HELD, *words, points=True)


def refused(*words):
	"""It is refused by one line that has these words."""
	def fault(loader, document):
		error = loader.look(document).error
		if error is None:
			return "not refused"
		return next((f"refused without {word}: {error}" for word in words if word not in error), None)
	return Judge(REFUSED, fault)


def noted(*words):
	"""It is drawn, and these words say what of it is not."""
	return drawn(lambda _loader, _seen: None, NOTED, *words)


def by_test(path, *names):
	"""No file can ask; these tests of C do."""
	def fault(_loader, _document):
		with open(os.path.join("tests", path), encoding="utf-8") as file:
			text = file.read()
		return next((f"tests/{path} has no {name}" for name in names if f"void {name}(" not in text), None)
	return Judge(HELD, fault)
