# jounce: set-up, tests, gates. Everything lives in $(VENV); nothing else on the machine is touched.
#
#   make demo      set up and run the shipped campaign        make lint    style, types, import contract
#   make setup     only prepare .venv                         make bench   times against peers
#   make test      set up and run the tests                   make docs    the documentation, as HTML
#   make quick     the tests that answer at once              make clean   remove what was made here
#   make test-pages  what the documentation says is run, pages are opened in three browsers
#   make test-machines  the tests on every Python, the lowest and newest packages, other processors: hours
#   make bench-web  how fast the workbench answers, in Chromium
#   make screens    pictures of the workbench for the documentation, in Chromium
#   make test-faults  let operations on files of every writer go wrong, one by one: FAULTS="--most 8" tries fewer
#   make test-all  the slow tests too                         make format  what `make lint` can mend by itself
#   make mutants   change a package in one place at a time: do its tests notice? PACKAGE=ride SAMPLE=200 SEED=1
#   make loops     machine code of the loops, which `make setup` makes, too: again where their sources have changed
#   make check-docs  opens the built documentation on a phone's width and asks its search (needs Chromium)
#   make links     do the addresses outside of the documentation answer? (needs a network)
#   make viewer    bundle the viewer of reports from viewer/ (needs node and npm)
#   make check-viewer  is the committed bundle what its sources make? (skipped without node and npm)
#   make validation  what tests find against sources outside of jounce, written for the page that says it
#   make faces     write stubs, JSON schemas and the quantities of pages from the registries
#   make figures   print how large, dense and plain the code is; PACKAGE=ride for one package
#   make pins      compile requirements/*.txt again (needs uv)
#   make audit     known vulnerabilities of what is pinned; where no service can be reached, those of a list
#
# Another interpreter or folder: make test PYTHON=python3.13 VENV=.venv-3.13

PYTHON ?= python3
VENV ?= .venv
UV ?= uv
DEMO_ARGUMENTS ?=
SAMPLE ?= 200
SEED ?= 1
PLACE ?=
MINUTES ?= inf
MACHINES ?=
FAULTS ?=
BIN := $(VENV)/$(if $(filter Windows_NT,$(OS)),Scripts,bin)

# The pins are complete, so pip resolves nothing; wheels only, so that no unpinned build tool is fetched.
INSTALL := $(BIN)/python -m pip install --quiet --disable-pip-version-check --require-hashes --no-deps --only-binary :all:
LOOPS := $(wildcard src/jounce/kernel/*.py src/jounce/kernel/*/*.py)
PINS := runtime build test lint docs bench mutants machines audit
COMPILE := $(UV) pip compile --quiet --universal --python-version 3.11 --generate-hashes --no-header \
           --no-emit-index-url --no-emit-find-links --no-emit-package yattag  # it has no wheel, and only draws what we do not

.PHONY: help setup loops demo quick test test-pages test-faults test-all test-machines axe bench-web lint check-style check-typescript check-imports format bench docs check-docs links mutants faces pins audit clean viewer check-viewer validation screens figures
.DELETE_ON_ERROR:

help:
	@sed -n '2,/^$$/s/^# \{0,1\}//p' Makefile

setup: $(VENV)/.loops

loops: $(VENV)/.loops

demo: setup
	$(BIN)/jounce demo $(DEMO_ARGUMENTS)

# Dozens of processes read the same modules: what Python makes of them is kept, even where the environment forbids it.
quick test test-pages test-all: export PYTHONDONTWRITEBYTECODE :=

quick: $(VENV)/.test $(VENV)/.loops
	$(BIN)/python -m pytest -n auto --dist loadfile --quick

test: $(VENV)/.test $(VENV)/.loops
	$(BIN)/python -m pytest -n auto --dist loadfile

test-pages: $(VENV)/.test $(VENV)/.loops axe
	$(BIN)/python -m pytest -n auto --dist loadfile -m "(pages or examples) and not slow"

# Linux on x86-64, with a C compiler.
test-faults: $(VENV)/.test $(VENV)/.loops
	$(BIN)/python tests/hostile/faults/run.py $(FAULTS)

test-all: $(VENV)/.test $(VENV)/.loops axe
	$(BIN)/python -m pytest -n auto --dist loadfile -m "slow or not slow"

# Others' interpreters and packages; a part of it: make test-machines MACHINES="--quick" or MACHINES="lowest python-3.13"
test-machines: $(VENV)/.test $(VENV)/.loops $(VENV)/.machines
	$(BIN)/python tests/machines/run.py $(MACHINES)

# What looks at pages as assistive technology does comes with the packages of viewer/; tests that need it are skipped without.
axe:
	@command -v npm >/dev/null && $(MAKE) --no-print-directory viewer/node_modules/.package-lock.json || echo "Without node and npm: axe looks at no page"

lint: check-style check-imports check-typescript
	$(BIN)/mypy

check-style: $(VENV)/.lint
	$(BIN)/ruff check
	$(BIN)/ruff format --check

# TypeScript is checked where node is; without it, .ci/run says so and goes on.
check-typescript:
	@if ! command -v npm >/dev/null; then echo "TypeScript is not checked: npm is missing"; \
	elif ! $(MAKE) --no-print-directory viewer/node_modules/.package-lock.json; then \
	  echo "TypeScript is not checked: its packages could not be fetched"; \
	else cd viewer && npm run --silent types && npm run --silent lint; fi

check-imports: $(VENV)/.lint
	$(BIN)/lint-imports --no-logo

format: $(VENV)/.lint
	$(BIN)/ruff check --fix
	$(BIN)/ruff format
	@if [ -d viewer/node_modules ]; then cd viewer && npm run --silent format; fi

bench-web: $(VENV)/.test $(VENV)/.loops
	$(BIN)/python benchmarks/workbench.py

bench: $(VENV)/.bench $(VENV)/.loops
	$(BIN)/python benchmarks/run.py

docs: $(VENV)/.docs $(VENV)/.loops
	$(BIN)/python -m sphinx -W --keep-going -b html -d docs/_build/doctrees docs docs/_build/html
	$(BIN)/python docs/check_site.py docs/_build/html
	@echo "docs/_build/html/index.html"

# The built pages in a browser: on a phone, without a network, and asked what readers ask.
check-docs: docs $(VENV)/.test
	$(BIN)/python docs/check_site.py docs/_build/html --browser

# No gate: what others take from the web breaks no build of ours, and much refuses programs that ask.
links: $(VENV)/.docs $(VENV)/.loops
	$(BIN)/python -m sphinx -q -b linkcheck -d docs/_build/doctrees docs docs/_build/links

mutants: $(VENV)/.test $(VENV)/.mutants $(VENV)/.loops
	$(BIN)/python tests/mutants/run.py $(PACKAGE) --sample $(SAMPLE) --seed $(SEED) --place "$(PLACE)" --minutes $(MINUTES)

viewer: viewer/node_modules/.package-lock.json
	cd viewer && npm run --silent types && node build.mjs

check-viewer:
	@if ! command -v node >/dev/null || ! command -v npm >/dev/null; then \
	  echo "The bundle of the viewer is not checked: node or npm is missing"; \
	elif ! $(MAKE) --no-print-directory viewer/node_modules/.package-lock.json; then \
	  echo "The bundle of the viewer is not checked: its packages could not be fetched"; \
	else cd viewer && \
	  made=$$(mktemp -d) && node build.mjs "$$made" && diff -rq "$$made/viewer" ../src/jounce/report/viewer && \
	  diff -rq "$$made/static" ../src/jounce/web/static && rm -r "$$made"; fi

viewer/node_modules/.package-lock.json: viewer/package-lock.json
	cd viewer && npm ci --silent --no-fund --no-audit

faces: $(VENV)/.loops
	$(BIN)/python docs/make_faces.py

validation: $(VENV)/.test $(VENV)/.loops
	$(BIN)/python -m pytest -m "source and not no_source and not slow" --evidence

figures:
	$(PYTHON) tests/house/figures.py $(PACKAGE)

screens: $(VENV)/.test $(VENV)/.loops
	$(BIN)/python docs/make_screens.py

$(VENV)/.created:
	@command -v $(PYTHON) >/dev/null || { echo "$(PYTHON) was not found: install Python 3.11 or later, or give PYTHON=..."; exit 1; }
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { \
	  echo "jounce needs Python 3.11 or later; this is $$($(PYTHON) --version 2>&1). Give another one: make PYTHON=python3.11"; exit 1; }
	@$(PYTHON) -c 'import ensurepip, venv' 2>/dev/null || { \
	  echo "$(PYTHON) cannot make virtual environments. On Debian and Ubuntu: apt-get install python3-venv"; exit 1; }
	$(PYTHON) -m venv --clear $(VENV)
	@touch $@

# The build tools come first: jounce itself is built with them, so nothing unpinned is fetched.
$(VENV)/.runtime: $(VENV)/.created requirements/runtime.txt requirements/build.txt pyproject.toml
	$(INSTALL) -r requirements/runtime.txt -r requirements/build.txt
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --no-deps --no-build-isolation --editable .
	@touch $@

# A run calls its loops by name; what they are made of is compiled here, once for all runs.
$(VENV)/.loops: $(VENV)/.runtime $(LOOPS)
	$(BIN)/python -m jounce.kernel.loops.make
	@touch $@

$(VENV)/.test $(VENV)/.lint $(VENV)/.docs $(VENV)/.bench $(VENV)/.mutants $(VENV)/.machines: $(VENV)/.%: requirements/%.txt $(VENV)/.runtime
	$(INSTALL) -r $<
	@touch $@

# Each list is compiled with the ones before it as constraints, so that they agree.
pins:
	@set -e; known=""; for name in $(PINS); do \
	  source="--group $$name"; [ $$name = runtime ] && source="pyproject.toml --extra pdf --extra store --extra web"; \
	  echo "requirements/$$name.txt"; $(COMPILE) $$source $$known -o requirements/$$name.txt >/dev/null; \
	  known="$$known -c requirements/$$name.txt"; done

# In an environment of its own, with pip-audit where that can be had: a closed network is said, and is no failure.
audit: $(VENV)/.created
	@$(PYTHON) -m venv --clear $(VENV)-audit
	@$(subst $(VENV)/,$(VENV)-audit/,$(INSTALL)) -r requirements/audit.txt || echo "pip-audit cannot be installed here"
	$(BIN)/python requirements/audit.py $(subst $(VENV)/,$(VENV)-audit/,$(BIN))/python

clean:
	rm -rf .venv .venv-* build dist src/jounce/kernel/loops/built docs/_build docs/reference/api docs/reference/keys docs/_generated .coverage .hypothesis .import_linter_cache .mypy_cache .pytest_cache .ruff_cache
	find src tests -name __pycache__ -type d -prune -exec rm -rf {} +
