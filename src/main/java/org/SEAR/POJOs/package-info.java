/**
 * The objects that a script or a file can say a world with. Uses {@link org.SEAR.grammar} and {@link org.SEAR.protocol.arduino}, and what these use.
 * Its objects find their store by {@link java.util.ServiceLoader}, and each service has a {@link
 * org.SEAR.POJOs.ScriptSession} where they are made. An
 * object belongs to the thread that makes it.
 */
package org.SEAR.POJOs;
