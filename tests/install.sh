#!/usr/bin/env bash
# Installs Debian packages, those that are named, for scripts that need a tool; one caller after another, because apt-get
# refuses a second one. Says nothing, and fails where that cannot be done.
command -v apt-get > /dev/null && command -v flock > /dev/null || exit 1
exec > /dev/null 2>&1 9> "${TMPDIR:-/tmp}/gjk-install.lock" || exit 1
flock 9
apt-get install -y --no-install-recommends "$@" 9>&- && exit 0
apt-get update 9>&- && apt-get install -y --no-install-recommends "$@" 9>&-
