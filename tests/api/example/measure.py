"""Two methods beside rays: the error of a picture, the time of a stage, the bytes of a buffer; as measure.c."""
import touchstone

SMALL = {"width": 96, "height": 54, "reflectors.count": 2, "cube.max_px": 64}


def main():
	context = touchstone.Context()
	scene = context.open_scene("atrium:triangles=10000:texels=32", SMALL)
	rendering = context.render(scene, "reflections", ["epr", "mvr"], "B", SMALL)
	for method in ("epr", "mvr"):
		print(f"{method}.rmse.B {rendering[f'{method}.rmse.B']:.6f}")
	print(f"epr.bytes.points.record {rendering['epr.bytes.points.record']:.0f}")
	print(f"epr.ms.splat {rendering['epr.ms.splat']:.1f}")


main()
