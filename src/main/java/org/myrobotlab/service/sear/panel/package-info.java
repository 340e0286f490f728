// SPDX-License-Identifier: Apache-2.0
/**
 * The world for panels: classes whose fields are the JSON. Uses {@link org.SEAR.record} and
 * {@link org.myrobotlab.service.sear.readings}, and what these use. Simulation thread, or the caller's thread for a
 * world that does not run.
 */
package org.myrobotlab.service.sear.panel;
