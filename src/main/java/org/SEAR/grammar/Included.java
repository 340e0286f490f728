// SPDX-License-Identifier: Apache-2.0
package org.SEAR.grammar;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Includes the parameters of a field's class among the parameters of the object, at the field's position. Several
 * classes share parameters this way. The field is never null, and each parameter of its class has a {@link Param}.
 */
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.FIELD)
public @interface Included {
}
