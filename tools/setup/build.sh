# The plugin's build, outside the checkout (sourced by tools/env; the compiler runs in the environment).
# shellcheck shell=bash disable=SC2154

# jobs: one per core, but no more than fit into memory (a file with YADE's headers takes about 1.5 GB).
jobs() {
  local cores memory
  cores=$(nproc)
  memory=$(awk '/MemAvailable/ {print int($2 / 1500000)}' /proc/meminfo)
  [ "$memory" -ge 1 ] || memory=1
  [ "$memory" -lt "$cores" ] && echo "$memory" || echo "$cores"
}

# configure_build: CMake's own work, once for a build directory.
configure_build() {
  say "building the plugin in $build (about 3 minutes the first time, then only what has changed)"
  "${enter[@]}" env YADE_SOURCE="$headers" cmake -S "$project" -B "$build" -G Ninja --log-level=WARNING -DSANITIZE="${SANITIZE:-}" \
    -DONE_UNIT="$oneUnit" >&2 ||
    { rm -f "$build/build.ninja"; die "the build could not be configured: see CMake's messages above."; }
}

# build_plugin TARGET...: configure where needed and build. Ninja's report of nothing to do is left out.
build_plugin() {
  local target targets=()
  for target in "$@"; do targets+=(--target "$target"); done
  export CCACHE_DIR=$cache/ccache
  lock "$build.lock"
  [ -f "$build/build.ninja" ] || configure_build
  "${enter[@]}" cmake --build "$build" --parallel "$(jobs)" "${targets[@]}" |
    { grep --line-buffered -v 'Re-checking globbed\|no work to do' >&2 || true; } ||
    die "the build failed: see the compiler's messages above."
  unlock
  # For editors: how each file is compiled, one by one.
  [ ! -w "$project" ] || [ -n "${SANITIZE:-}" ] || ln -sfn "$build/compile_commands.json" "$project/compile_commands.json"
}
