package org.myrobotlab.framework.interfaces;

/** Something that has a type. */
public interface TypeProvider {
    /** Its type without package. */
    String getSimpleName();
}
