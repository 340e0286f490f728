// SPDX-License-Identifier: Apache-2.0
/**
 * The objects of a world, as scripts and files define them. Uses {@link org.SEAR.grammar} and
 * {@link org.SEAR.protocol.arduino} and their dependencies. {@link java.util.ServiceLoader} finds the objects' store;
 * each service has a {@link org.SEAR.POJOs.ScriptSession}. An object belongs to the thread that creates it.
 */
package org.SEAR.POJOs;
