package org.SEAR.POJOs;

import java.util.Collection;

/**
 * More classes of the grammar, beside those of this package. Found by {@link java.util.ServiceLoader}; rooms above implement it, so that
 * registering a sensor or a device also makes its parameter class readable.
 */
public interface ObjectTypes {
    /** The classes; each has a constructor without arguments (it may be private) and its own simple name. */
    Collection<Class<? extends SearObject>> types();
}
