// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.util.Collection;

/**
 * Additional classes of the grammar from other packages. {@link java.util.ServiceLoader} finds the implementations, so
 * a package that registers a sensor or device also makes its parameter class readable.
 */
public interface ObjectTypes {
    /** Returns the classes. Each has a constructor without arguments (it may be private) and a unique simple name. */
    Collection<Class<? extends SearObject>> types();
}
