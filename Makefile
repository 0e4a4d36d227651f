# The one task runner: people and CI call these recipes only.
#
# Needs Rust, Python >= 3.10, for Kotlin and the Android app a JDK and Maven, for Swift and the builds for phones root and Debian's apt;
# everything else comes from crates.io and PyPI into `target/` and `.venv/`, from Maven Central into Maven's own store, and from Debian
# Swift and a Rust for other targets into caches.

SHELL := /bin/bash
PYTHON ?= python3
VENV := $(CURDIR)/.venv
BIN := $(VENV)/bin
LOGS := build/logs
# Runs a command with its output shown and kept, so that what was skipped can be told at the end.
STEP := tests/step $(LOGS)
# Cargo's library of the Python package.
MODULE := target/debug/lib_core.$(if $(filter Darwin,$(shell uname)),dylib,so)

.PHONY: help demo check test test-core test-above graph schemas lint lint-python release-package bench gallery build package test-cached test-rust test-vectors test-faces test-python generated faces test-kotlin test-swift test-ios test-targets test-android screenshots generate test-blind test-hidden blind fuzz plan-check hidden peers blind-tools doc docs docs-tools skips report-shots clean

help:
	@echo "make demo    the main job on the sessions that ship, ending in a report"
	@echo "make check   after each change: formatting, lints, the core and the Python package; minutes"
	@echo "make test    everything that must hold; says at the end what was skipped"
	@echo "make generate  the generated Swift anew, after a change of bindings/ffi"
	@echo "make test-ios    the iOS app's types against stubs of Apple's frameworks, its texts and formatting"
	@echo "make test-targets  the library for iPhones (built) and Android (checked), no SDK needed"
	@echo "make test-android  the Android app under Robolectric; make screenshots: pictures of its screens"
	@echo "make lint    formatting and lints, Rust and Python"
	@echo "make blind   how often the stated intervals hold, on N=200 fresh sessions (14 of them in make test)"
	@echo "make fuzz    N=20000 sessions with something wrong in them: each measured or refused, in bounded time and memory"
	@echo "make plan-check  predicted against achieved uncertainty on N=100 fresh hulls (8 of them in make test): some ten minutes"
	@echo "make hidden  whether the critique finds what is hidden in N=200 fresh sessions (4 of them in make test): some hours"
	@echo "make peers   the same of sparse regression and least squares, on N=20 swings in yaw"
	@echo "make docs    the documentation site, in build/docs"
	@echo "make bench   speed of the analysis, and its speed and precision beside other methods"

demo: release-package
	@$(BIN)/gyradius demo -o build/demo

# What a developer runs after each change: the core and the Python package. Test programs that did not change since they
# passed are left out; their draws are the same every time.
check:
	@rm -rf $(LOGS) && mkdir -p $(LOGS)
	@$(STEP) fmt cargo fmt --all --check
	@$(STEP) graph $(PYTHON) core/docs/graph.py --check
	@$(STEP) clippy cargo clippy --workspace --all-targets -- -D warnings
	@$(MAKE) --no-print-directory package
	@$(STEP) rust tests/run-rust --changed --workspace
	@$(MAKE) --no-print-directory lint-python test-python

# Lints first: they are quick, and they compile what the tests need.
test:
	@rm -rf $(LOGS) && mkdir -p $(LOGS)
	@$(MAKE) --no-print-directory lint
	@$(MAKE) --no-print-directory doc
	@$(MAKE) --no-print-directory test-cached
	@$(MAKE) --no-print-directory blind-tools
	@tests/side-by-side test-core test-above
	@$(MAKE) --no-print-directory skips

lint: package
	@$(STEP) fmt cargo fmt --all --check
	@$(STEP) graph $(PYTHON) core/docs/graph.py --check
	@$(STEP) clippy cargo clippy --workspace --all-targets -- -D warnings
	@$(MAKE) --no-print-directory lint-python

lint-python: package
	@$(STEP) ruff-check $(BIN)/ruff check python tests bindings android ios
	@$(STEP) ruff-format $(BIN)/ruff format --check python
	@$(STEP) mypy $(BIN)/mypy --config-file python/pyproject.toml python/gyradius

# The cache that says whether the apps and the builds for phones are to be compiled again.
test-cached: package
	@$(STEP) cached $(BIN)/python -m pytest -q tests/test_cached.py

test-rust:
	@$(STEP) rust tests/run-rust --workspace
	@$(STEP) doctest cargo test --doc --workspace

# The core's own tests, and sessions drawn by generators that share nothing with it. One after the other, as what is above runs
# at the same time: on two cores neither waits for the other.
test-core:
	@$(MAKE) --no-print-directory test-rust
	@$(MAKE) --no-print-directory test-vectors
	@$(MAKE) --no-print-directory test-blind
	@$(MAKE) --no-print-directory test-hidden

# All that stands on the core, and the builds for phones.
test-above:
	@$(MAKE) --no-print-directory test-faces
	@$(MAKE) --no-print-directory test-targets

# The expected values themselves, computed anew at 30 digits by code that shares nothing with the core.
test-vectors: blind-tools
	@$(STEP) vectors $(BIN)/python tests/oracles/check_vectors.py

# All that stands on the core.
test-faces:
	@$(MAKE) --no-print-directory test-python
	@$(MAKE) --no-print-directory test-kotlin test-swift
	@$(MAKE) --no-print-directory test-ios
	@$(MAKE) --no-print-directory test-android

# Python's half: vectors, API and command (pytest), the stubs against the module (a test among them), and the fuzz in short.
test-python: package docs-tools
	@$(STEP) python $(BIN)/python -m pytest -c python/pyproject.toml python/tests tests/fuzz

# The Swift that is committed is what the facade gives.
generated: build
	@$(STEP) generated bindings/check-generated

# What Python gives, for the other faces to be held against; Rust at once.
faces: package
	@$(STEP) faces $(BIN)/python tests/faces/write_results.py build/faces
	@$(STEP) faces-rust tests/faces/check-rust build/faces

# Kotlin's tests on the JVM, the shared vectors bit by bit as Python's.
test-kotlin: faces
	@$(STEP) kotlin bindings/kotlin/run-tests $(BIN)/python

# The same of Swift. Debian's Swift 6 is unpacked into the user's cache at the first time: half a gigabyte to fetch.
test-swift: generated faces
	@$(STEP) swift bindings/swift/run-tests $(BIN)/python

# The iOS app: texts, plists, formatting, and its names and types against stubs of Apple's frameworks (ios/README.md).
test-ios:
	@$(STEP) ios ios/offline/check

# The library for iPhones, built but never linked, and its code checked for Android. Debian's Rust is unpacked into the user's cache
# at the first time: a quarter of a gigabyte to fetch. Compiled only where something changed (tests/cached.py), as the apps are.
test-targets:
	@$(STEP) targets bindings/check-targets

# The app: compiled without the Android SDK, its screens driven under Robolectric (android/README.md).
test-android: build
	@$(STEP) android android/offline/run test

# Pictures of its screens in build/android/shots.
screenshots: build
	@$(STEP) screenshots android/offline/run shots

generate: build
	rm -rf bindings/swift/Sources/GyradiusFFI bindings/swift/Sources/GyradiusKit/Generated
	bindings/generate swift bindings/swift/Sources

# Sessions drawn afresh by a generator that shares nothing with the analysis, its witness MuJoCo, and the sessions that ship.
test-blind: package blind-tools
	@$(STEP) blind $(BIN)/python -m pytest -q -rA --strict-markers tests/blind

# The generator of hidden effects against closed forms and another integrator, and the critique on a few of its sessions.
test-hidden: package blind-tools
	@$(STEP) hidden $(BIN)/python -m pytest -q -rA --strict-markers tests/hidden

N ?= 200
blind: release-package blind-tools
	@$(BIN)/python tests/blind/coverage.py --count $(N)

# Whole sessions with something wrong in them, the seed drawn and printed; some minutes for 20,000. Failures are kept in tests/fuzz/corpus.
fuzz: N = 20000
fuzz: package
	$(BIN)/python tests/fuzz/sessions.py --count $(N)

# What the planner predicts against what is then measured, on fresh hulls.
plan-check: N = 100
plan-check:
	GYRADIUS_SEED=random GYRADIUS_PLAN_HULLS=$(N) cargo test -p gyradius-planning --test it what_is_predicted -- --nocapture

# The critique on fresh sessions with hidden effects; writes tests/hidden/RESULTS.md.
hidden: release-package blind-tools
	$(BIN)/python tests/hidden/judge.py --count $(N) --report tests/hidden/RESULTS.md

# Other methods beside it; what they need is installed here and nowhere else. Writes tests/hidden/PEERS.md.
peers: N = 20
peers: release-package blind-tools
	@$(BIN)/python -m pip --quiet install -r tests/hidden/peers-requirements.txt
	$(BIN)/python -m pytest -q tests/hidden/test_peers.py
	$(BIN)/python tests/hidden/peers.py --count $(N) --report tests/hidden/PEERS.md

blind-tools: $(BIN)/maturin
	@$(BIN)/python -m pip --quiet install -r tests/requirements.txt

# The schemas of the program's JSON, from its types.
schemas:
	@GYRADIUS_WRITE_SCHEMAS=1 cargo test --workspace --test it committed_schemas

# Which crate uses which, in ARCHITECTURE.md.
graph:
	$(PYTHON) core/docs/graph.py

doc:
	@RUSTDOCFLAGS="-D warnings" $(STEP) doc cargo doc --no-deps --workspace

# The documentation site. What it shows of commands is run while it is built; equations become MathML, and nothing is loaded
# from another host. Its pages, and what it needs, are in python/docs.
docs: package docs-tools
	@NO_MKDOCS_2_WARNING=1 $(STEP) docs $(BIN)/python -m mkdocs build --strict -f python/docs/mkdocs.yml -d $(CURDIR)/build/docs
	@echo "build/docs/index.html"

docs-tools: $(BIN)/maturin
	@$(BIN)/python -m pip --quiet install -r python/docs/requirements.txt

# The core's speed by criterion, then ours beside other methods' on one record, all called from Python.
bench: release-package blind-tools
	CARGO_TARGET_DIR=$(CURDIR)/target cargo bench --manifest-path core/benches/Cargo.toml
	$(BIN)/python tests/bench_peers.py
	$(BIN)/python tests/bench_simulation.py

# What each effect does to a swing: pictures and page in core/docs.
gallery: release-package blind-tools
	$(BIN)/python core/docs/gallery.py

skips:
	@tests/skips $(LOGS) build/skips.txt

# The report as a browser shows it, at desktop and phone width; needs a Chromium on the path.
report-shots: demo
	$(BIN)/python tests/report_shots.py build/demo build/shots

# All that Rust compiles here, once: every other recipe asks cargo for the same selection. Cargo joins the features that its
# packages ask of a library, so that another selection would compile most of them again.
build:
	@$(STEP) build cargo build --quiet --workspace --all-targets

# The package and what its tests need, in a virtual environment at the root, with the module of `build`; what is shown or
# timed takes the release build.
package: $(BIN)/maturin build
	@python/develop $(VENV) $(MODULE)

release-package: $(BIN)/maturin
	@VIRTUAL_ENV=$(VENV) PIP_QUIET=1 $(BIN)/maturin develop --quiet --release --extras test -m python/Cargo.toml

$(BIN)/maturin:
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip --quiet install "maturin>=1.9.4,<2"

clean:
	rm -rf build $(VENV) bindings/kotlin/target
	cargo clean
