/**
 * The ground in the window: a quadtree of square tiles in levels of detail, chosen by what the eye can tell, one picture over all, and a view into
 * the distance. Uses {@link org.SEAR.terrain.relief}, and what that uses. Window thread only.
 */
package org.SEAR.view.terrain;
