"""For a port's tests: `pytest_plugins = ["touchstone.pytest"]` in conftest.py brings the fixture `touchstone_judge`.

	def test_eye(touchstone_judge):
		touchstone_judge("eye", reference, port)     fails with the line of the first divergence"""
import pytest

import touchstone


@pytest.fixture(scope="session")
def touchstone_context():
	"""One context for all tests."""
	return touchstone.Context()


@pytest.fixture
def touchstone_judge(touchstone_context):
	"""Fails unless a stage is right, given the candidate's own inputs."""

	def judge(stage, reference, candidate):
		verdicts = touchstone_context.replay(stage, reference, candidate)
		if not verdicts:
			pytest.fail(verdicts.first.line, pytrace=False)

	return judge
