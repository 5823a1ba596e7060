# The environment on a system that has YADE itself: its own packages (sourced by tools/env).
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
