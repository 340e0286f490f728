// SPDX-License-Identifier: Apache-2.0
/**
 * Start poses of bodies: out of each other and on the ground. Uses {@link org.SEAR.physics}. Any thread, before the
 * world starts.
 */
package org.SEAR.physics.start;
