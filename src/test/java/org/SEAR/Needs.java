// SPDX-License-Identifier: Apache-2.0
package org.SEAR;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Names the Gradle tasks that a test class needs besides the compiled classes, such as {@code "opencv"}. Gradle runs
 * them before the tests, and only if it runs this class. {@code gradle/tests.gradle} reads the annotation from the
 * source, so the names are literals.
 */
@Target(ElementType.TYPE)
@Retention(RetentionPolicy.SOURCE)
public @interface Needs {
    /** Returns names of tasks in {@code gradle/}. */
    String[] value();
}
