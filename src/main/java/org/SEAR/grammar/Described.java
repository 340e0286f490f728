// SPDX-License-Identifier: Apache-2.0
package org.SEAR.grammar;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Description of a class of the grammar: one sentence without a full stop, for {@code docs/objects.md} and
 * {@code sear sensors}.
 */
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.TYPE)
public @interface Described {
    String value();
}
