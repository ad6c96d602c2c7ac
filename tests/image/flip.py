"""LDR-FLIP by numpy, from the paper, with whole kernels of two dimensions: a second opinion on src/image/flip.c.
evaluate(reference, image, ppd): the errors of two arrays of height x width x 3 bytes."""
import numpy as np

PRIMARIES = np.array([[0.64, 0.33], [0.30, 0.60], [0.15, 0.06]])
WHITE = np.array([0.3127, 0.3290])


def to_xyz():
	"""The matrix of linear sRGB, from chromaticities."""
	def xyz(xy):
		return np.array([xy[0] / xy[1], 1, (1 - xy[0] - xy[1]) / xy[1]])
	columns = np.stack([xyz(xy) for xy in PRIMARIES], axis=1)
	return columns * np.linalg.solve(columns, xyz(WHITE))


MATRIX = to_xyz()
SUM = MATRIX.sum(axis=1)


def filtered(plane, kernel):
	reach = kernel.shape[0] // 2
	padded = np.pad(plane, reach, mode="edge")
	out = np.zeros_like(plane)
	for y in range(2 * reach + 1):
		for x in range(2 * reach + 1):
			out += kernel[y, x] * padded[y:y + plane.shape[0], x:x + plane.shape[1]]
	return out


def grid(reach):
	return np.mgrid[-reach:reach + 1, -reach:reach + 1].astype(float)


def sensitivity(terms, ppd):
	reach = int(np.ceil(3 * np.sqrt(0.04 / (2 * np.pi ** 2)) * ppd))
	y, x = grid(reach) / ppd
	kernel = sum(a * np.sqrt(np.pi / b) * np.exp(-np.pi ** 2 * (x * x + y * y) / b) for a, b in terms)
	return kernel / kernel.sum()


def lab(rgb):
	t = rgb @ MATRIX.T / SUM
	f = np.where(t > (6 / 29) ** 3, np.cbrt(t), t * (29 / 6) ** 2 / 3 + 4 / 29)
	lightness = 116 * f[..., 1] - 16
	return np.stack([lightness, 5 * lightness * (f[..., 0] - f[..., 1]), 2 * lightness * (f[..., 1] - f[..., 2])], -1)


def hyab(a, b):
	d = np.abs(a - b)
	return d[..., 0] + np.sqrt(d[..., 1] ** 2 + d[..., 2] ** 2)


def opponent(image):
	v = image / 255
	linear = np.where(v <= 0.04045, v / 12.92, ((v + 0.055) / 1.055) ** 2.4)
	x, y, z = np.moveaxis(linear @ MATRIX.T / SUM, -1, 0)
	return 116 * y - 16, 500 * (x - y), 200 * (y - z)


def perceived(image, ppd):
	planes = zip(opponent(image), ([(1, 0.0047)], [(1, 0.0053)], [(34.1, 0.04), (13.5, 0.025)]))
	y, cx, cz = (filtered(plane, sensitivity(terms, ppd)) for plane, terms in planes)
	y = (y + 16) / 116
	xyz = np.stack([cx / 500 + y, y, y - cz / 200], -1) * SUM
	return lab(np.clip(xyz @ np.linalg.inv(MATRIX).T, 0, 1))


def strengths(image, ppd):
	"""Of edges and of points."""
	sigma = 0.5 * 0.082 * ppd
	y, x = grid(int(np.ceil(3 * sigma)))
	g = np.exp(-(x * x + y * y) / (2 * sigma * sigma))
	plane = (opponent(image)[0] + 16) / 116
	for kernel in (-x * g, (x * x / (sigma * sigma) - 1) * g):
		kernel = np.where(kernel > 0, kernel / kernel[kernel > 0].sum(), kernel / -kernel[kernel < 0].sum())
		yield np.hypot(filtered(plane, kernel), filtered(plane, kernel.T))


def colour_term(a, b):
	"""Of two colours in the observer's L*a*b*."""
	most = hyab(lab(np.array([0.0, 1, 0])), lab(np.array([0.0, 0, 1]))) ** 0.7
	d = hyab(a, b) ** 0.7
	return np.where(d < 0.4 * most, 0.95 * d / (0.4 * most), 0.95 + 0.05 * (d - 0.4 * most) / (0.6 * most))


def evaluate(reference, image, ppd):
	colour = colour_term(perceived(reference, ppd), perceived(image, ppd))
	apart = [np.abs(a - b) for a, b in zip(strengths(reference, ppd), strengths(image, ppd))]
	return colour ** (1 - np.sqrt(np.maximum(*apart) / np.sqrt(2)))
