"""Modules of kernels as a C file, packed by zlib, as src/backends/devices/modules.h unpacks them."""
import zlib

BYTES_A_LINE = 32
ESCAPED = [f"\\{byte:03o}" for byte in range(256)]


def show(maker, modules):
	"""Prints the modules, bytes each, in the order of the kernels.
	Compilers read a string ten times faster than a list of numbers."""
	packed = zlib.compress(b"".join(modules))
	firsts = [sum(map(len, modules[:at])) for at in range(len(modules) + 1)]
	print(f"/* Made by {maker} from src/kernels. */")
	print(f"static const u32 first_byte[TS_N_KERNELS + 1] = {{{', '.join(map(str, firsts))}}};")
	print("static const u8 packed[] =", end="")
	for at in range(0, len(packed), BYTES_A_LINE):
		print('\n\t"' + "".join(map(ESCAPED.__getitem__, packed[at : at + BYTES_A_LINE])) + '"', end="")
	print(";")
