/** Draws the textures, icons and the tree that come with SEAR, when it is built. Uses nothing else of SEAR. The main thread. */
package org.SEAR.assets;
