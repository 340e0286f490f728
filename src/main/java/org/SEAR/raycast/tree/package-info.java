// SPDX-License-Identifier: Apache-2.0
/**
 * Bounding volume hierarchies: construction and ray traversal. Uses no other package of SEAR. Any thread may read
 * a tree while no thread refits it. Builders and traversals belong to one thread.
 */
package org.SEAR.raycast.tree;
