// SPDX-License-Identifier: Apache-2.0
/**
 * The interface between the SEAR service and its parts, and the form of a published reading. Each package below holds
 * one part and may use this package and {@link org.SEAR.simulator} with its subpackages. Uses no other package of SEAR.
 * Both callers and the simulation thread use these classes; each class names its threads.
 */
package org.myrobotlab.service.sear;
