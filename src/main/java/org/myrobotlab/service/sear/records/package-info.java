// SPDX-License-Identifier: Apache-2.0
/**
 * Records of runs for scripts and panels: starting and ending them, their contents, reruns and plots; plans of worlds.
 * Uses {@link org.SEAR.plan}, {@link org.SEAR.record} and {@link org.myrobotlab.service.sear.readings}, and what these
 * use. Any thread.
 */
package org.myrobotlab.service.sear.records;
