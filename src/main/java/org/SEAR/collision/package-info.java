/**
 * Where two convex shapes touch: distance (GJK), depth (EPA), hulls and the contact points between features. Uses {@link org.SEAR.geometry}, and
 * what that uses. It knows no physics engine. One thread for each instance.
 */
package org.SEAR.collision;
