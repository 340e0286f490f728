// SPDX-License-Identifier: Apache-2.0
package org.SEAR.grammar;

/** Collects the problems of an object that the legal range of a single parameter does not cover. */
@FunctionalInterface
public interface Faults {
    /**
     * Adds a problem.
     *
     * @param element the parameter to change; {@code wire#2} for an entry of a list, counted from 0
     * @param value the invalid value
     * @param legal the legal values, in words
     */
    void add(String element, Object value, String legal);
}
