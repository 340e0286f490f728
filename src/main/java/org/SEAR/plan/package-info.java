// SPDX-License-Identifier: Apache-2.0
/**
 * The plan of a world from above, as outlines and as a picture. Uses {@link org.SEAR.plot} and {@link org.SEAR.scene}
 * and their packages in turn. No threads of its own.
 */
package org.SEAR.plan;
