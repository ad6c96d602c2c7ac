"""A headless Chromium, spoken to over a pipe in the DevTools protocol. Needs nothing but Python and the browser.

with Browser(width, height, dark) as page: page.open(path); page.run("document.title"); page.press("Tab")."""
import base64
import json
import os
import shutil
import subprocess
import tempfile
import time

KEYS = {"Tab": 9, "Enter": 13, "Space": 32, "ArrowLeft": 37, "ArrowUp": 38, "ArrowRight": 39, "ArrowDown": 40}
DEADLINE_S = 60


def found():
	return shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")


class Browser:
	def __init__(self, width, height, dark=False, phone=False):
		self.size, self.dark, self.phone = (width, height), dark, phone
		self.last, self.faults, self.requests, self.session, self.buffer = 0, [], [], None, b""

	def __enter__(self):
		self.profile = tempfile.mkdtemp()
		theirs, self.to = os.pipe()
		self.back, ours = os.pipe()
		command = (f"exec '{found()}' --headless=new --no-sandbox --disable-gpu --disable-dev-shm-usage "
		           f"--hide-scrollbars --no-first-run --user-data-dir='{self.profile}' "
		           f"--remote-debugging-pipe about:blank 3<&{theirs} 4>&{ours}")
		self.process = subprocess.Popen(["bash", "-c", command], pass_fds=(theirs, ours), stdin=subprocess.DEVNULL,
		                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
		os.close(theirs)
		os.close(ours)
		target = self.call("Target.createTarget", url="about:blank")["targetId"]
		self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
		for domain in ("Page", "Runtime", "Log", "Network"):
			self.call(domain + ".enable")
		width, height = self.size
		self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1,
		          mobile=self.phone)
		scheme = {"name": "prefers-color-scheme", "value": "dark" if self.dark else "light"}
		self.call("Emulation.setEmulatedMedia", features=[scheme])
		return self

	def __exit__(self, *_):
		self.process.kill()
		self.process.wait()
		os.close(self.to)
		os.close(self.back)
		shutil.rmtree(self.profile, ignore_errors=True)

	def receive(self):
		while b"\0" not in self.buffer:
			more = os.read(self.back, 1 << 20)
			if not more:
				raise EOFError("the browser ended")
			self.buffer += more
		message, self.buffer = self.buffer.split(b"\0", 1)
		return json.loads(message)

	def note(self, message):
		params = message.get("params", {})
		if message.get("method") == "Runtime.exceptionThrown":
			self.faults.append(params["exceptionDetails"].get("exception", {}).get("description", "exception"))
		if message.get("method") == "Runtime.consoleAPICalled" or message.get("method") == "Log.entryAdded":
			self.faults.append(json.dumps(params)[:500])
		if message.get("method") == "Network.requestWillBeSent":
			url = params["request"]["url"]
			if not url.startswith(("data:", "blob:")):
				self.requests.append(url)

	def call(self, method, **params):
		self.last += 1
		message = {"id": self.last, "method": method, "params": params}
		if self.session:
			message["sessionId"] = self.session
		os.write(self.to, json.dumps(message).encode() + b"\0")
		while True:
			answer = self.receive()
			if answer.get("id") == self.last:
				if "error" in answer:
					raise RuntimeError(f"{method}: {answer['error']}")
				return answer["result"]
			self.note(answer)

	def run(self, expression):
		"""The value of a JavaScript expression."""
		answer = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
		if "exceptionDetails" in answer:
			raise RuntimeError(f"{expression}: {answer['exceptionDetails']}")
		return answer["result"].get("value")

	def wait(self, expression):
		"""Until it is true."""
		end = time.monotonic() + DEADLINE_S
		while not self.run(expression):
			if time.monotonic() > end:
				raise TimeoutError(expression)
			time.sleep(0.02)

	def open(self, path):
		self.call("Page.navigate", url="file://" + os.path.abspath(path))
		self.wait("document.readyState === 'complete' && document.querySelector('main') !== null")

	def press(self, key, shift=False):
		code = KEYS[key]
		text = {"Space": " ", "Enter": "\r"}.get(key, "")
		named = {"key": " " if key == "Space" else key, "code": key, "windowsVirtualKeyCode": code,
		         "modifiers": 8 if shift else 0}
		self.call("Input.dispatchKeyEvent", type="keyDown", text=text, **named)
		self.call("Input.dispatchKeyEvent", type="keyUp", **named)

	def click(self, x, y):
		for kind in ("mouseMoved", "mousePressed", "mouseReleased"):
			self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)

	def picture(self, path, whole=True):
		"""A screenshot, of the whole page."""
		height = self.run("document.documentElement.scrollHeight") if whole else self.size[1]
		clip = {"x": 0, "y": 0, "width": self.size[0], "height": min(height, 8000), "scale": 1}
		data = self.call("Page.captureScreenshot", format="png", captureBeyondViewport=whole, clip=clip)["data"]
		with open(path, "wb") as file:
			file.write(base64.b64decode(data))
