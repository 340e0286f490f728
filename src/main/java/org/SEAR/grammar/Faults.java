package org.SEAR.grammar;

/** Takes what is wrong with an object beyond the legal range of a single parameter. */
@FunctionalInterface
public interface Faults {
    /**
     * @param element the parameter to change; {@code wire#2} for an entry of a list, counted from 0
     * @param value what it is
     * @param legal what would be right, in words
     */
    void add(String element, Object value, String legal);
}
