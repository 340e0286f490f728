// SPDX-License-Identifier: Apache-2.0
/**
 * Bounding volume hierarchies: construction, traversal by rays and boxes. Uses {@link org.SEAR.geometry}. Any thread
 * may read a tree while no thread refits it. Builders and traversals belong to one thread.
 */
package org.SEAR.raycast.tree;
