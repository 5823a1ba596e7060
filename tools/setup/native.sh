# The environment on a system that has YADE itself: its own packages (sourced by tools/env).
# shellcheck shell=bash disable=SC2016,SC2034,SC2154

# native_ready SET...: install what is missing of the package sets. Commands then need nothing to enter.
native_ready() {
  local missing packages
  mapfile -t packages < <(packages_of "$@")
  mapfile -t missing < <(missing_packages "${packages[@]}")
  if [ "${#missing[@]}" -gt 0 ]; then
    as_root "installing ${#missing[@]} packages of this system with their dependencies (1-3 minutes): ${missing[*]}" \
      "apt-get update && DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends ${missing[*]}"
  fi
  environment=native-$(dpkg-query -W -f '${Version}' yade)
  enter=()
  yadeVersion=$(dpkg-query -W -f '${source:Version}' yade)
  suite=$(machine_suite)
}
