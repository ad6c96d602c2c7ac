"""For a port's tests: `pytest_plugins = ["touchstone.pytest"]` in conftest.py brings the fixture `touchstone_judge`.

	def test_eye(touchstone_judge):
		touchstone_judge("eye", reference, port)     fails with the line of the first divergence"""
from __future__ import annotations

from collections.abc import Callable

import pytest

import touchstone


@pytest.fixture(scope="session")
def touchstone_context() -> touchstone.Context:
	"""One context for all tests."""
	return touchstone.Context()


@pytest.fixture
def touchstone_judge(
	touchstone_context: touchstone.Context,
) -> Callable[[str, touchstone.Trace, touchstone.Trace], None]:
	"""Fails unless a stage is right, given the candidate's own inputs."""

	def judge(stage: str, reference: touchstone.Trace, candidate: touchstone.Trace) -> None:
		verdicts = touchstone_context.replay(stage, reference, candidate)
		if not verdicts:
			pytest.fail(verdicts.first.line, pytrace=False)

	return judge
