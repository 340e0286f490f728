package org.SEAR;

/**
 * The category of test classes that {@code ./gradlew unitTest} leaves out: those that need other programs, a display, a browser or the distribution,
 * that take long, or that compare with the clock (they are called {@code ...ClockTest}). The packages {@code view}, {@code web} and {@code cli} are
 * left out as a whole.
 */
public interface Slow {
}
