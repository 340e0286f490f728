// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino.avr;

import java.util.Arrays;

/** The microcontroller of the Arduino Uno, at 16 MHz. */
public final class Atmega328p extends Cpu {
    /** Clock, Hz. */
    public static final double CLOCK = 16e6;
    /** Size of the program memory, bytes. */
    public static final int FLASH_BYTES = 2 * FLASH_WORDS;
    private static final int POWER_ON = 1;
    private static final int EXTERNAL = 2;
    private static final int ERASED = 0xFF;
    private static final int PORT_B = 0;
    private static final int PORT_D = 16;

    private final Ports ports;
    private final Usart usart;
    private final Eeprom eeprom;
    private final Watchdog watchdog;

    /** @param program at most {@link #FLASH_BYTES} bytes from address 0; the rest of the flash is erased */
    public Atmega328p(byte[] program, Surroundings surroundings) {
        super(surroundings);
        for (int i = 0; i < FLASH_WORDS; i++) {
            int low = 2 * i < program.length ? program[2 * i] & ERASED : ERASED;
            int high = 2 * i + 1 < program.length ? program[2 * i + 1] & ERASED : ERASED;
            flash[i] = high << 8 | low;
            code[i] = Instruction.of(flash[i]);
        }
        ports = new Ports(this);
        new Timer(this, ports, 0, 0x44, new int[] {14, 15, 16}, PORT_D + 6, PORT_D + 5);
        new Timer(this, ports, 1, 0x80, new int[] {11, 12, 13}, PORT_B + 1, PORT_B + 2);
        new Timer(this, ports, 2, 0xB0, new int[] {7, 8, 9}, PORT_B + 3, PORT_D + 3);
        usart = new Usart(this);
        new Adc(this);
        new Twi(this);
        new Spi(this);
        eeprom = new Eeprom(this);
        watchdog = new Watchdog(this);
        // GPIOR0 to 2, GTCCR, SMCR, MCUCR, CLKPR, PRR, OSCCAL, DIDR0 and 1, TWAR, TWAMR
        map(new Plain(this), 0x3E, 0x4A, 0x4B, 0x43, 0x53, 0x55, 0x61, 0x64, 0x66, 0x7E, 0x7F, 0xBA, 0xBD);
        eraseEeprom();
        powerOn();
    }

    /** Switches its power on: cleared SRAM, clock at 0; the EEPROM keeps its bytes. */
    public void powerOn() {
        cycle = 0;
        Arrays.fill(data, (byte) 0);
        ports.clearQueue();
        forgetReports();
        watchdog.setCause(POWER_ON);
        restart();
    }

    /** Erases the EEPROM. */
    public void eraseEeprom() {
        eeprom.erase();
    }

    /** Resets it by the reset line. */
    public void reset() {
        watchdog.setCause(EXTERNAL);
        restart();
    }

    /** Executes until a cycle; the last instruction may end up to five cycles later. */
    public void run(long end) {
        runUntil(end);
    }

    /** Cycles since power-on. */
    public long getCycle() {
        return cycle;
    }

    /** Lets the clock run without the CPU, as while the boot loader waits. */
    public void skipTo(long end) {
        cycle = Math.max(cycle, end);
    }

    /** A byte has arrived at the USART. */
    public void receive(int value) {
        usart.receive(value);
    }

    /** Rate of the USART, bits per second; 0 while it is off. */
    public double getBaud() {
        return usart.baud(CLOCK);
    }

    /**
     * Sets the level that the circuit puts on a pin.
     *
     * @param driven whether the circuit drives the pin; a floating pin is high while its pull-up is on
     */
    public void setInput(int port, int bit, boolean high, boolean driven) {
        ports.input(port * 8 + bit, high, driven);
    }

    /** Sets a level at a later cycle. At most 64 changes wait; further ones are lost. */
    public void setInputAt(long at, int port, int bit, boolean high) {
        ports.inputAt(at, port * 8 + bit, high);
    }

    /** Program counter, as a byte address. */
    public int getProgramCounter() {
        return 2 * pc;
    }

    /** Status register. */
    public int getSreg() {
        return alu.sreg;
    }

    /** Byte of the data space without side effects; registers of peripherals give what the program wrote last. */
    public int peek(int address) {
        return data[address] & ERASED;
    }

    @Override
    void watchdogReset() {
        watchdog.restart();
    }
}
