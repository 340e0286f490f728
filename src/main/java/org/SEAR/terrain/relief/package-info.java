// SPDX-License-Identifier: Apache-2.0
/**
 * Pictures of the ground from its elevation: slopes, hill shading, colours by elevation and slope. The window drapes
 * such a picture over its terrain; maps show it. Uses {@link org.SEAR.geometry} and its dependencies, no files and no
 * window. Any thread.
 */
package org.SEAR.terrain.relief;
