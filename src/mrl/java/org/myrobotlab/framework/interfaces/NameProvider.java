package org.myrobotlab.framework.interfaces;

/** Something that has a name. */
public interface NameProvider {
    /** Its short name, without the id of the process. */
    String getName();
}
