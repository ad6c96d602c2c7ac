"""Float literals of the kernels (rule 7)."""
import re
import struct
from decimal import Decimal

DECIMAL = r"\d+\.\d*(?:[eE][-+]?\d+)?|\d+[eE][-+]?\d+|\.\d+(?:[eE][-+]?\d+)?"
LITERAL = re.compile(r"(?<![\w.])(?:" + DECIMAL + r"|0[xX][0-9a-fA-F.]*[pP][-+]?\d+)[fFlL]?(?![\w.])")


def fault(text):
	"""Why a literal is refused; None if it is not."""
	if text[:2] in ("0x", "0X"):
		return f"{text}: hexadecimal floats are not in CUDA C: write decimals"
	digits = text.rstrip("fFlL")
	if text[-1] not in "fF":
		return f"{text} is not a float: end it in f"
	try:
		nearest = struct.unpack("<f", struct.pack("<f", float(digits)))[0]
	except OverflowError:
		return f"{text} is out of range"
	if Decimal(digits) == Decimal(nearest):
		return None
	bits = struct.unpack("<I", struct.pack("<f", nearest))[0]
	return f"{text} is not exact: write {Decimal(nearest):f}f or ts_u2f(0x{bits:08x}u)"
