# The environment without a folder of its own: a system that has YADE, or a YADE that the user has built (sourced by tools/env).
# shellcheck shell=bash disable=SC2016,SC2034,SC2154

# native_ready SET...: this system's YADE and its own packages; what is missing is installed. Commands then need nothing to enter.
native_ready() {
  local packages
  mapfile -t packages < <(packages_of "$@")
  install_packages "installing packages of this system with their dependencies (1-3 minutes)" "${packages[@]}"
  environment=native-$(dpkg-query -W -f '${Version}' yade)
  enter=()
  yadeVersion=$(dpkg-query -W -f '${source:Version}' yade)
  headers=${YADE_SOURCE:-}
  [ -n "$headers" ] || fetch_headers machine "$yadeVersion"
}

# own_ready SET...: the YADE named by YADE_EXECUTABLE, with its source tree YADE_SOURCE. The user's shell stays as it is (modules of a cluster, say).
# Where there is dpkg, what else is needed is installed; elsewhere CMake tells what it does not find.
own_ready() {
  local packages
  executable=$(realpath -e -- "$YADE_EXECUTABLE" 2>/dev/null) && [ -x "$executable" ] ||
    die "YADE_EXECUTABLE=$YADE_EXECUTABLE is not a program. It must be the yade that is to be used, such as PREFIX/bin/yade."
  headers=${YADE_SOURCE:-}
  [ -n "$headers" ] || die "YADE_EXECUTABLE=$YADE_EXECUTABLE needs YADE_SOURCE, the source tree that this YADE was built from."
  if command -v dpkg-query >/dev/null; then
    mapfile -t packages < <(packages_of "$@" | grep -vx yade)
    install_packages "installing packages of this system for the YADE of your own (1-3 minutes)" "${packages[@]}"
  fi
  enter=()
  # A YADE that was installed anew in the same place is another one.
  yadeVersion=$(stat -L -c %Y "$executable")
  environment=own-$executable
}
