// SPDX-License-Identifier: Apache-2.0
/**
 * Saving, loading, listing and importing projects, and transferring them to and from a browser. Uses
 * {@link org.SEAR.plan}, {@link org.SEAR.project.edit}, {@link org.SEAR.project.script},
 * {@link org.SEAR.project.urdf} and {@link org.myrobotlab.service.sear.run}, and what these use. Any thread; one call
 * at a time.
 */
package org.myrobotlab.service.sear.files;
