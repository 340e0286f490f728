// SPDX-License-Identifier: Apache-2.0
/**
 * Measurements for lesson checks: where robots were and what they touched, from rerunning a record's commands. Uses
 * {@link org.SEAR.record} and its packages in turn. No threads of its own; one thread at a time.
 */
package org.SEAR.lessons;
