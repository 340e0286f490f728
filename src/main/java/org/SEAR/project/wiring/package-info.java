// SPDX-License-Identifier: Apache-2.0
/**
 * Check of the wires between boards and components of robots. Uses {@link org.SEAR.project.xml} and its dependencies.
 * One thread at a time.
 */
package org.SEAR.project.wiring;
