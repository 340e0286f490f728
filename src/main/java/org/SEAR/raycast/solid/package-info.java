/**
 * Where one beam meets one convex solid or one triangle, in closed form: a class for each kind. Knows nothing but the JDK. Immutable, for any thread; nothing here
 * allocates.
 */
package org.SEAR.raycast.solid;
