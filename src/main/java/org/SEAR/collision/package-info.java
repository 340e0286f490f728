// SPDX-License-Identifier: Apache-2.0
/**
 * Contacts of two convex shapes: distance (GJK), penetration depth (EPA), convex hulls and contact manifolds.
 * Independent of any physics engine. Uses {@link org.SEAR.geometry}. One thread per instance.
 */
package org.SEAR.collision;
