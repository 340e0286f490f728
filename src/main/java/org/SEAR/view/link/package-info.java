// SPDX-License-Identifier: Apache-2.0
/**
 * The window's link to the simulation: states and commands. Uses {@link org.SEAR.scene} and its dependencies. Called on
 * the window's thread; returned objects are immutable.
 */
package org.SEAR.view.link;
