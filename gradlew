#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# SEAR's own start script of Gradle, not the Gradle Wrapper: it builds with the Gradle on the PATH and downloads none.
# If programs are missing, it prints them, and installs them with apt-get on Debian or Ubuntu, as root or with
# password-free sudo: Gradle and a JDK; for check, build and allTests also a virtual display, a browser and third-party
# drivers. SEAR_INSTALL=no installs nothing. Ends a test run with the line "N passed, N failed, N skipped".
cd "$(dirname "$0")" || exit 1

# Pages are tested in Debian's headless Chromium; Ubuntu has only the full one.
browser=chromium-headless-shell
grep -qs '^ID=ubuntu' /etc/os-release && browser=chromium

needed="javac:default-jdk-headless gradle:gradle"
case " $* " in
    *" allTests "*|*" check "*|*" build "*)
        needed="$needed Xvfb:xvfb xdotool:xdotool $browser:$browser chromedriver:chromium-driver gpsd:gpsd gpspipe:gpsd-clients rawlog-grabber:mrpt-apps"
        needed="$needed python3:python3 pip3:python3-pip cc:gcc" ;;
esac
case " $* " in
    *" realMrlTest "*) needed="$needed chromium:chromium chromedriver:chromium-driver" ;;
esac
case " $* " in *" check "*|*" build "*|*" allTests "*|*" eslint "*) needed="$needed npm:npm node:nodejs" ;; esac
case " $* " in *" tryOnWindows "*) needed="$needed wine:wine python3:python3 pip3:python3-pip" ;; esac

missing=
for pair in $needed; do
    PATH="$PATH:/usr/sbin:/sbin" command -v "${pair%%:*}" >/dev/null 2>&1 || missing="$missing ${pair#*:}"
done
case "$missing" in *xvfb*) missing="$missing libgl1-mesa-dri libgl1 libegl1 libxrandr2 libxcursor1 libxi6 libxxf86vm1 libxinerama1" ;; esac
case "$missing" in *" gcc"*) missing="$missing libc6-dev" ;; esac
case "$missing" in *" wine"*) missing="$missing wine64" ;; esac

can_install() { [ "${SEAR_INSTALL:-}" != no ] && command -v apt-get >/dev/null 2>&1 && { [ "$(id -u)" = 0 ] || sudo -n true 2>/dev/null; }; }
as_root() { if [ "$(id -u)" = 0 ]; then "$@"; else sudo -n "$@"; fi; }

# Waits up to ten minutes while another program uses apt, such as the update of a fresh Ubuntu. apt itself waits for only one of its locks.
apt() {
    patience=120
    until as_root env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=600 "$@" >"$log" 2>&1; do
        grep -qi "could not get lock" "$log" && [ $patience -gt 0 ] || return 1
        [ $patience = 120 ] && echo "gradlew: another program is installing or updating packages; waiting for up to ten minutes"
        patience=$((patience - 1))
        sleep 5
    done
}

if [ -n "$missing" ]; then
    if ! can_install; then
        echo "gradlew: these are missing, install them and call again (on Debian: sudo apt-get install$missing)" >&2
        exit 1
    fi
    echo "gradlew: installing with apt-get, once (SEAR_INSTALL=no prevents it):$missing"
    log=$(mktemp)
    if apt update && apt install -y --no-install-recommends $missing; then
        rm -f "$log"
    else
        cat "$log"; echo "gradlew: could not install$missing" >&2; exit 1
    fi
fi

tests=
case " $* " in *" test "*|*" unitTest "*|*" allTests "*|*" realMrlTest "*|*" check "*|*" build "*) tests=yes; rm -f build/test-summary.txt ;; esac
# Without a locale, as in a bare container, Java can't write a file with an umlaut in its name.
case ${LC_ALL:-${LC_CTYPE:-${LANG:-}}} in "" | C | POSIX) LC_ALL=C.UTF-8; export LC_ALL ;; esac
# The optimizing compiler does not pay off in a build: without it javac, Gradle and other code in this JVM need half the processor time.
GRADLE_OPTS="-XX:TieredStopAtLevel=1 -XX:+UseSerialGC ${GRADLE_OPTS:-}"; export GRADLE_OPTS
[ -t 0 ] && SEAR_TERMINAL=1 && export SEAR_TERMINAL
# Debian's start script of Gradle tries its options on a JVM that prints three lines. SEAR's Javas all have these options.
launcher=$(echo /usr/share/gradle/lib/gradle-launcher-*.jar)
if [ "$(command -v gradle)" = /usr/bin/gradle ] && [ -f "$launcher" ]; then
    ulimit -n "$(ulimit -H -n)"
    java=java
    [ -z "${JAVA_HOME:-}" ] || java=$JAVA_HOME/bin/java
    # eval, since options may contain quotes
    eval '"$java" --add-opens java.base/java.lang=ALL-UNNAMED' "${JAVA_OPTS:-} $GRADLE_OPTS" \
        '-Dorg.gradle.appname=gradle -classpath "$launcher" org.gradle.launcher.GradleMain "$@"'
else
    gradle "$@"
fi
status=$?
[ -n "$tests" ] && cat build/test-summary.txt 2>/dev/null
exit $status
