/**
 * Hierarchies of bounding volumes: how they are built, and how a ray is led through one. Uses nothing of SEAR. A tree is read by any thread while
 * nobody refits it; who builds or walks has one of these for a thread.
 */
package org.SEAR.raycast.tree;
