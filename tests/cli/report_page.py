"""A page in a browser (browser.py). Usage: report_page.py COMPARED RENDERED HOSTILE ODD SWEEP SEQUENCE, pages that
tests/cli/report.sh made. Prints a line a check, "ok NAME" or "not ok NAME: WHY"."""
import json
import os
import sys

from browser import Browser

READY = "document.querySelectorAll('.sheet canvas').length > 0 && parts.readout.textContent !== ''"
FOCUSABLE = ("[...document.querySelectorAll('a[href], button, select, input, summary, [tabindex=\"0\"]')]"
             ".filter((e) => e.checkVisibility() && !(e.type === 'radio' && !e.checked))")
NAMED = {"button", "combobox", "slider", "radio", "checkbox", "application", "region", "link", "navigation", "status",
         "image"}


def opened(page, path):
	page.open(path)
	page.wait(READY)
	return page


def clicked(page, x, y):
	"""Clicks the pixel in the first picture."""
	page.run("document.getElementById('pictures').scrollIntoView(), 0")
	left, top = page.run(f"""(() => {{ const box = document.querySelector('.sheet').getBoundingClientRect();
		return [box.left + box.width * ({x} + 0.5) / view.a.width,
			box.top + box.height * ({y} + 0.5) / view.a.height]; }})()""")
	page.click(left, top)
	page.wait(f"parts.pixel.textContent.includes('Pixel ({x}, {y})')")
	return page.run("parts.pixel.textContent")


def mode(page, name):
	page.run(f"document.querySelector('input[value={name}]').click(), 0")
	page.wait(f"view.mode === '{name}' && parts.mapField.hidden === {json.dumps(name != 'heat')} && "
	          f"parts.range.parentElement.hidden === {json.dumps(name != 'slider')} && "
	          f"parts.flicker.hidden === {json.dumps(name != 'flicker')}")


def quiet(page, path):
	assert not page.faults, page.faults
	assert page.requests == ["file://" + os.path.abspath(path)], page.requests


# ---- checks ----

def no_faults(pages):
	for path in pages[:5]:
		with Browser(1200, 800) as page:
			opened(page, path)
			for name in ("slider", "flicker", "heat", "side"):
				mode(page, name)
			clicked(page, 3, 4)
			quiet(page, path)


def names_and_roles(pages):
	with Browser(1200, 800) as page:
		opened(page, pages[0])
		for name in ("heat", "flicker", "slider"):
			mode(page, name)
			nodes = page.call("Accessibility.getFullAXTree")["nodes"]
			shown = [n for n in nodes if not n.get("ignored") and n["role"]["value"] in NAMED]
			unnamed = [n["role"]["value"] for n in shown if not n.get("name", {}).get("value")
			           and n["role"]["value"] != "status"]
			assert not unnamed, unnamed
			roles = {n["role"]["value"] for n in shown}
			assert {"application", "radio", "combobox", "navigation"} <= roles, roles
		assert "slider" in roles
		assert page.run("document.documentElement.lang") == "en"
		assert page.run("document.title").startswith("touchstone report: reflections of ")


def keyboard_reaches_all(pages):
	with Browser(1200, 800) as page:
		opened(page, pages[0])
		mode(page, "slider")
		wanted = page.run(f"{FOCUSABLE}.length")
		page.run(f"window.all = new Set({FOCUSABLE}), window.seen = new Set(), document.activeElement.blur(), 0")
		for _ in range(2 * wanted):
			page.press("Tab")
			page.run("seen.add(document.activeElement), 0")
			if page.run("[...all].every((e) => seen.has(e))"):
				return
		raise AssertionError(page.run("[...all].filter((e) => !seen.has(e)).map((e) => e.outerHTML.slice(0, 100))"
		                              ".join(' ')"))


def arrows_move_the_divider(pages):
	with Browser(1200, 800) as page:
		opened(page, pages[0])
		mode(page, "slider")
		where = "document.querySelectorAll('.sheet canvas')[1].style.clipPath"
		assert "50%" in page.run(where)
		page.run("parts.range.focus(), 0")
		for _ in range(3):
			page.press("ArrowRight")
		assert "53%" in page.run(where), page.run(where)
		page.press("ArrowLeft")
		assert "52%" in page.run(where), page.run(where)


def space_flickers(pages):
	with Browser(1200, 800) as page:
		opened(page, pages[0])
		page.run("parts.panes.focus(), 0")
		seen = []
		for second in (True, False, True):
			page.press("Space")
			page.wait(f"view.mode === 'flicker' && view.second === {json.dumps(second)} && "
			          f"parts.panes.querySelectorAll('canvas')[1]?.hidden === {json.dumps(not second)}")
			seen.append(page.run("parts.panes.querySelector('figcaption').textContent"))
		assert seen[0] == seen[2] != seen[1], seen
		page.run("parts.play.click(), 0")
		page.wait("view.second === false")
		page.wait("view.second === true")
		page.run("parts.play.click(), 0")
		assert page.run("view.timer") == 0


def arrows_move_the_pixel(pages):
	with Browser(1200, 800) as page:
		opened(page, pages[1])
		clicked(page, 20, 10)
		page.run("parts.panes.focus(), 0")
		for key, shift, at in (("ArrowRight", False, (21, 10)), ("ArrowDown", True, (21, 20)),
		                       ("ArrowUp", False, (21, 19)), ("ArrowLeft", True, (11, 19))):
			page.press(key, shift)
			page.wait(f"parts.pixel.textContent.includes('Pixel ({at[0]}, {at[1]})')")


def heat_maps(pages):
	colour = ("(([r, g, b]) => [r, g, b])(document.querySelector('.sheet canvas').getContext('2d')"
	          ".getImageData({}, {}, 1, 1).data)")
	with Browser(1200, 800) as page:
		opened(page, pages[0])
		mode(page, "heat")
		page.wait("parts.legend.textContent.includes('FLIP error, at 67 pixels per degree')")
		ticks = page.run("[...parts.legend.querySelectorAll('.ticks span')].map((e) => e.textContent)")
		assert ticks == ["0", "0.25", "0.5", "0.75", "1"]
		assert page.run(colour.format(90, 50)) == page.run("data.ramp[0]")
		assert page.run(colour.format(33, 20)) != page.run("data.ramp[0]")
		page.run("parts.map.value = 'difference', parts.map.dispatchEvent(new Event('change')), 0")
		page.wait("parts.legend.textContent.includes('in grey levels of 255')")
		assert page.run("[...parts.legend.querySelectorAll('.ticks span')].pop().textContent") == "64"
		assert page.run(colour.format(33, 20)) == page.run("data.ramp[255]")
		page.run("parts.map.value = 'firsts', parts.map.dispatchEvent(new Event('change')), 0")
		page.wait("parts.legend.textContent.includes('eye.depth_triangle: 1 pixel')")
		assert page.run(colour.format(10, 5)) == page.run("data.names[1]")


def differing_pixel_shows_probe(pages):
	with Browser(1200, 800) as page:
		opened(page, pages[0])
		text = clicked(page, 10, 5)
		assert "coverage" in text and "bits agree with eye.depth_triangle" in text, text
		assert "bits differ from eye.depth_triangle" in text, text
		assert page.run("parts.pixel.querySelectorAll('.leaf.changed').length") > 0
		assert page.run("parts.pixel.querySelectorAll('.crop canvas').length") == 2
		text = clicked(page, 33, 20)
		assert "coverage" in text


def other_pixel_shows_command(pages):
	with Browser(1200, 800) as page:
		opened(page, pages[0])
		text = clicked(page, 50, 40)
		assert "r/trace-epr --pixel 50,40" in text and "touchstone probe" in text and "coverage" not in text, text
		page.run("parts.pixel.querySelector('.command button').click(), 0")
		page.wait("parts.pixel.querySelector('.command button').textContent === 'Copied'")


def first_differences_told(pages):
	with Browser(1200, 800) as page:
		opened(page, pages[0])
		page.wait("document.querySelectorAll('#differences .crop canvas').length >= 4")
		text = page.run("document.getElementById('differences').textContent")
		assert "stage 04 eye, buffer eye.depth_triangle, pixel (10, 5)" in text and "inputs identical" in text, text
		assert ("+1" in text or "-1" in text), text
		head = page.run("document.querySelector('header').textContent")
		assert "different 3 of " in head and " buffers judged differ First divergence" in head, head
		counted = page.run("verdict({said: {differences: [1], judged: 2}}).textContent")
		assert "1 of 2 buffers judged differ" in counted, counted
		page.run("[...document.querySelectorAll('#differences td button')].pop().click(), 0")
		page.wait("parts.pixel.textContent.includes('Pixel (')")
		smooth = page.run("(() => { const c = document.querySelector('#differences .crop canvas');"
		                  " const d = c.getContext('2d').getImageData(0, 0, c.width, CELL).data;"
		                  " for (let x = 0; x < c.width; x++) for (let k = 0; k < 3; k++)"
		                  " if (d[4 * x + k] !== d[4 * (x - x % CELL) + k]) return true; return false; })()")
		assert smooth is False, "a crop is smoothed"


def small_screen(pages):
	for dark in (False, True):
		for path in pages[:2]:
			with Browser(360, 640, dark=dark, phone=True) as page:
				opened(page, path)
				clicked(page, 10, 5)
				page.run("document.querySelectorAll('details').forEach((e) => (e.open = true)), 0")
				for name in ("side", "slider", "flicker", "heat"):
					mode(page, name)
					assert page.run("document.documentElement.scrollWidth") == 360, (path, name)
				small = page.run("[...document.querySelectorAll('main button, main select')]"
				                 ".filter((e) => e.checkVisibility() && e.getBoundingClientRect().height < 24).length")
				assert small == 0, "a control is lower than 24 pixels"


def dark_and_light(pages):
	luminance = ("((rgb) => rgb.map((v) => (v /= 255) <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)"
	             ".reduce((sum, v, k) => sum + v * [0.2126, 0.7152, 0.0722][k], 0))")
	grounds = []
	for dark in (False, True):
		with Browser(1200, 800, dark=dark) as page:
			opened(page, pages[0])
			colour = lambda element, key: page.run(f"{luminance}(getComputedStyle(document.querySelector('{element}'))"
			                                       f".{key}.match(/\\d+/g).slice(0, 3).map(Number))")
			ground = colour("section", "backgroundColor")
			grounds.append(ground)
			for element, least in (("body", 7), (".dim", 4.5), (".a-side", 4.5), (".b-side", 4.5),
			                       ("#differences a, header a", 4.5), (".chip.different", 4.5)):
				behind = colour(element, "backgroundColor") if "chip" in element else ground
				high, low = sorted((colour(element, "color"), behind), reverse=True)
				assert (high + 0.05) / (low + 0.05) >= least, (dark, element, (high + 0.05) / (low + 0.05))
	assert grounds[0] > 0.8 and grounds[1] < 0.05, grounds


def hostile_text_is_text(pages):
	with Browser(1200, 800) as page:
		opened(page, pages[2])
		assert page.run("document.querySelectorAll('script').length") == 2
		assert page.run("window.hacked") is None and page.run("document.querySelector('b.hacked')") is None
		assert page.run("document.body.textContent"
		                ".includes('</script><script>window.hacked=1</script><b class=hacked>')")
		page.run("(() => { const s = document.createElement('script'); s.textContent = 'window.hacked = 2'; "
		         "document.body.append(s); })(), 0")
		assert page.run("window.hacked") is None, "the policy lets other scripts run"


def odd_figures_do_no_harm(pages):
	with Browser(1200, 800) as page:
		opened(page, pages[3])
		quiet(page, pages[3])
		sections = page.run("[...document.querySelectorAll('section')].map((e) => e.id)")
		assert sections == ["pictures", "differences", "figures"]
		assert page.run("document.getElementById('figures').textContent").count("cannot be shown") == 1


def series_are_told(pages):
	with Browser(1200, 800) as page:
		opened(page, pages[4])
		assert page.run("document.querySelectorAll('#plots img').length") > 0
		page.wait("[...document.querySelectorAll('#plots img')].every((e) => e.complete && e.naturalWidth > 0)")
		heads = page.run("[...document.querySelectorAll('#figures th')].map((e) => e.textContent)")
		assert "density.scale" in heads and "epr, ms" in heads and "combination" not in heads, heads
		assert "{" not in page.run("document.getElementById('figures').textContent")
		assert page.run("[...document.querySelectorAll('#stage-pictures figcaption')]"
		                ".every((e) => e.querySelector('.dim'))")
		assert page.run("[...document.querySelectorAll('.pane figcaption b')]"
		                ".every((e) => e.getClientRects().length === 1)")
	with Browser(1200, 800) as page:
		opened(page, pages[5])
		assert page.run("document.querySelector('#plots video').src").startswith("data:video/mp4;base64,")
		assert page.run("[label(view.a), label(view.b)]") == ["epr (frame-000000)", "epr (frame-000001)"]


CHECKS = [no_faults, names_and_roles, keyboard_reaches_all, arrows_move_the_divider, space_flickers,
          arrows_move_the_pixel, heat_maps,
          differing_pixel_shows_probe, other_pixel_shows_command, first_differences_told, small_screen, dark_and_light,
          hostile_text_is_text, odd_figures_do_no_harm, series_are_told]


def main():
	for check in CHECKS:
		name = "in a browser: " + check.__name__.replace("_", " ")
		try:
			check(sys.argv[1:])
			print("ok", name, flush=True)
		except Exception as error:
			print("not ok", f"{name}: {type(error).__name__}: {str(error)[:300]}".replace("\n", " "), flush=True)


main()
