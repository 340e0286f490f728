// SPDX-License-Identifier: Apache-2.0
/**
 * Import of robots in URDF: a strict reader, and a builder that makes SEAR's objects from it. Uses
 * {@link org.SEAR.project.bundle} and its dependencies. One thread.
 */
package org.SEAR.project.urdf;
