// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.link;

/** A driver that tries other baud rates while its device does not answer, so SEAR warns of no baud rate mismatch. */
public interface FindsBaudRate {
}
