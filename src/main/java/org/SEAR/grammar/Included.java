package org.SEAR.grammar;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Makes the parameters of a field's class parameters of the object itself, in the field's place, for parameters that several classes share. The
 * field is never null, and its class has a {@link Param} at each parameter.
 */
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.FIELD)
public @interface Included {
}
