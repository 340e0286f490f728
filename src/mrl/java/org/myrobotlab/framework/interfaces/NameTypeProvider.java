package org.myrobotlab.framework.interfaces;

/** Something that has a name and a type. */
public interface NameTypeProvider extends NameProvider, TypeProvider {
}
