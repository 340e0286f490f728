/**
 * The object grammar: what a script or a file can say about a world, and the tables by which that is read, checked and documented. Uses nothing
 * else of SEAR; finds its store by {@link java.util.ServiceLoader}. An object belongs to the thread that makes it.
 */
package org.SEAR.POJOs;
