// SPDX-License-Identifier: Apache-2.0
/**
 * Arduino boards for wiring, firmware and drivers: pins, their functions, and purposes of wires. Uses no other package
 * of SEAR. Any thread. Source: the pin tables of the Arduino core and the data sheets of the ATmega328P and ATmega2560.
 */
package org.SEAR.protocol.arduino;
