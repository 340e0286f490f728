// SPDX-License-Identifier: Apache-2.0
/**
 * A simulated AVR microcontroller, the ATmega328P: bytes, pins and clock cycles in and out. It runs a compiled
 * program instruction by instruction. Uses no other package of SEAR. Simulation thread; without threads of its own.
 * Sources: AVR Instruction Set Manual (DS40002198) and data sheet
 * ATmega48A/PA/88A/PA/168A/PA/328/P (DS40002061). Names of registers and bits are those of the data sheet.
 */
package org.SEAR.devices.arduino.avr;
