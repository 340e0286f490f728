// SPDX-License-Identifier: Apache-2.0
/**
 * Ground in the window: a quadtree of square tiles with levels of detail chosen by visible error, one picture over the
 * whole area, and a far view. Uses {@link org.SEAR.terrain.relief} and its dependencies. Window thread only.
 */
package org.SEAR.view.terrain;
