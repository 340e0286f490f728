package org.SEAR.grammar;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Makes a field a parameter of the object grammar. This one line is the source of its XML element (named like the field), its validation, its
 * reading and writing, its row in {@code docs/objects.md}, in {@code sear sensors} and in the tabs. The default is the field's initial value.
 *
 * <p>A field may be a double, an int, a Double, Integer or Boolean (null where nothing is set), a boolean, a String, a class whose fields are
 * parameters in turn, or a {@code List} of one of those.
 */
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.FIELD)
public @interface Param {
    /** What it means, one sentence without a full stop. */
    String doc();

    /** Unit of the value; empty for a plain number or a text. */
    String unit() default "";

    /** Smallest legal number. */
    double min() default 0;

    /** Whether 0 is legal, too, where the smallest number is above it. */
    boolean orZero() default false;

    /** Largest legal number. */
    double max() default 1e6;

    /** The only legal texts or whole numbers; empty if any that fits the rest is. */
    String[] values() default {};

    /** What each of the values means, in a word, for who chooses one; empty where the values say it themselves. */
    String[] words() default {};

    /** The value of an object that is made with nothing but its name, as by the mouse, where the default can't be meant; empty for none. */
    String initial() default "";

    /** What a text has to look like. */
    TextRule text() default TextRule.ANY;

    /** Whether a file without this element is incomplete. */
    boolean required() default false;

    /** XML element, if it isn't named like the field (an entry of a list). */
    String element() default "";

    /**
     * Of what kind the thing of the same robot is whose name this text is, so that it follows when that gets another name, and goes when that is
     * deleted; void for no such text.
     */
    Class<?> names() default void.class;

    /** Whether what has such names is good for nothing without any, so that it is deleted with the last thing that it names. */
    boolean needed() default false;

    /** Most entries of a list. */
    int maxEntries() default 1;
}
