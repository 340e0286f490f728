// SPDX-License-Identifier: Apache-2.0
package org.SEAR.grammar;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Makes a field a parameter of the object grammar. This annotation is the source of the XML element (named like the
 * field), of validation, of reading and writing, and of the parameter's row in {@code docs/objects.md}, in
 * {@code sear sensors} and in the tabs. The default is the field's initial value.
 *
 * <p>A field may be a double, an int, a boolean, a Double, Integer or Boolean (null if not set), a String, a class
 * whose fields are parameters in turn, or a {@code List} of one of these.
 */
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.FIELD)
public @interface Param {
    /** Meaning of the parameter, one sentence without a full stop. */
    String doc();

    /** Unit of the value; empty for a plain number or a text. */
    String unit() default "";

    /** Smallest legal number. */
    double min() default 0;

    /** Whether 0 is legal although it is below the smallest legal number. */
    boolean orZero() default false;

    /** Largest legal number. */
    double max() default 1e6;

    /** The only legal texts or whole numbers; empty for no such restriction. */
    String[] values() default {};

    /** One word of explanation for each of the values, for a menu; empty if the values explain themselves. */
    String[] words() default {};

    /**
     * Value of an object that is created with a name only, for example with the mouse, where the default is unsuitable;
     * empty for the default; for a list one entry per line.
     */
    String initial() default "";

    /** Syntax of a text. */
    TextRule text() default TextRule.ANY;

    /** Whether a file without this element is invalid. */
    boolean required() default false;

    /** Name of the XML element if it differs from the field's name (an entry of a list). */
    String element() default "";

    /**
     * Class of the part of the same robot that this text names; void if the text is no such name. The text follows when
     * the part is renamed, and is removed when the part is deleted.
     */
    Class<?> names() default void.class;

    /** Whether the object is useless without any such name: it is deleted with the last part that it names. */
    boolean needed() default false;

    /** Largest number of entries in a list. */
    int maxEntries() default 1;
}
