/**
 * Where two convex shapes touch: distance (GJK), depth (EPA), hulls and the contact points between features. May use {@link org.SEAR.geometry}, and
 * knows no physics engine. One thread for each instance.
 */
package org.SEAR.collision;
