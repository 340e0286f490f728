// SPDX-License-Identifier: Apache-2.0
package org.SEAR;

/**
 * Category of test classes that {@code ./gradlew test} leaves out unless {@code --tests} selects them: tests that need
 * other programs, a display, a browser or the distribution, that take long, or that compare with the clock (named
 * {@code ...ClockTest}). The packages {@code view}, {@code web} and {@code cli} are left out as a whole.
 */
public interface Slow {
}
