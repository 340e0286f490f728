// SPDX-License-Identifier: Apache-2.0
/**
 * The Firmata protocol 2.5 for firmware and drivers: messages, their reader, pin modes, and the features for echoes and
 * encoders. Uses no other package of SEAR. Any thread. Numbers of 14 bits are two bytes of seven, low one first.
 * Source: protocol.md, servos.md and encoder.md of firmata/protocol.
 */
package org.SEAR.protocol.firmata;
