#!/usr/bin/env bash
# Makes (once) and enters a root of another Debian release.
#   root.sh make SUITE ROOT            debootstrap and packages; nothing to do where ROOT has them all
#   root.sh run ROOT PROJECT COMMAND…  COMMAND inside ROOT, with PROJECT mounted at /project
#   root.sh mirror                     where this machine has Debian's packages from
set -euo pipefail

packages=(blender g++ cmake ninja-build libeigen3-dev libglm-dev nlohmann-json3-dev pybind11-dev
          python3-dev python3-pytest python3-numpy xvfb xauth libgl1-mesa-dri libglx-mesa0 libegl1 libegl-mesa0)

mirror_of_host() {
  local mirror
  mirror=$(cat /etc/apt/sources.list /etc/apt/sources.list.d/* 2>/dev/null |
           sed -nE 's#^(URIs:|deb) *(\[[^]]*\] *)?(https?://[^ ]*/debian)/?( .*)?$#\3#p' | head -n 1) || true
  echo "${mirror:-http://deb.debian.org/debian}"
}

lend_network_settings() {
  cp /etc/resolv.conf /etc/hosts "$1/etc/"
  find /etc/apt/apt.conf.d -type f -exec grep -lE '::Proxy|::Ca(Info|Path)' {} + 2>/dev/null |
    xargs -r -I{} cp {} "$1/etc/apt/apt.conf.d/" || true
}

mounted() { mountpoint -q "$1"; }

enter() {
  local root=$1; shift
  mkdir -p "$root/project"
  mounted "$root/proc" || mount -t proc proc "$root/proc"
  mounted "$root/dev" || mount --rbind /dev "$root/dev"
  chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 \
    DEBIAN_FRONTEND=noninteractive "$@"
}

leave() {
  local root=$1
  umount -l "$root/project" "$root/proc" 2>/dev/null || true
  mounted "$root/dev" && { mount --make-rslave "$root/dev"; umount -R -l "$root/dev"; } || true
}

make_root() {
  local suite=$1 root=$2
  [ "$suite" != sid ] || packages+=(python3-cattr python3-requests)   # Blender 5.2's own add-ons import them
  [ "$(cat "$root/.complete" 2>/dev/null)" != "${packages[*]}" ] || return 0
  leave "$root"
  mkdir -p "$root"
  [ -f "$root/.debootstrapped" ] || {
    find "$root" -xdev -mindepth 1 -delete
    debootstrap --variant=minbase "$suite" "$root" "$(mirror_of_host)"
    touch "$root/.debootstrapped"
  }
  lend_network_settings "$root"
  trap "leave '$root'" EXIT
  if [ "$suite" = sid ]; then
    # A mirror may lag behind unstable's short-lived release files.
    echo 'Acquire::Check-Valid-Until "false";' > "$root/etc/apt/apt.conf.d/90stale-mirror"
  fi
  enter "$root" apt-get update
  enter "$root" apt-get install -y --no-install-recommends "${packages[@]}"
  echo "${packages[*]}" > "$root/.complete"
}

run_in_root() {
  local root=$1 project=$2; shift 2
  exec 9>"$root/.lock"
  flock 9                       # whoever leaves unmounts the project
  trap "leave '$root'" EXIT
  leave "$root"                 # a run that was killed left its own project there
  mkdir -p "$root/project"
  mount --bind "$project" "$root/project"
  enter "$root" "$@"
}

verb=$1; shift
case "$verb" in
  make) make_root "$@" ;;
  run) run_in_root "$@" ;;
  mirror) mirror_of_host ;;
  *) echo "root.sh make|run|mirror …" >&2; exit 2 ;;
esac
