"""What the tests of the package for Python share: a context, a small scene, and a run."""
import pytest
import touchstone

pytest_plugins = ["touchstone.pytest"]
SMALL = {"width": 64, "height": 36, "reflectors.count": 2, "cube.max_px": 16}


@pytest.fixture(scope="session")
def context():
	return touchstone.Context(threads=2)


@pytest.fixture(scope="session")
def scene(context):
	return context.open_scene("atrium:triangles=10000:texels=32", SMALL)


@pytest.fixture(scope="session")
def reference(context, scene):
	return context.run(scene, "reflections", "epr", SMALL)
