/**
 * The objects that a script or a file can say a world with. May use {@link org.SEAR.grammar}, {@link org.SEAR.protocol.lidar} and
 * {@link org.SEAR.protocol.arduino}; finds its store by {@link java.util.ServiceLoader}. An object belongs to the thread that makes it.
 */
package org.SEAR.POJOs;
