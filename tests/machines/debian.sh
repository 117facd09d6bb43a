#!/bin/sh
# Run tests with NumPy and SciPy of a newer Debian, on one of its BLAS: debian.sh blas|blis-serial PYTEST-ARGUMENT...
# The root is made once, in .venv-debian. Ends with 77 where none can be made.
set -eu
if [ "$(id -u)" != 0 ] || ! command -v mmdebstrap >/dev/null; then
  echo "This needs root, and mmdebstrap (Debian: apt-get install mmdebstrap)"
  exit 77
fi
# What is mounted here is seen by nobody else, and gone with this process: `make clean` cannot reach through it.
[ -n "${MOUNTS_OF_OUR_OWN-}" ] || MOUNTS_OF_OUR_OWN=1 exec unshare --mount "$0" "$@"
cd "$(dirname "$0")/../.."
blas=$1 root=$PWD/.venv-debian
shift

inside() { chroot "$root" env -i PATH=/venv/bin:/usr/bin:/bin HOME=/tmp LANG=C.UTF-8 "$@"; }

if [ ! -e "$root/ready" ]; then
  rm -rf "$root"
  packages=python3-numpy,python3-scipy,python3-venv,libblas3,liblapack3,libblis4-serial,gcc,libc6-dev,ca-certificates
  mmdebstrap --quiet --variant=minbase --include="$packages" trixie "$root" || exit 77
  cp -L /etc/resolv.conf "$root/etc/"
  cat /etc/ssl/certs/ca-certificates.crt >"$root/etc/ssl/certs/ca-certificates.crt" # a network may have its own
  inside python3 -m venv --system-site-packages /venv
  sed -nE 's/^([A-Za-z0-9_.-]+==[^\\]+).*/\1/p' requirements/runtime.txt requirements/build.txt requirements/test.txt |
    grep -vE '^(numpy|scipy|playwright)==' >"$root/pins.txt"
  inside python -m pip install --quiet --no-deps --only-binary :all: -r /pins.txt || exit 77
  touch "$root/ready"
fi
mkdir -p "$root/jounce"
mount --bind . "$root/jounce" && mount -t proc proc "$root/proc" || exit 77
inside update-alternatives --quiet --set "libblas.so.3-$(inside gcc -print-multiarch)" "$(inside find /usr/lib -path "*/$blas/libblas.so.3")"
inside sh -c 'cd /jounce && python -m pip install --quiet --no-deps --no-build-isolation --editable . &&
  exec python -m pytest -p no:cacheprovider "$@"' sh "$@"
