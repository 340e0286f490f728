// SPDX-License-Identifier: Apache-2.0
/**
 * Strict readers and checks of the formats of models. Each error names the file, the place in it, the value and the
 * legal range. Memory and time are bounded by {@link org.SEAR.project.models.format.ModelLimits}.
 * Uses {@link org.SEAR.files}.
 */
package org.SEAR.project.models.format;
