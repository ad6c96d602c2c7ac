"""Two methods beside rays: the error of a picture, the time of a stage, the bytes of a buffer; as measure.c."""
import touchstone

SIZE = {"width": 160, "height": 90}


def main():
	context = touchstone.Context()
	scene = context.open_scene("atrium:triangles=20000", SIZE)
	rendering = context.render(scene, "reflections", ["epr", "mvr"], "B", SIZE)
	for method in ("epr", "mvr"):
		print(f"{method}.rmse.B {rendering[f'{method}.rmse.B']:.6f}")
	print(f"epr.bytes.points.record {rendering['epr.bytes.points.record']:.0f}")
	print(f"epr.ms.splat {rendering['epr.ms.splat']:.1f}")


main()
