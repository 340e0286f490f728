// SPDX-License-Identifier: Apache-2.0
/**
 * Ray casting: shapes and triangle meshes in hierarchies, and casts of single rays, fans, bundles and pictures. Uses
 * {@link org.SEAR.raycast.solid} and its dependencies. The simulation thread builds and moves shapes. Between two
 * commits any number of threads may cast.
 */
package org.SEAR.raycast;
