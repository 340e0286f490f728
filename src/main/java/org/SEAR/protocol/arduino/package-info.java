/**
 * Arduino boards as wiring, firmware and drivers know them: which pins there are, what each can do, what a wire is for. Uses no other package of
 * SEAR. Any thread. Source: the pin tables of the Arduino core and the data sheets of the ATmega328P and ATmega2560.
 */
package org.SEAR.protocol.arduino;
