// SPDX-License-Identifier: Apache-2.0
/**
 * Episodes for machine learning: one world that restarts repeatedly, stepped by the calling thread, with observations
 * as numbers and its plan as a picture. Uses {@link org.SEAR.plan} and its packages in turn. No threads of its own; one
 * thread at a time.
 */
package org.SEAR.learning;
