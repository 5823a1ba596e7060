# The commands of the project. Each sets up and builds first whatever it needs (see tools/env --help).
.PHONY: help demo study study-quick test test-fast test-yades test-own-yade lint tidy ci fuzz sanitize bench bench-quick bench-scaling docs deb deb-test build shell clean

# The demonstration's arguments, here and nowhere else (its defaults are the paper's). One that was stopped is taken up again.
demoArguments = --output demo

help:
	@echo 'make demo    a bed of cubes cushions a blow: results and pictures in demo/'
	@echo 'make study   the 44 beds of the paper, several of each, with confidence intervals: results/study (hours; goes on where it was stopped)'
	@echo 'make study-quick   three points a figure, one bed each: results/study-quick (12 minutes on 2 cores)'
	@echo 'make test    all tests; the last line counts them'
	@echo 'make test-fast   the tests that take seconds: the C++ unit tests, and what of Python needs no YADE'
	@echo 'make test-yades  all tests on YADE 2025.2 (Debian trixie) and on YADE 2026.1 (Debian forky)'
	@echo 'make test-own-yade   the plugin for a YADE that was built from source, for which the installed one is disguised (5 minutes)'
	@echo 'make lint    ruff, mypy, clang-format, shellcheck; make tidy: clang-tidy (takes long); make ci: what the continuous integration runs, lint and test'
	@echo 'make fuzz    many more examples of the fuzz tests: FUZZ_EXAMPLES=2000 for each (20 minutes)'
	@echo 'make sanitize   all tests with the sanitizers of addresses and undefined behaviour (see docs/testing.md)'
	@echo 'make bench   all benchmarks (make bench-quick: the main ones): tables in results/bench, see docs/benchmarks.md'
	@echo 'make bench-scaling   10^3 to 10^5 bodies on threads and processes: time, memory, agreement (30 minutes), see docs/scaling.md'
	@echo 'make docs    the documentation as a site: results/docs/index.html'
	@echo 'make deb     a package for exactly the YADE of this Debian: results/deb'
	@echo 'make deb-test   that package in a clean Debian: installed, a small demo run, removed (5 minutes)'
	@echo 'make build   the plugin and the C++ tests, without running anything'
	@echo 'make shell   the console of YADE with the plugin (the 3D view where there is a display)'
	@echo 'make clean   remove the results of the demo and the build directories of this project'
	@echo
	@echo 'Any other command with the plugin: tools/env COMMAND, e.g. tools/env yade script.py'

demo:
	@tools/env --with view yade -n -x scripts/impact.py $(demoArguments) $(if $(wildcard demo/checkpoint.json),--resume)

# The paper's figures, then what depends on the choices that the paper leaves open. A study of your own: see docs/study.md.
study:
	@tools/env --with study python3 scripts/study.py scripts/study/paper.yaml --output results/study
	@tools/env --with study python3 scripts/study.py scripts/study/sensitivity.yaml --output results/sensitivity

study-quick:
	@tools/env --with study python3 scripts/study.py scripts/study/quick.yaml --output results/study-quick

# The packages that tests need beside the base list (tools/packages).
testPackages = --with study --with fem --with view

test:
	@tools/env $(testPackages) --target all true || { echo '0 passed, 1 failed'; exit 1; }
	@tools/env $(testPackages) tests/run

test-fast:
	@tools/env $(testPackages) --only unit_tests tests/run --fast

# The checkers are those of Debian 13 wherever they are started, so that they judge alike.
lint:
	@tools/ruff check; ruff=$$?; YADE_SUITE=trixie tools/env $(testPackages) --with lint --only build.ninja tests/lint && exit $$ruff

tidy:
	@YADE_SUITE=trixie tools/env $(testPackages) --with lint --only build.ninja tests/tidy

ci: testPackages += --with lint
ci: lint test

# On every YADE that the plugin is for, each that of a release of Debian: natively where this system is that release, else in a folder.
test-yades:
	@failed=; for suite in trixie forky; do echo "YADE of Debian $$suite"; YADE_SUITE=$$suite $(MAKE) --no-print-directory test || failed="$$failed $$suite"; done; \
	  [ -z "$$failed" ] || { echo "failed on$$failed"; exit 1; }

# The installed YADE disguised as one that was built from source; the plugin is built for it (5 minutes).
test-own-yade:
	@tools/env yade -n -x tests/run_pytest.py tests/package/own_yade.py -q -p no:cacheprovider

fuzz: export FUZZ_EXAMPLES ?= 2000
fuzz: export TEST_TIME_LIMIT = 86400
fuzz:
	@tools/env $(testPackages) tests/run tests/fuzz

sanitize: export SANITIZE = address,undefined
sanitize: export TEST_TIME_LIMIT = 7200
sanitize:
	@tools/env $(testPackages) --target unit_tests --target oracle_tests tests/sanitize

bench:
	@tools/env --with bench --target kernel_bench tests/bench/run

bench-quick:
	@tools/env --with bench --target kernel_bench tests/bench/run --quick

bench-scaling:
	@tools/env --with bench tests/bench/scaling

docs:
	@tools/env --with docs docs/site/build

deb:
	@tools/env --with deb tools/package

deb-test: deb
	@tests/package/run

build:
	@tools/env --target all true

shell:
	@tools/env yade

clean:
	@tools/env --remove
	rm -rf demo
